// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/tilting/decision.hpp"

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

}  // namespace ribbon_mapper::slam
