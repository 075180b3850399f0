// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/level/final_matching.hpp"

#include <algorithm>
#include <memory>

#include "modeler/geometry/square.hpp"

namespace ribbon_mapper::slam {
namespace {

/// The surroundings of a scan.
struct Around {
  std::size_t keyframe = 0;
  bool without_centre = false;
  std::unique_ptr<SurfaceMap> map;  // in the keyframe
};

void make_map(const std::vector<Keyframe>& keyframes, const std::vector<PlanarPose>& poses,
              const FinalMatchConfig& config, Around& around) {
  const std::size_t k = around.keyframe;
  const std::size_t first = k > config.before ? k - config.before : 0;
  const std::size_t last = std::min(keyframes.size() - 1, k + config.after);
  LevelPoints points;
  for (std::size_t i = first; i <= last; ++i) {
    // a scan that is matched against itself stays where it is
    if (i == k && around.without_centre && first < last) continue;
    append_moved(keyframes[i].points, relative(poses[k], poses[i]), points);
  }
  around.map = std::make_unique<SurfaceMap>(points);
}

/// Returns where a scan may be, as seen from its keyframe.
std::vector<PlanarPose> guesses(const TrackedScan& tracked, const std::vector<Keyframe>& keyframes,
                                const std::vector<PlanarPose>& poses) {
  std::vector<PlanarPose> result{tracked.T_keyframe_base};
  const std::size_t k = tracked.keyframe;
  if (k + 1 == keyframes.size() || tracked.is_keyframe) return result;
  const PlanarPose step = keyframes[k + 1].T_before_base;
  const PlanarPose T_k_next = relative(poses[k], poses[k + 1]);
  result.push_back(T_k_next * relative(step, tracked.T_keyframe_base));  // from the one after
  const double part = std::min(1.0, tracked.T_keyframe_base.translation().norm() /
                                        std::max(0.01, step.translation().norm()));
  result.push_back(planar((1.0 - part) * result[0].vector() + part * result[1].vector()));
  return result;
}

}  // namespace

std::vector<PlanarPose> final_poses(const std::vector<ScanToPlace>& scans,
                                    const std::vector<Keyframe>& keyframes,
                                    const std::vector<PlanarPose>& T_map_keyframes,
                                    const FinalMatchConfig& config,
                                    const MatchConfig& match_config) {
  std::vector<PlanarPose> poses;
  poses.reserve(scans.size());
  Around around;
  PosePrior prior;
  prior.information.diagonal() << 1.0 / square(config.prior_m), 1.0 / square(config.prior_m),
      1.0 / square(config.prior_rad);
  for (const ScanToPlace& scan : scans) {
    const TrackedScan& tracked = scan.tracked;
    if (!around.map || around.keyframe != tracked.keyframe ||
        around.without_centre != tracked.is_keyframe) {
      around.keyframe = tracked.keyframe, around.without_centre = tracked.is_keyframe;
      make_map(keyframes, T_map_keyframes, config, around);
    }
    Match best;
    best.cost = 2.0;
    for (const PlanarPose& guess : guesses(tracked, keyframes, T_map_keyframes)) {
      prior.T_map_base = guess;
      const Match found = match(scan.points, *around.map, guess, prior, match_config);
      if (found.cost < best.cost) best = found;
    }
    poses.push_back(T_map_keyframes[tracked.keyframe] * best.T_map_base);
  }
  return poses;
}

}  // namespace ribbon_mapper::slam
