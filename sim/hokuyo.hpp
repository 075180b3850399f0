// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "modeler/geometry/pose.hpp"

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
  std::vector<float> ranges_m;  ///< +inf: no return, -inf: nearer than range_min (REP 117)
  std::vector<int> faces;       ///< index into World::faces() that the beam hit, -1 for none
  std::vector<float> true_ranges_m;  ///< without noise, +inf: no return
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
  double noise_scale = 1.0;      ///< multiplies sigma
  bool mixed_pixels = true;      ///< ranges between two depths where the beam's spot meets both
  double quantisation_m = 0.001;
  /// So many beams about straight ahead; of an even number, one more to the right (negative angles).
  void set_beams(int count);
  void validate() const;         ///< throws std::invalid_argument naming the key and its range
};

/// Where the laser is at a time: T_map_laser.
using LaserPose = std::function<Pose(Time)>;

/// A Hokuyo UTM-30LX: 0.25 degree steps counted from straight ahead as hokuyo_node does, one turn in
/// 25 ms whatever the rate (a lower rate leaves turns out), each beam cast from where the laser is
/// at that beam's own time.
class Hokuyo {
 public:
  /// Throws std::invalid_argument if the configuration is not valid.
  Hokuyo(const HokuyoConfig& config, std::uint64_t seed);

  /// The next line, its first beam at `stamp`. Depends on all lines before, as noise does.
  Scan scan(const World& world, Time stamp, const LaserPose& T_map_laser);

  int beam_count() const { return last_step_ - first_step_ + 1; }
  double angle_min_rad() const { return first_step_ * config_.angle_increment_rad; }
  Time period() const;         ///< from line to line
  Time sweep_time() const;     ///< from the first beam to the last
  Time beam_time(int beam) const;  ///< after the stamp

 private:
  struct Beam;
  Beam beam(Time stamp, const LaserPose& T_map_laser, int index) const;
  double mixed(const World& world, const Beam& beam, const Scan& scan, int index);
  float measured(double range_m);

  HokuyoConfig config_;
  int first_step_, last_step_;  ///< from straight ahead
  std::vector<Eigen::Vector3d> directions_;  ///< of the beams, in the laser's frame
  std::mt19937_64 random_;
};

}  // namespace ribbon_mapper::sim
