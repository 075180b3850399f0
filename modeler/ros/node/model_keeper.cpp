// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/node/model_keeper.hpp"

#include <algorithm>
#include <utility>

#include "modeler/program/stopwatch.hpp"
#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {
namespace {

constexpr const char* kAnnotations = "anno";  // name of the part of a model file
constexpr const char* kOlderThanLoaded = "older than the loaded model";

/// Returns the stamp of the newest line of a model, in it or waiting for its neighbours.
Time newest_stamp(const SavedModel& model) {
  const std::vector<Time>& stamps = model.observations.trajectory().recorded().stamps();
  Time newest = stamps.empty() ? Time(0) : stamps.back();
  for (const auto& line : model.waiting.lines) newest = std::max(newest, middle_of(line.beams));
  return std::max(newest, model.waiting.average.last_stamp);
}

}  // namespace

void ModelKeeper::add(const ReadyLine& line) {
  LineResult result = LineResult::modelled;
  const std::size_t ribbons_before = modeler_.ribbons().size();
  const double seconds =
      wall_seconds_of([&] { result = modeler_.add_scan_line(line.beams, line.poses); });
  if (modeler_.ribbons().size() < ribbons_before) annotations_.forget_ribbons();  // thinned
  if (result == LineResult::malformed || result == LineResult::out_of_order) {
    const bool is_old = result == LineResult::out_of_order && line.beams.stamp <= loaded_until_;
    log_.dropped(is_old ? kOlderThanLoaded : to_string(result),
                 find_defect(line.beams, line.poses).value_or(""));
    return;
  }
  log_.handled(to_string(result), seconds);
  const double step_s = to_seconds(line.beams.stamp - last_stamp_);
  if (last_stamp_ != Time(0) && step_s < 1.0) data_s_ += step_s;  // a longer step is a pause
  last_stamp_ = line.beams.stamp;
  ++version_;
}

void ModelKeeper::correct(const std::vector<StampedPose>& trajectory) {
  annotations_.note_ribbons(planes());
  Before before{modeler_.planes_as_built(), planes(), modeler_.trajectory()};
  correction_ms_ = 1e3 * wall_seconds_of([&] { modeler_.correct(trajectory); });
  before_ = std::move(before);
  has_before_ = true;
  ++version_;
}

void ModelKeeper::reset() {
  modeler_.reset();
  additions_.clear();
  loaded_until_ = Time(0);
  forget_history();
}

void ModelKeeper::load(ModelFile file) {
  Annotations annotations;
  const auto part = std::find_if(file.additions.begin(), file.additions.end(),
                                 [](const Section& s) { return s.name == kAnnotations; });
  if (part != file.additions.end()) {
    annotations = Annotations::from_text(part->bytes);
    file.additions.erase(part);
  }
  loaded_until_ = newest_stamp(file.model);
  modeler_ = Modeler(modeler_.config(), std::move(file.model));
  additions_ = std::move(file.additions);
  forget_history();
  annotations_ = std::move(annotations);
}

void ModelKeeper::forget_history() {
  log_ = {};
  before_ = {};
  has_before_ = false;
  annotations_ = {};
  correction_ms_ = data_s_ = 0.0;
  last_stamp_ = Time(0);
  ++version_;
}

std::string ModelKeeper::file_bytes(const std::string& map_frame) {
  std::vector<Section> additions = additions_;
  if (!annotations_.by_id().empty()) {
    annotations_.note_ribbons(planes());
    additions.push_back({kAnnotations, annotations_.to_text()});
  }
  return to_model_file(modeler_, map_frame, additions);
}

const PlaneModel& ModelKeeper::plane_model() {
  if (planes_version_ != version_) plane_model_ = modeler_.plane_model();
  planes_version_ = version_;
  return plane_model_;
}

const std::vector<PlaneLabel>& ModelKeeper::labels() {
  if (labels_version_ == version_) return labels_;
  const std::vector<Plane>& planes = this->planes();
  annotations_.note_ribbons(planes);
  const std::vector<const Annotation*> annotations = annotations_.of(planes);
  const Semantics by_rules = semantics_of(planes, positions_of(modeler_.trajectory()));
  labels_ = plane_labels(planes, by_rules, annotations);
  semantics_ = with_annotations(by_rules, annotations);
  labels_version_ = version_;
  return labels_;
}

const Rooms& ModelKeeper::rooms() {
  if (rooms_version_ == version_) return rooms_;
  rooms_ = rooms_of(planes(), semantics(), stripe_gap_m_);
  rooms_version_ = version_;
  return rooms_;
}

const Semantics& ModelKeeper::semantics() {
  labels();  // of the same version
  return semantics_;
}

FloorPlan ModelKeeper::floor_plan() { return floor_plan_of(planes(), semantics(), rooms()); }

void ModelKeeper::annotate(std::int64_t id, const std::string& label, const std::string& note) {
  annotations_.set(id, label, note, planes());
  planes_version_ = ++version_;  // the planes stay as they are
}

double ModelKeeper::real_time_factor() const {
  return log_.busy_s() > 0.0 ? data_s_ / log_.busy_s() : 0.0;
}

}  // namespace ribbon_mapper
