// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace ribbon_mapper::sim {

/// The XML of an SDF file, of a world or of a model.
class SdfFile {
 public:
  /// Parses the file. Throws std::runtime_error, without the file's name, if it is no SDF of
  /// version 1.2 or later.
  explicit SdfFile(const std::string& path);

  /// Returns the file that has `text` as its content.
  static std::unique_ptr<SdfFile> from_text(const char* text, const std::string& path);

  /// Returns the path as given.
  const std::string& path() const { return path_; }
  /// Returns the folder of the file, where relative URIs start.
  const std::string& folder() const { return folder_; }
  /// Returns the version times 100: 106 for 1.6, 110 for 1.10.
  int version() const { return version_; }
  /// Returns true if a pose or a frame refers to the frame `name`.
  bool refers_to(const std::string& name) const { return references_.count(name) > 0; }
  /// Returns the <sdf> element.
  const tinyxml2::XMLElement& root() const { return *xml_.RootElement(); }

 private:
  SdfFile(const std::string& path, const std::function<void(tinyxml2::XMLDocument&)>& load);

  std::string path_, folder_;
  tinyxml2::XMLDocument xml_;
  int version_;
  std::set<std::string> references_;
};

/// A range of numbers that may stand in an element.
struct NumberRange {
  double least;  ///< lower limit
  double most;   ///< upper limit
};

/// A place in the input for messages: a file, and the names of model, link and collision there.
struct SdfScope {
  const std::string& world;  ///< path of the world
  const SdfFile& file;       ///< the world's, or that of a model which it includes
  std::string name;          ///< model::link::collision, as far as known

  /// Returns the scope of a child, whose name is appended.
  SdfScope of(const tinyxml2::XMLElement& child) const;

  /// Throws std::runtime_error with world, file, line and names in front of `message`.
  [[noreturn]] void fail(const tinyxml2::XMLElement& at, const std::string& message) const;

  /// Returns the numbers of an element's text. Throws as fail() unless there are `count`, all of
  /// them within `range`.
  std::vector<double> numbers(const tinyxml2::XMLElement& at, std::size_t count,
                              NumberRange range) const;
};

/// Returns the text of an element without space around it, empty if it has none.
std::string text_of(const tinyxml2::XMLElement& element);

/// Returns a name that libsdformat takes: without "::" and not reserved. An empty one becomes
/// `fallback`.
std::string valid_name(const std::string& name, const std::string& fallback);

/// Returns the valid name of an element, its kind if it has none.
std::string name_of(const tinyxml2::XMLElement& element);

/// Returns `name` with each "::", which separates scopes in libsdformat, replaced by ".".
std::string without_colons(std::string name);

/// Returns a text in quotation marks, cut to a length that can be shown.
std::string quoted(const std::string& text);

/// Calls `visit` with each child element of `parent`.
template <typename Visit>
void for_each_child(const tinyxml2::XMLElement& parent, const Visit& visit) {
  for (const tinyxml2::XMLElement* child = parent.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement())
    visit(*child);
}

}  // namespace ribbon_mapper::sim
