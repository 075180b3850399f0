// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/geometry/time.hpp"

namespace ribbon_mapper::slam {

/// A decision of the estimate about where the robot is.
struct Decision {
  /// What was decided.
  enum class Kind {
    lost,    ///< most of what is seen is unknown, and may be known ground at a wrong pose
    found,   ///< the newest poses were moved onto older planes
    kept,    ///< no move explains clearly more: the robot is on new ground
    undone,  ///< a move of before explains less than the poses without it, which are back
  };
  Kind kind;           ///< what was decided
  Time stamp;          ///< of the line at which it was
  std::string reason;  ///< the figures that it rests on
};

/// Returns the name of a kind as it stands in files and on /diagnostics.
std::string name_of(Decision::Kind kind);

/// Returns each decision as a text: the time since `start`, its name, and why.
std::vector<std::string> texts_of(const std::vector<Decision>& decisions, Time start);

}  // namespace ribbon_mapper::slam
