// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <string>
#include <vector>

#include "modeler/floor_plan/floor_plan.hpp"
#include "modeler/model_file/model_file.hpp"
#include "modeler/modeler.hpp"
#include "modeler/ros/intake/line_intake.hpp"
#include "modeler/ros/intake/line_log.hpp"
#include "modeler/semantics/plane_label.hpp"
#include "modeler/semantics/rooms.hpp"
#include "modeler/semantics/semantics.hpp"

namespace ribbon_mapper {

/// The model with its history: the state before the last correction, what became of the lines, and
/// how long the work took.
class ModelKeeper {
 public:
  /// Creates an empty model. Throws std::invalid_argument as Modeler does.
  explicit ModelKeeper(const ModelerConfig& config)
      : modeler_(config), stripe_gap_m_(config.surface.stripe_gap_m) {}

  /// Adds a line to the model and its outcome to the log.
  void add(const ReadyLine& line);
  /// Corrects the model and keeps its state before. Throws as Modeler::correct() does; the model
  /// and the state before then stay as they were.
  void correct(const std::vector<StampedPose>& trajectory);
  /// Empties the model, its annotations, the log and the state before the correction.
  void reset();
  /// Goes on from a model file and its annotations; log and state before the correction are empty.
  /// Throws std::invalid_argument if the annotations are damaged; nothing has changed then.
  void load(ModelFile file);

  /// Returns the model.
  const Modeler& modeler() const { return modeler_; }
  /// Returns the bytes of a model file, see to_model_file().
  std::string file_bytes(const std::string& map_frame);
  /// Returns SurfaceConfig::stripe_gap_m, for meshes and markers.
  double stripe_gap_m() const { return stripe_gap_m_; }
  /// Returns the statistics of the lines.
  LineLog& log() { return log_; }
  const LineLog& log() const { return log_; }  ///< the same, to be read

  /// Returns a number that every change of the model increases.
  std::size_t version() const { return version_; }
  /// Returns the final planes. Evaluates the whole model if it has changed since the last call.
  const std::vector<Plane>& planes() { return plane_model().planes; }
  /// Returns the same with the ribbons that are gone.
  const PlaneModel& plane_model();

  /// Returns the labels of planes(), in their order.
  const std::vector<PlaneLabel>& labels();
  /// Returns what planes() are by the rules and, before them, by people, see with_annotations().
  const Semantics& semantics();
  /// Returns the rooms of planes() by semantics().
  const Rooms& rooms();
  /// Returns the floor plan of planes(), semantics() and rooms().
  FloorPlan floor_plan();
  /// Annotates a plane of planes(). Throws as Annotations::set().
  void annotate(std::int64_t id, const std::string& label, const std::string& note);
  /// Returns what people have said about the planes.
  const Annotations& annotations() const { return annotations_; }

  /// The state just before the last correction.
  struct Before {
    std::vector<Plane> planes_as_built;   ///< see Modeler::planes_as_built()
    std::vector<Plane> planes;            ///< see Modeler::planes()
    std::vector<StampedPose> trajectory;  ///< acquisition poses
  };
  /// Returns the state just before the last correction; empty if there was none.
  const Before& before() const { return before_; }
  /// Returns true if there was a correction since the model is here: it was not there before a
  /// load.
  bool has_before() const { return has_before_; }
  /// Returns how long the last correction took; 0 if there was none.
  double correction_ms() const { return correction_ms_; }
  /// Returns the seconds of data that the model takes per second of computing.
  double real_time_factor() const;

 private:
  void forget_history();

  Modeler modeler_;
  double stripe_gap_m_;
  LineLog log_;
  std::size_t version_ = 1, planes_version_ = 0;
  PlaneModel plane_model_;  ///< of planes_version_
  std::size_t labels_version_ = 0;
  Semantics semantics_;             ///< of labels_version_
  std::vector<PlaneLabel> labels_;  ///< of labels_version_
  std::size_t rooms_version_ = 0;
  Rooms rooms_;  ///< of rooms_version_
  Annotations annotations_;
  Before before_;
  bool has_before_ = false;
  std::vector<Section> additions_;  ///< of the file that was loaded
  Time loaded_until_{0};            ///< stamp of its newest line
  double correction_ms_ = 0.0;
  Time last_stamp_{0};
  double data_s_ = 0.0;
};

}  // namespace ribbon_mapper
