// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/offline/base_scans.hpp"

#include <stdexcept>
#include <utility>

namespace ribbon_mapper {
namespace {

BagOptions with_topic(BagOptions options, const std::string& topic) {
  options.scan_topic = topic;
  return options;
}

}  // namespace

BaseScans::BaseScans(const std::vector<std::filesystem::path>& bags, BagOptions options,
                     const std::string& topic)
    : lines_(bags, with_topic(std::move(options), topic), log_) {}

void BaseScans::take_until(Time stamp) {
  while (!is_at_end_ && newest_ <= stamp) {
    const std::optional<ReadyLine> scan = lines_.next();
    is_at_end_ = !scan;
    if (!scan) return;
    newest_ = middle_of(scan->beams);
    try {
      odometry_.add_scan(scan->beams, scan->poses);
    } catch (const std::invalid_argument& error) {
      log_.dropped(error.what());
    }
  }
}

BaseScanFigures BaseScans::figures() const {
  BaseScanFigures figures{lines_.scan_topic(), log_.lines(), odometry_.matched(),
                          log_.dropped_by_reason()};
  const std::size_t dropped = log_.dropped_lines();
  if (figures.matched > 0 && 2 * dropped <= figures.scans) return figures;
  std::string why = std::to_string(dropped) + " of " + std::to_string(figures.scans) +
                    " scans of the base laser on " + figures.topic + " could not be used";
  for (const auto& [reason, count] : figures.dropped)
    why += "\n  " + std::to_string(count) + " x " + reason;
  throw std::runtime_error(why + "\nleave out --base-scan, or give the topic of a level laser");
}

}  // namespace ribbon_mapper
