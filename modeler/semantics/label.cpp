// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/semantics/label.hpp"

namespace ribbon_mapper {

std::string to_string(Label label) {
  switch (label) {
    case Label::floor:
      return "floor";
    case Label::ceiling:
      return "ceiling";
    case Label::wall:
      return "wall";
    case Label::door_leaf:
      return "door leaf";
    case Label::top:
      return "table or shelf top";
    case Label::slope:
      return "slope";
    case Label::furniture:
      break;
  }
  return "other furniture";
}

std::optional<Label> label_from(const std::string& text) {
  for (const Label label : kLabels) {
    if (to_string(label) == text) return label;
  }
  return std::nullopt;
}

}  // namespace ribbon_mapper
