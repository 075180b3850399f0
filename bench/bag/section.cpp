// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "bench/lines/line_times.hpp"
#include "bench/sections.hpp"

namespace ribbon_mapper::bench {

void require_ribbons(const Inputs& bag) {
  Modeler modeler(bag.config);
  feed(bag.recording, modeler);
  if (modeler.statistics().ribbons > 0) return;
  throw std::runtime_error("the bag " + bag.recording.name +
                           " yields no ribbons: does its preset (--bag-config) fit its laser?");
}

void measure_bags(const std::vector<Inputs>& bags, Report& report) {
  for (const Inputs& bag : bags) {
    const std::string& name = bag.recording.name;
    // Ratios of the first bag have short names.
    report.begin_with("a recorded bag, " + name + ": ",
                      &bag == &bags.front() ? "bag_" : "bag_" + name + "_");
    measure_recorded_lines(bag, report);
    measure_normals(bag, report);
    measure_recorded_planes(bag, report);
    measure_memory(bag, report);
  }
  report.begin_with("", "");
}

}  // namespace ribbon_mapper::bench
