// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/plane_adjustment.hpp"

#include "modeler/chain/chain_system.hpp"

namespace ribbon_mapper {
namespace {

// A weak prior on landmarks [m, rad], so that the system is regular where nothing was matched.
constexpr double kLandmarkSigma = 1.0;

/// The landmarks that matches refer to, and how residuals are weighted.
struct Landmarks {
  const std::vector<PlaneLandmark>& all;
  double robust_sigmas;
};

/// The linearised equations of one match, weighted.
struct Equation {
  Equation(const LandmarkMatch& match, const Landmarks& landmarks, const Pose& T_model_base)
      : residual(residual_of(*match.observation, landmarks.all[match.landmark], T_model_base)),
        by_pose(derivative_by_pose(*match.observation, landmarks.all[match.landmark].normal,
                                   T_model_base)),
        by_landmark(derivative_by_landmark(*match.observation, landmarks.all[match.landmark],
                                           T_model_base)),
        weights(match.observation->variances.cwiseInverse()) {
    weights *= robust_weight(residual.cwiseAbs2().dot(weights), landmarks.robust_sigmas);
  }
  Eigen::Vector2d residual;
  Eigen::Matrix<double, 2, 6> by_pose;
  Eigen::Matrix<double, 2, 3> by_landmark;
  Eigen::Vector2d weights;
};

void add_landmark(const LandmarkMatch& match, const Equation& e, ChainSystem& system) {
  const Eigen::Matrix<double, 3, 2> weighted = e.by_landmark.transpose() * e.weights.asDiagonal();
  system.add_landmark(match.landmark, weighted * e.by_landmark, -weighted * e.residual);
}

void add_known_line(const ObservingLine& line, const Landmarks& landmarks, ChainSystem& system) {
  for (const LandmarkMatch& match : line.matches) {
    add_landmark(match, Equation(match, landmarks, line.T_model_base), system);
  }
}

void add_line(const ObservingLine& line, const Landmarks& landmarks, std::size_t pose,
              ChainSystem& system) {
  for (const LandmarkMatch& match : line.matches) {
    const Equation e(match, landmarks, line.T_model_base);
    const Eigen::Matrix<double, 6, 2> weighted = e.by_pose.transpose() * e.weights.asDiagonal();
    system.add_pose(pose, weighted * e.by_pose, -weighted * e.residual);
    system.add_coupling(pose, match.landmark, weighted * e.by_landmark);
    add_landmark(match, e, system);
  }
}

/// Returns the information of an odometry step's error, along the axes of the model frame.
Matrix6 information_of_step(const ObservingSegment& observing, std::size_t step,
                            const Eigen::Matrix3d& rotation) {
  if (!observing.step_information.empty())
    return in_other_axes(observing.step_information[step], rotation);
  return in_model_axes(observing.segment.step_variances[step].cwiseInverse(), rotation);
}

/// Adds an odometry step to the line of index `step` in the segment, whose first line is the pose
/// `first` of the system.
void add_step(const ObservingSegment& observing, std::size_t step, std::size_t first,
              ChainSystem& system) {
  const TrajectorySegment& segment = observing.segment;
  const bool is_first = step == 0, is_last = step == observing.lines.size();
  if ((is_first && !segment.T_frame_start) || (is_last && !segment.T_frame_end)) return;
  const Pose& from = is_first ? *segment.T_frame_start : observing.lines[step - 1].T_model_base;
  const Pose& to = is_last ? *segment.T_frame_end : observing.lines[step].T_model_base;
  const Vector6 residual = error_between(from * segment.steps[step], to);
  const Matrix6 information = information_of_step(observing, step, from.linear());
  const Matrix6 by_from = -transport(from.linear() * segment.steps[step].translation());
  const Matrix6 weighted = by_from.transpose() * information;
  if (!is_first) system.add_pose(first + step - 1, weighted * by_from, -weighted * residual);
  if (!is_last) system.add_pose(first + step, information, -information * residual);
  if (!is_first && !is_last) system.add_link(first + step - 1, weighted);
}

std::size_t count_lines(const std::vector<ObservingSegment>& segments) {
  std::size_t count = 0;
  for (const ObservingSegment& segment : segments) count += segment.lines.size();
  return count;
}

/// Returns the normal equations. The segments' poses follow each other, without a link between the
/// last of one and the first of the next.
ChainSystem equations_of(const std::vector<ObservingLine>& known_lines,
                         const std::vector<ObservingSegment>& segments,
                         const Landmarks& landmarks) {
  ChainSystem system(count_lines(segments), landmarks.all.size());
  const Eigen::Matrix3d prior = Eigen::Matrix3d::Identity() / square(kLandmarkSigma);
  for (std::size_t i = 0; i < landmarks.all.size(); ++i) {
    system.add_landmark(i, prior, Eigen::Vector3d::Zero());
  }
  for (const ObservingLine& line : known_lines) add_known_line(line, landmarks, system);
  std::size_t first = 0;
  for (const ObservingSegment& segment : segments) {
    for (std::size_t i = 0; i < segment.segment.steps.size(); ++i) {
      add_step(segment, i, first, system);
    }
    for (std::size_t i = 0; i < segment.lines.size(); ++i) {
      add_line(segment.lines[i], landmarks, first + i, system);
    }
    first += segment.lines.size();
  }
  return system;
}

}  // namespace

void adjust(const std::vector<ObservingLine>& known_lines, std::vector<ObservingSegment>& segments,
            std::vector<PlaneLandmark>& landmarks, double robust_sigmas) {
  const ChainSystem::Solution errors =
      equations_of(known_lines, segments, {landmarks, robust_sigmas}).solve();
  auto error = errors.poses.begin();
  for (ObservingSegment& segment : segments) {
    for (ObservingLine& line : segment.lines) {
      line.T_model_base = moved(line.T_model_base, *error++);
    }
  }
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    landmarks[i] = moved(landmarks[i], errors.landmarks[i]);
  }
}

std::vector<Matrix6> pose_covariances(const std::vector<ObservingLine>& known_lines,
                                      const std::vector<ObservingSegment>& segments,
                                      const std::vector<PlaneLandmark>& landmarks,
                                      double robust_sigmas) {
  return equations_of(known_lines, segments, {landmarks, robust_sigmas}).pose_covariances();
}

}  // namespace ribbon_mapper
