// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/geometry/pose.hpp"
#include "modeler/model_file/byte_reader.hpp"
#include "modeler/model_file/byte_writer.hpp"

namespace ribbon_mapper {

/// Writes a pose as a matrix of three rows, bit by bit.
inline void write_matrix(const Pose& pose, ByteWriter& to) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) to.number(pose(row, column));
  }
}

/// Reads what write_matrix() has written, whatever it is. Throws as ByteReader.
inline Pose read_matrix(ByteReader& from) {
  Pose pose = Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) pose(row, column) = from.number<double>();
  }
  return pose;
}

}  // namespace ribbon_mapper
