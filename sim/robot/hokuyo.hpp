// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "sim/rays/ray_caster.hpp"

namespace ribbon_mapper::sim {

class World;

/// One rotation of the simulated laser: what sensor_msgs/LaserScan says, and what only the
/// simulator knows.
struct Scan {
  Time stamp{0};  ///< of the first beam
  double angle_min_rad = 0.0;
  double angle_increment_rad = 0.0;
  double time_increment_s = 0.0;
  double scan_time_s = 0.0;
  double range_min_m = 0.0;
  double range_max_m = 0.0;
  std::vector<float> ranges_m;       ///< +inf: no return, -inf: nearer than range_min (REP 117)
  std::vector<int> faces;            ///< index into World::faces() that the beam hit, -1 for none
  std::vector<float> true_ranges_m;  ///< without noise, +inf: no return
  std::vector<Ray> rays;             ///< of the beams, in map, each from its own time
};

/// Sigma of a range, by name of its source.
enum class RangeNoise {
  none,
  gazebo,     ///< 0.005 m (pr2_description, hokuyo_lx30_laser.gazebo.xacro)
  datasheet,  ///< UTM-30LX: 0.01 m up to 10 m, 0.03 m beyond
  pomerleau,  ///< max(0.018, 0.0006 r + 0.0015) m (libpointmatcher, SimpleSensorNoise type 2)
};

/// The noise of that name. Throws std::invalid_argument naming the names.
RangeNoise range_noise_from(const std::string& name);

/// Standard deviation of a range [m].
double sigma_m(RangeNoise noise, double range_m);

struct HokuyoConfig {
  double rate_hz = 40.0;
  double angle_min_rad = -0.829;
  double angle_max_rad = 0.829;
  double angle_increment_rad = 2.0 * 3.14159265358979323846 / 1440.0;
  double range_min_m = 0.1;
  double range_max_m = 30.0;
  RangeNoise noise = RangeNoise::datasheet;
  double noise_scale = 1.0;  ///< multiplies sigma
  bool mixed_pixels = true;  ///< ranges between two depths where the beam's spot meets both
  double quantisation_m = 0.001;
  /// So many beams about straight ahead; of an even number, one more to the right (negative
  /// angles).
  void set_beams(int count);
  void validate() const;  ///< throws std::invalid_argument naming the key and its range
};

/// Where the laser is at a time: T_map_laser.
using LaserPose = std::function<Pose(Time)>;

/// A Hokuyo UTM-30LX: 0.25 degree steps counted from straight ahead as hokuyo_node does, one turn
/// in 25 ms whatever the rate (a lower rate leaves turns out), each beam cast from where the laser
/// is at that beam's own time.
class Hokuyo {
 public:
  /// Throws std::invalid_argument if the configuration is not valid.
  Hokuyo(const HokuyoConfig& config, std::uint64_t seed);

  /// The line whose first beam is fired at `stamp`. Its noise depends on the seed and the stamp
  /// alone: lines may be made in any order, and by several threads.
  Scan scan(const World& world, Time stamp, const LaserPose& T_map_laser) const;

  int beam_count() const { return last_step_ - first_step_ + 1; }
  double angle_min_rad() const { return first_step_ * config_.angle_increment_rad; }
  Time period() const;                                     ///< from line to line
  Time sweep_time() const;                                 ///< from the first beam to the last
  Time beam_time(int beam) const { return times_[beam]; }  ///< after the stamp

 private:
  /// Ranges without noise but with mixed pixels.
  std::vector<double> mixed_ranges_m(const World& world, const Scan& scan,
                                     const LaserPose& T_map_laser, std::mt19937_64& random) const;
  float measured_m(double range_m, double normal) const;

  HokuyoConfig config_;
  std::uint64_t seed_;
  int first_step_, last_step_;               ///< from straight ahead
  std::vector<Eigen::Vector2d> directions_;  ///< of the beams: x and y in the laser's frame
  std::vector<Time> times_;                  ///< of the beams, after the stamp
};

}  // namespace ribbon_mapper::sim
