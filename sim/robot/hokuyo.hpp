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

/// One rotation of the simulated laser: the content of sensor_msgs/LaserScan, and the truth that
/// only the simulator knows.
struct Scan {
  Time stamp{0};                     ///< of the first beam
  double angle_min_rad = 0.0;        ///< of the first beam
  double angle_increment_rad = 0.0;  ///< from beam to beam
  double time_increment_s = 0.0;     ///< from beam to beam
  double scan_time_s = 0.0;          ///< from line to line
  double range_min_m = 0.0;          ///< shortest range that is measured
  double range_max_m = 0.0;          ///< longest range that is measured
  std::vector<float> ranges_m;       ///< +inf: no return, -inf: nearer than range_min (REP 117)
  std::vector<int> faces;            ///< index into World::faces() that the beam hit, -1 for none
  std::vector<float> true_ranges_m;  ///< without noise, +inf: no return
  std::vector<Ray> rays;             ///< of the beams, in map, each at its own time
  double ground_m = 0.0;             ///< height of the ground below the robot in map
};

/// The model of range noise, named after its source.
enum class RangeNoise {
  none,       ///< exact ranges
  gazebo,     ///< 0.005 m (pr2_description, hokuyo_lx30_laser.gazebo.xacro)
  datasheet,  ///< UTM-30LX: 0.01 m up to 10 m, 0.03 m beyond
  pomerleau,  ///< max(0.018, 0.0006 r + 0.0015) m (libpointmatcher, SimpleSensorNoise type 2)
};

/// Returns the noise called `name`. Throws std::invalid_argument that lists the names.
RangeNoise range_noise_from(const std::string& name);

/// Returns the standard deviation of a range [m].
double sigma_m(RangeNoise noise, double range_m);

/// Settings of the laser; the defaults are those of the PR2's tilting laser.
struct HokuyoConfig {
  double rate_hz = 40.0;          ///< lines per second, at most 40
  double angle_min_rad = -0.829;  ///< of the first beam, positive to the left
  double angle_max_rad = 0.829;   ///< of the last beam
  double angle_increment_rad = 2.0 * 3.14159265358979323846 / 1440.0;  ///< a quarter of a degree
  double range_min_m = 0.1;                  ///< shortest range that is measured
  double range_max_m = 30.0;                 ///< longest range that is measured
  RangeNoise noise = RangeNoise::datasheet;  ///< model of the noise
  double noise_scale = 1.0;                  ///< multiplies sigma
  bool mixed_pixels = true;       ///< ranges between two depths where the beam's spot covers both
  double quantisation_m = 0.001;  ///< ranges are multiples of this; 0: none

  /// Returns the settings of the laser on the PR2's base (pr2_bringup, pr2-c2.launch): 1040 beams
  /// within +-130 degrees, 40 Hz. It is of the same make as the tilting one, so its noise is alike.
  static HokuyoConfig base_laser();

  /// Sets the angles to `count` beams about straight ahead. With an even count, there is one more
  /// beam to the right (negative angles).
  void set_beams(int count);

  /// Throws std::invalid_argument that names a wrong key and its range.
  void validate() const;
};

/// Returns T_map_laser, the pose of the laser, at a time.
using LaserPose = std::function<Pose(Time)>;

/// A Hokuyo UTM-30LX. Beams lie on steps of 0.25 degrees, counted as hokuyo_node does. One turn
/// takes 25 ms at any rate; a lower rate skips turns. Each beam is cast from the pose of the laser
/// at that beam's own time.
class Hokuyo {
 public:
  /// Prepares the beams. Throws std::invalid_argument if the configuration is not valid.
  Hokuyo(const HokuyoConfig& config, std::uint64_t seed);

  /// Returns the line whose first beam is fired at `stamp`. Its noise depends on the seed and the
  /// stamp alone, so lines may be made in any order and by several threads.
  Scan scan(const World& world, Time stamp, const LaserPose& T_map_laser) const;

  /// Returns the number of beams of a line.
  int beam_count() const { return last_step_ - first_step_ + 1; }
  /// Returns the angle of the first beam.
  double angle_min_rad() const { return first_step_ * config_.angle_increment_rad; }
  /// Returns the time from line to line.
  Time period() const;
  /// Returns the time from the first beam of a line to its last.
  Time sweep_time() const;
  /// Returns the time of a beam after the stamp of its line.
  Time beam_time(int beam) const { return times_[beam]; }

 private:
  /// Returns ranges without noise but with mixed pixels.
  std::vector<double> mixed_ranges_m(const World& world, const Scan& scan,
                                     const LaserPose& T_map_laser, std::mt19937_64& random) const;
  float measured_m(double range_m, double normal) const;

  HokuyoConfig config_;
  std::uint64_t seed_;
  int first_step_, last_step_;               ///< counted from straight ahead
  std::vector<Eigen::Vector2d> directions_;  ///< of the beams: x and y in the laser's frame
  std::vector<Time> times_;                  ///< of the beams, after the stamp
};

}  // namespace ribbon_mapper::sim
