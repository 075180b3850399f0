// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace ribbon_mapper {

/// What a plane is.
enum class Label {
  floor,      ///< what the robot drives on, level
  ceiling,    ///< level, seen from below, over people's heads
  wall,       ///< upright, from the floor to the ceiling or higher than a door
  door_leaf,  ///< upright, of the size of a door, hinged at a door opening
  top,        ///< level, seen from above, above the floor: of a table, shelf, seat, bed or podium
  furniture,  ///< all else
  slope       ///< tilted: a ramp, or a roof over people's heads
};

/// All labels.
constexpr std::array<Label, 7> kLabels{Label::floor,     Label::ceiling, Label::wall,
                                       Label::door_leaf, Label::top,     Label::furniture,
                                       Label::slope};

/// Returns the text of a label, as files and messages have it: "table or shelf top", for example.
std::string to_string(Label label);

/// Returns the label with this text; nothing if there is none.
std::optional<Label> label_from(const std::string& text);

/// A label, and how sure it is.
struct Decision {
  Label label = Label::furniture;  ///< what the rules say
  double confidence = 0.0;         ///< from 0 to 1; 0.5: a measured size lies on a rule's limit
};

/// Returns the probability that a size is on the side of a limit where it was measured: `margin`
/// beyond the limit, with a normal error of this standard deviation.
inline double certainty(double margin, double sigma) {
  return 0.5 * std::erfc(-std::abs(margin) / (std::sqrt(2.0) * sigma));
}

/// Returns a decision that depends on another measured size as well.
inline Decision given(Decision decision, double certainty_of_size) {
  decision.confidence = std::min(decision.confidence, certainty_of_size);
  return decision;
}

}  // namespace ribbon_mapper
