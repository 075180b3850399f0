// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// What a person says about a plane.
struct Annotation {
  std::string label;  ///< what it is, in the person's words
  std::string note;   ///< anything else; may be empty
  /// Some of the plane's ribbons when it was last seen: where it is if its id is gone.
  std::vector<std::uint32_t> ribbons = {};
};

/// What people have said about the planes of a model, by the planes' ids.
///
/// Ids persist over corrections. If a plane's id is gone because it was merged into another, its
/// annotation is shown on that one, unless that has one of its own. An annotation is never dropped:
/// planes that were merged by mistake may separate again.
class Annotations {
 public:
  /// Longest label [bytes].
  static constexpr std::size_t kLongestLabel = 64;
  /// Longest note [bytes].
  static constexpr std::size_t kLongestNote = 1000;
  /// Largest number of ribbons that are kept of a plane: enough for a vote.
  static constexpr std::size_t kMostRibbons = 64;

  /// Annotates the plane with this id; an empty label removes its annotation. Throws
  /// std::invalid_argument, and changes nothing, if no plane has the id (the message lists those
  /// that there are), it has no annotation to remove, or a text is too long or has control
  /// characters.
  void set(std::int64_t id, const std::string& label, const std::string& note,
           const std::vector<Plane>& planes);

  /// Notes which ribbons the annotated planes have, by which they are found if their ids are gone.
  void note_ribbons(const std::vector<Plane>& planes);

  /// Forgets the ribbons: the model has numbered them anew. Until they are noted again, a plane is
  /// found by its id alone.
  void forget_ribbons();

  /// Returns, for each plane in its order, what people say about it; null where nothing.
  std::vector<const Annotation*> of(const std::vector<Plane>& planes) const;

  /// Returns all annotations by the ids of their planes.
  const std::map<std::int64_t, Annotation>& by_id() const { return by_id_; }

  /// Converts to text, a line for each: id, label, note, and ribbons separated by spaces.
  /// Tabulators stand between them.
  std::string to_text() const;

  /// Reads to_text(). Throws std::invalid_argument with the line that is wrong.
  static Annotations from_text(const std::string& text);

 private:
  std::map<std::int64_t, Annotation> by_id_;
};

}  // namespace ribbon_mapper
