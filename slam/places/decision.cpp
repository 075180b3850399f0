// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/places/decision.hpp"

#include <iomanip>
#include <sstream>

namespace ribbon_mapper::slam {

std::string name_of(Decision::Kind kind) {
  switch (kind) {
    case Decision::Kind::lost:
      return "lost";
    case Decision::Kind::found:
      return "found";
    case Decision::Kind::kept:
      return "kept";
    case Decision::Kind::undone:
      return "undone";
  }
  return "unknown";
}

std::vector<std::string> texts_of(const std::vector<Decision>& decisions, Time start) {
  std::vector<std::string> texts;
  for (const Decision& decision : decisions) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << to_seconds(decision.stamp - start) << " s "
         << name_of(decision.kind) << ": " << decision.reason;
    texts.push_back(text.str());
  }
  return texts;
}

}  // namespace ribbon_mapper::slam
