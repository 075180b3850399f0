// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ribbon_mapper {

/// Reads messages whose package is not installed, by means of the definition that every publisher
/// and every bag sends along.
class WireReader {
 public:
  /// Parses a definition as in the connection header: the fields of the message, then those of the
  /// types it uses, each after a line of '=' and "MSG: package/Type". Throws std::invalid_argument
  /// if it cannot be parsed, or if a type is missing or contains itself.
  explicit WireReader(const std::string& definition);

  /// Called with each number of a message and its path without indices, such as
  /// "graph.poses.position.x". Booleans, times and durations (in seconds) are numbers, texts are
  /// not. Fields come in the order of the message.
  using Visitor = std::function<void(const std::string& path, double value)>;

  /// Visits all numbers except those in arrays of bytes. Throws std::invalid_argument if the
  /// message is shorter than its definition requires.
  void read(const std::uint8_t* data, std::size_t size, const Visitor& visit) const;

 private:
  struct Field {
    std::string type, name;
    bool is_array = false;
    std::optional<std::size_t> length;  ///< of an array; nothing: given before its elements
    std::size_t min_bytes = 0;          ///< of one element
  };
  class Cursor;
  void parse_line(std::string line, const std::string& type);
  std::string full_name(const std::string& type, const std::string& user) const;
  std::size_t resolve(const std::string& type, int depth);
  void read_type(const std::string& type, const std::string& path, Cursor& cursor,
                 const Visitor& visit) const;
  void read_field(const Field& field, const std::string& path, Cursor& cursor,
                  const Visitor& visit) const;

  std::map<std::string, std::vector<Field>> types_;  ///< by full name, "": the message itself
  std::map<std::string, std::size_t> min_bytes_;     ///< of the types that are resolved
};

}  // namespace ribbon_mapper
