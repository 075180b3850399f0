// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// What the files of a model say beside its planes.
struct ModelLabel {
  std::string frame = "map";  ///< frame of all coordinates
  std::string run;            ///< id of the run, the same in all its files; empty: none is written
  /// Subtracted from all positions in PLY and OctoMap files, which are of single precision [m].
  /// Each file of the model states it if it is not zero.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
};

/// Returns an origin for planes far from zero [m]: their middle in whole kilometres, or 0 along an
/// axis on which they lie within 1 km of it.
Eigen::Vector3d origin_of(const std::vector<Plane>& planes);

/// Returns an id of a run that made these texts: 16 hexadecimal digits. The same texts give the
/// same id.
std::string run_id_of(const std::vector<std::string>& texts);

/// Returns the lines of a header after `prefix`, such as "comment ", that state run and origin.
std::string label_lines(const ModelLabel& label, const std::string& prefix);

/// Returns the text in one line of at most `max_size` bytes: control characters become spaces, and
/// a longer text ends in "...".
std::string in_one_line(std::string text, std::size_t max_size = 1000);

}  // namespace ribbon_mapper
