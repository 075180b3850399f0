// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/plane_adjustment.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace ribbon_mapper {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Planes = std::vector<SightedPlane>;

// A plane is where it was by no better than this [m, rad]: so the system is regular.
constexpr double plane_sigma = 1.0;

/// Of all planes, three numbers each.
struct PlaneSystem {
  explicit PlaneSystem(std::size_t planes)
      : information(MatrixXd::Identity(3 * planes, 3 * planes) / (plane_sigma * plane_sigma)),
        gradient(VectorXd::Zero(3 * planes)) {}
  MatrixXd information;
  VectorXd gradient;
};

/// One sighting, weighted.
struct Equation {
  Equation(const PlaneSighting& sighting, const Planes& planes, const Pose& T_model_base)
      : residual(residual_of(*sighting.sight, planes[sighting.plane], T_model_base)),
        pose(by_pose(*sighting.sight, planes[sighting.plane].normal, T_model_base)),
        plane(by_plane(*sighting.sight, planes[sighting.plane], T_model_base)),
        weights(sighting.sight->variances.cwiseInverse()) {
    weights *= robust_weight(residual.cwiseAbs2().dot(weights));
  }
  Eigen::Vector2d residual;
  Eigen::Matrix<double, 2, 6> pose;
  Eigen::Matrix<double, 2, 3> plane;
  Eigen::Vector2d weights;
};

void add_to_planes(const FixedLine& line, const Planes& planes, PlaneSystem& system) {
  for (const PlaneSighting& sighting : line.sightings) {
    const Equation e(sighting, planes, line.T_model_base);
    const auto at = 3 * sighting.plane;
    system.information.block<3, 3>(at, at) +=
        e.plane.transpose() * e.weights.asDiagonal() * e.plane;
    system.gradient.segment<3>(at) -= e.plane.transpose() * e.weights.asDiagonal() * e.residual;
  }
}

/// Normal equations of a chain: block-tridiagonal in the poses of its lines, bordered by the planes
/// that these see.
class ChainSystem {
 public:
  ChainSystem(const LineChain& chain, const Planes& planes);

  /// Eliminates the poses and adds what remains to the planes'.
  void reduce_to(PlaneSystem& system);

  /// Errors of the poses, given those of all planes.
  std::vector<Vector6> solve(const VectorXd& plane_errors) const;

 private:
  void add_step(const LineChain& chain, std::size_t step);
  void add_sightings(const FixedLine& line, const Planes& planes, std::size_t row);
  VectorXd local(const VectorXd& of_all) const;
  Eigen::Index column_of(std::uint32_t plane) const {
    return 3 * (std::lower_bound(seen_.begin(), seen_.end(), plane) - seen_.begin());
  }

  std::vector<std::uint32_t> seen_;  // planes, sorted
  std::vector<Matrix6> diagonal_;    // by line; once reduced: of the eliminated system
  std::vector<Matrix6> upper_;       // from each line to the next
  std::vector<MatrixXd> border_;     // by line: 3 columns for each plane, then the right hand side
  std::vector<Eigen::LDLT<Matrix6>> factors_;
};

ChainSystem::ChainSystem(const LineChain& chain, const Planes& planes)
    : diagonal_(chain.lines.size(), Matrix6::Zero()), upper_(chain.lines.size(), Matrix6::Zero()) {
  for (const FixedLine& line : chain.lines) {
    for (const PlaneSighting& sighting : line.sightings) seen_.push_back(sighting.plane);
  }
  std::sort(seen_.begin(), seen_.end());
  seen_.erase(std::unique(seen_.begin(), seen_.end()), seen_.end());
  const auto columns = static_cast<Eigen::Index>(3 * seen_.size() + 1);
  border_.assign(chain.lines.size(), MatrixXd::Zero(6, columns));
  for (std::size_t i = 0; i < chain.steps.size(); ++i) add_step(chain, i);
  for (std::size_t i = 0; i < chain.lines.size(); ++i) add_sightings(chain.lines[i], planes, i);
}

void ChainSystem::add_step(const LineChain& chain, std::size_t step) {
  const bool is_first = step == 0, is_last = step == chain.lines.size();
  if ((is_first && !chain.first_end) || (is_last && !chain.last_end)) return;
  const Pose& from = is_first ? *chain.first_end : chain.lines[step - 1].T_model_base;
  const Pose& to = is_last ? *chain.last_end : chain.lines[step].T_model_base;
  const Vector6 residual = error_between(from * chain.steps[step], to);
  const Matrix6 information = in_world(chain.variances[step].cwiseInverse(), from.linear());
  const Matrix6 by_from = -carry(from.linear() * chain.steps[step].translation());
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

void ChainSystem::add_sightings(const FixedLine& line, const Planes& planes, std::size_t row) {
  for (const PlaneSighting& sighting : line.sightings) {
    const Equation e(sighting, planes, line.T_model_base);
    const Eigen::Matrix<double, 6, 2> weighted = e.pose.transpose() * e.weights.asDiagonal();
    diagonal_[row] += weighted * e.pose;
    border_[row].middleCols<3>(column_of(sighting.plane)) += weighted * e.plane;
    border_[row].rightCols<1>() -= weighted * e.residual;
  }
}

void ChainSystem::reduce_to(PlaneSystem& system) {
  const auto seen = static_cast<Eigen::Index>(3 * seen_.size());
  MatrixXd taken = MatrixXd::Zero(seen, seen + 1);
  for (std::size_t i = 0; i < diagonal_.size(); ++i) {
    if (i > 0) {
      const Matrix6 carried = factors_[i - 1].solve(upper_[i - 1]).transpose();
      diagonal_[i] -= carried * upper_[i - 1];
      border_[i] -= carried * border_[i - 1];
    }
    factors_.emplace_back(diagonal_[i]);
    taken += border_[i].leftCols(seen).transpose() * factors_[i].solve(border_[i]);
  }
  for (Eigen::Index a = 0; a < seen; ++a) {
    const Eigen::Index row = 3 * seen_[a / 3] + a % 3;
    system.gradient[row] -= taken(a, seen);
    for (Eigen::Index b = 0; b < seen; ++b) {
      system.information(row, 3 * seen_[b / 3] + b % 3) -= taken(a, b);
    }
  }
}

VectorXd ChainSystem::local(const VectorXd& of_all) const {
  VectorXd result(3 * seen_.size());
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    result.segment<3>(3 * i) = of_all.segment<3>(3 * seen_[i]);
  }
  return result;
}

std::vector<Vector6> ChainSystem::solve(const VectorXd& plane_errors) const {
  const VectorXd errors = local(plane_errors);
  std::vector<Vector6> result(diagonal_.size());
  for (std::size_t i = diagonal_.size(); i-- > 0;) {
    Vector6 rest = border_[i].rightCols<1>() - border_[i].leftCols(errors.size()) * errors;
    if (i + 1 < diagonal_.size()) rest -= upper_[i] * result[i + 1];
    result[i] = factors_[i].solve(rest);
  }
  return result;
}

}  // namespace

void adjust(const std::vector<FixedLine>& fixed, std::vector<LineChain>& chains, Planes& planes) {
  PlaneSystem system(planes.size());
  std::vector<ChainSystem> chain_systems;
  for (const FixedLine& line : fixed) add_to_planes(line, planes, system);
  for (const LineChain& chain : chains) {
    for (const FixedLine& line : chain.lines) add_to_planes(line, planes, system);
    chain_systems.emplace_back(chain, planes);
    chain_systems.back().reduce_to(system);
  }
  const VectorXd errors = system.information.ldlt().solve(system.gradient);
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const std::vector<Vector6> pose_errors = chain_systems[i].solve(errors);
    for (std::size_t k = 0; k < pose_errors.size(); ++k) {
      Pose& pose = chains[i].lines[k].T_model_base;
      pose = moved(pose, pose_errors[k]);
    }
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    planes[i] = moved(planes[i], errors.segment<3>(static_cast<Eigen::Index>(3 * i)));
  }
}

}  // namespace ribbon_mapper
