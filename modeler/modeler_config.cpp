// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>

#include "modeler/config_keys.hpp"

namespace ribbon_mapper {
namespace {

struct RangeCheck {
  template <typename Number>
  void operator()(const char* key, const Number& value, double least, double most) const {
    if (value >= least && value <= most) return;  // false for NaN, too
    std::ostringstream message;
    message.imbue(std::locale::classic());
    message << key << " is " << value << ": it must lie in " << least << " .. " << most;
    throw std::invalid_argument(message.str());
  }
  void operator()(const char*, const bool&) const {}
};

}  // namespace

void ModelerConfig::validate() const {
  RangeCheck check;
  visit_keys(*this, check);
  if (scan.min_range_m >= scan.max_range_m) {
    throw std::invalid_argument("scan.min_range_m must be below scan.max_range_m");
  }
  if (maps.obstacle_min_m >= maps.obstacle_max_m) {
    throw std::invalid_argument("maps.obstacle_min_m must be below maps.obstacle_max_m");
  }
}

}  // namespace ribbon_mapper
