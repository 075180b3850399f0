// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/node/model_keeper.hpp"

#include "modeler/program/stopwatch.hpp"
#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {

void ModelKeeper::add(const ReadyLine& line) {
  LineResult result = LineResult::modelled;
  const double seconds =
      wall_seconds_of([&] { result = modeler_.add_scan_line(line.beams, line.poses); });
  if (result == LineResult::malformed || result == LineResult::out_of_order) {
    log_.dropped(to_string(result), find_defect(line.beams, line.poses).value_or(""));
    return;
  }
  log_.handled(to_string(result), seconds);
  const double step_s = to_seconds(line.beams.stamp - last_stamp_);
  if (last_stamp_ != Time(0) && step_s < 1.0) data_s_ += step_s;  // a longer step is a pause
  last_stamp_ = line.beams.stamp;
  ++version_;
}

void ModelKeeper::correct(const std::vector<StampedPose>& trajectory) {
  labels();  // notes where annotated planes are
  Before before{modeler_.planes_as_built(), modeler_.planes(), modeler_.trajectory()};
  correction_ms_ = 1e3 * wall_seconds_of([&] { modeler_.correct(trajectory); });
  before_ = std::move(before);
  ++version_;
}

void ModelKeeper::reset() {
  modeler_.reset();
  log_ = {};
  before_ = {};
  annotations_ = {};
  correction_ms_ = data_s_ = 0.0;
  last_stamp_ = Time(0);
  ++version_;
}

const std::vector<Plane>& ModelKeeper::planes() {
  if (planes_version_ != version_) planes_ = modeler_.planes();
  planes_version_ = version_;
  return planes_;
}

const std::vector<PlaneLabel>& ModelKeeper::labels() {
  if (labels_version_ == version_) return labels_;
  const std::vector<const Annotation*> annotations = annotations_.of(planes());
  const Semantics semantics = semantics_of(planes_, positions_of(modeler_.trajectory()));
  labels_ = plane_labels(planes_, semantics, annotations);
  labels_version_ = version_;
  return labels_;
}

void ModelKeeper::annotate(std::int64_t id, const std::string& label, const std::string& note) {
  annotations_.set(id, label, note, planes());
  ++version_;
}

double ModelKeeper::real_time_factor() const {
  return log_.busy_s() > 0.0 ? data_s_ / log_.busy_s() : 0.0;
}

}  // namespace ribbon_mapper
