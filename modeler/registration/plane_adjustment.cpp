// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/plane_adjustment.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace ribbon_mapper {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// A weak prior on landmarks [m, rad], so that the system is regular where nothing was matched.
constexpr double kLandmarkSigma = 1.0;

/// The landmarks that matches refer to, and how residuals are weighted.
struct Landmarks {
  const std::vector<PlaneLandmark>& all;
  double robust_sigmas;
};

/// The normal equations of all landmarks, three unknowns each.
struct LandmarkSystem {
  explicit LandmarkSystem(std::size_t landmarks)
      : information(MatrixXd::Identity(3 * landmarks, 3 * landmarks) /
                    (kLandmarkSigma * kLandmarkSigma)),
        vector(VectorXd::Zero(3 * landmarks)) {}
  MatrixXd information;
  VectorXd vector;
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

void add_line(const ObservingLine& line, const Landmarks& landmarks, LandmarkSystem& system) {
  for (const LandmarkMatch& match : line.matches) {
    const Equation e(match, landmarks, line.T_model_base);
    const auto at = 3 * match.landmark;
    system.information.block<3, 3>(at, at) +=
        e.by_landmark.transpose() * e.weights.asDiagonal() * e.by_landmark;
    system.vector.segment<3>(at) -= e.by_landmark.transpose() * e.weights.asDiagonal() * e.residual;
  }
}

/// The normal equations of a segment: block-tridiagonal in the poses of its lines, bordered by the
/// landmarks that these observe.
class SegmentSystem {
 public:
  SegmentSystem(const ObservingSegment& observing, const Landmarks& landmarks);

  /// Eliminates the poses and adds what remains to the landmarks' system.
  void reduce_to(LandmarkSystem& system);

  /// Returns the errors of the poses, given those of all landmarks.
  std::vector<Vector6> solve(const VectorXd& landmark_errors) const;

 private:
  void add_step(const ObservingSegment& observing, std::size_t step);
  void add_matches(const ObservingLine& line, const Landmarks& landmarks, std::size_t row);
  VectorXd observed_part(const VectorXd& landmark_errors) const;
  Eigen::Index column_of(std::uint32_t landmark) const {
    return 3 * (std::lower_bound(observed_.begin(), observed_.end(), landmark) - observed_.begin());
  }

  std::vector<std::uint32_t> observed_;  // landmarks, sorted
  std::vector<Matrix6> diagonal_;        // by line; of the eliminated system once reduced
  std::vector<Matrix6> upper_;           // from each line to the next
  std::vector<MatrixXd> border_;  // by line: 3 columns per landmark, then the right-hand side
  std::vector<Eigen::LDLT<Matrix6>> factors_;
};

SegmentSystem::SegmentSystem(const ObservingSegment& observing, const Landmarks& landmarks)
    : diagonal_(observing.lines.size(), Matrix6::Zero()),
      upper_(observing.lines.size(), Matrix6::Zero()) {
  for (const ObservingLine& line : observing.lines) {
    for (const LandmarkMatch& match : line.matches) observed_.push_back(match.landmark);
  }
  std::sort(observed_.begin(), observed_.end());
  observed_.erase(std::unique(observed_.begin(), observed_.end()), observed_.end());
  const auto columns = static_cast<Eigen::Index>(3 * observed_.size() + 1);
  border_.assign(observing.lines.size(), MatrixXd::Zero(6, columns));
  for (std::size_t i = 0; i < observing.segment.steps.size(); ++i) add_step(observing, i);
  for (std::size_t i = 0; i < observing.lines.size(); ++i) {
    add_matches(observing.lines[i], landmarks, i);
  }
}

void SegmentSystem::add_step(const ObservingSegment& observing, std::size_t step) {
  const TrajectorySegment& segment = observing.segment;
  const bool is_first = step == 0, is_last = step == observing.lines.size();
  if ((is_first && !segment.T_frame_start) || (is_last && !segment.T_frame_end)) return;
  const Pose& from = is_first ? *segment.T_frame_start : observing.lines[step - 1].T_model_base;
  const Pose& to = is_last ? *segment.T_frame_end : observing.lines[step].T_model_base;
  const Vector6 residual = error_between(from * segment.steps[step], to);
  const Matrix6 information =
      in_model_axes(segment.step_variances[step].cwiseInverse(), from.linear());
  const Matrix6 by_from = -transport(from.linear() * segment.steps[step].translation());
  if (!is_first) {
    diagonal_[step - 1] += by_from.transpose() * information * by_from;
    border_[step - 1].rightCols<1>() -= by_from.transpose() * information * residual;
  }
  if (!is_last) {
    diagonal_[step] += information;
    border_[step].rightCols<1>() -= information * residual;
  }
  if (!is_first && !is_last) upper_[step - 1] = by_from.transpose() * information;
}

void SegmentSystem::add_matches(const ObservingLine& line, const Landmarks& landmarks,
                                std::size_t row) {
  for (const LandmarkMatch& match : line.matches) {
    const Equation e(match, landmarks, line.T_model_base);
    const Eigen::Matrix<double, 6, 2> weighted = e.by_pose.transpose() * e.weights.asDiagonal();
    diagonal_[row] += weighted * e.by_pose;
    border_[row].middleCols<3>(column_of(match.landmark)) += weighted * e.by_landmark;
    border_[row].rightCols<1>() -= weighted * e.residual;
  }
}

void SegmentSystem::reduce_to(LandmarkSystem& system) {
  const auto columns = static_cast<Eigen::Index>(3 * observed_.size());
  MatrixXd complement = MatrixXd::Zero(columns, columns + 1);
  for (std::size_t i = 0; i < diagonal_.size(); ++i) {
    if (i > 0) {
      const Matrix6 eliminated = factors_[i - 1].solve(upper_[i - 1]).transpose();
      diagonal_[i] -= eliminated * upper_[i - 1];
      border_[i] -= eliminated * border_[i - 1];
    }
    factors_.emplace_back(diagonal_[i]);
    complement += border_[i].leftCols(columns).transpose() * factors_[i].solve(border_[i]);
  }
  for (Eigen::Index a = 0; a < columns; ++a) {
    const Eigen::Index row = 3 * observed_[a / 3] + a % 3;
    system.vector[row] -= complement(a, columns);
    for (Eigen::Index b = 0; b < columns; ++b) {
      system.information(row, 3 * observed_[b / 3] + b % 3) -= complement(a, b);
    }
  }
}

VectorXd SegmentSystem::observed_part(const VectorXd& landmark_errors) const {
  VectorXd result(3 * observed_.size());
  for (std::size_t i = 0; i < observed_.size(); ++i) {
    result.segment<3>(3 * i) = landmark_errors.segment<3>(3 * observed_[i]);
  }
  return result;
}

std::vector<Vector6> SegmentSystem::solve(const VectorXd& landmark_errors) const {
  const VectorXd errors = observed_part(landmark_errors);
  std::vector<Vector6> result(diagonal_.size());
  for (std::size_t i = diagonal_.size(); i-- > 0;) {
    Vector6 rest = border_[i].rightCols<1>() - border_[i].leftCols(errors.size()) * errors;
    if (i + 1 < diagonal_.size()) rest -= upper_[i] * result[i + 1];
    result[i] = factors_[i].solve(rest);
  }
  return result;
}

}  // namespace

void adjust(const std::vector<ObservingLine>& known_lines, std::vector<ObservingSegment>& segments,
            std::vector<PlaneLandmark>& landmarks, double robust_sigmas) {
  const Landmarks weighted{landmarks, robust_sigmas};
  LandmarkSystem system(landmarks.size());
  std::vector<SegmentSystem> segment_systems;
  for (const ObservingLine& line : known_lines) add_line(line, weighted, system);
  for (const ObservingSegment& segment : segments) {
    for (const ObservingLine& line : segment.lines) add_line(line, weighted, system);
    segment_systems.emplace_back(segment, weighted);
    segment_systems.back().reduce_to(system);
  }
  const VectorXd errors = system.information.ldlt().solve(system.vector);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::vector<Vector6> pose_errors = segment_systems[i].solve(errors);
    for (std::size_t k = 0; k < pose_errors.size(); ++k) {
      Pose& pose = segments[i].lines[k].T_model_base;
      pose = moved(pose, pose_errors[k]);
    }
  }
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    landmarks[i] = moved(landmarks[i], errors.segment<3>(static_cast<Eigen::Index>(3 * i)));
  }
}

}  // namespace ribbon_mapper
