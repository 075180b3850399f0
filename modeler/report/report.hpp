// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/report/changed_keys.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// What the truth says of a plane.
struct PlaneVerdict {
  /// Whether a plane is the only one on a true plane.
  enum class Kind {
    matched,    ///< the plane of a true plane
    duplicate,  ///< a further plane on a true plane that has its own
    extra       ///< on no true plane
  };
  Kind kind = Kind::extra;                ///< which of these
  std::optional<std::size_t> truth;       ///< index of the true plane, see Report::set_truth()
  std::optional<double> angle_error_deg;  ///< between the normals
  std::optional<double> offset_error_m;   ///< of the centroid from the true plane
};

/// What is known of a plane beside itself.
struct PlaneRemarks {
  std::string label;                    ///< such as "wall"; empty: none
  std::optional<PlaneVerdict> verdict;  ///< where the truth is known
};

/// A model on a page.
struct ReportModel {
  std::string name;                        ///< such as "before the correction"
  const std::vector<Plane>* planes;        ///< with outlines; not null
  std::vector<PlaneRemarks> remarks = {};  ///< for each plane, or none
  std::size_t trajectory = 0;              ///< index of its trajectory, in the order of addition
};

/// A room on a page.
struct ReportRoom {
  std::string name;               ///< such as "kitchen"
  double area_m2 = 0.0;           ///< of its floor
  std::vector<Outline> outlines;  ///< of its floor, in map
  /// Where its name stands, in map [m]; nothing: in the middle of its outlines.
  std::optional<Eigen::Vector3d> centre = {};
};

/// A table of texts.
struct ReportTable {
  std::string title;                           ///< above the table
  std::vector<std::string> head;               ///< names of the columns
  std::vector<std::vector<std::string>> rows;  ///< as long as the head
};

/// What a page says of the run.
struct ReportHead {
  std::string title;          ///< what was modelled
  std::string frame = "map";  ///< frame of all coordinates
  std::string run;            ///< id of the run, see ModelLabel::run; may be empty
  std::string version;        ///< of the program
  std::string command;        ///< that makes the run again; may be empty
  std::optional<std::vector<ChangedKey>> parameters;  ///< see changed_keys(), if known
};

/// How much goes into a page, so that browsers open it.
struct ReportLimits {
  /// Cells of a model [bytes, packed]. The largest planes come first; others go without. One byte
  /// is about one cell: 1.5 MB hold 3700 m2 at 5 cm.
  std::size_t cells_of_a_model = 1'500'000;
  /// Poses of a trajectory. Others are left out at regular steps: 1500 are one every 10 cm of a
  /// tour of 150 m, less than a pixel of a whole flat.
  std::size_t poses = 1500;
};

/// A page to look at a model: one HTML file that needs no other and no network.
///
/// It shows models one after the other with a slider, so they are added in the order of time, after
/// their trajectories. Texts may hold any bytes: they are shown, and never interpreted.
class Report {
 public:
  /// Begins a page.
  explicit Report(ReportHead head, const ReportLimits& limits = {});

  /// Adds a trajectory. Those of the same line have the same stamp.
  void add_trajectory(const std::string& name, const std::vector<StampedPose>& poses);
  /// Adds a model.
  void add_model(const ReportModel& model);
  /// Sets the true planes, with outlines, and the true trajectory.
  void set_truth(const std::vector<Plane>& planes, const std::vector<StampedPose>& poses);
  /// Adds a room.
  void add_room(const ReportRoom& room);
  /// Adds a table.
  void add_table(const ReportTable& table);
  /// Adds a figure with its unit, such as "lines" and "9456".
  void add_fact(const std::string& name, const std::string& value);

  /// Returns the page. The same additions give the same bytes.
  std::string html() const;

  /// Returns the content of the page as JSON, in ASCII and without '<'.
  std::string json() const;

 private:
  std::string trajectory_json(const std::string& name, const std::vector<StampedPose>& poses);

  ReportHead head_;
  ReportLimits limits_;
  std::optional<Time> start_;  // of the first trajectory
  // JSON of what was added, as planes need not be kept.
  std::vector<std::string> trajectories_, models_, rooms_, tables_, facts_;
  std::string truth_ = "null";
};

}  // namespace ribbon_mapper
