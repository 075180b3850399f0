// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "modeler/geometry/pose.hpp"

/// The Python module: conversions of arguments and results, and the classes that Python sees.
///
/// Arguments are anything that numpy makes an array of: of any layout, and of any type of real
/// numbers. What has another type or shape is refused by std::invalid_argument, in Python a
/// ValueError, which names the argument.
namespace ribbon_mapper::python {

namespace py = pybind11;

/// Converts an argument to the ranges of a line [m].
std::vector<float> ranges_of(const py::object& argument, const char* name);

/// Converts an int of nanoseconds.
Time stamp_of(const py::object& argument, const char* name);

/// Converts a pose: a 4 x 4 matrix, or the seven numbers x, y, z, qx, qy, qz, qw. The quaternion
/// is normalised; its length may be off by 1 %.
Pose pose_of(const py::object& argument, const char* name);

/// Converts a pair of poses, at the first and the last beam, or one pose that holds for both.
std::pair<Pose, Pose> first_and_last_pose_of(const py::object& argument, const char* name);

/// Converts an array of whole nanoseconds and as many poses.
std::vector<StampedPose> trajectory_of(const py::object& stamps_ns, const py::object& poses);

/// Returns the stamps [ns] and the poses, of shape (n, 4, 4).
py::tuple to_python(const std::vector<StampedPose>& trajectory);

/// Returns points as an array of shape (n, 3).
py::array_t<double> to_python(const std::vector<Eigen::Vector3d>& points);

/// Returns a vector as an array of shape (3,).
py::array_t<double> to_python(const Eigen::Vector3d& vector);

/// Returns a matrix as an array of shape (3, 3).
py::array_t<double> to_python(const Eigen::Matrix3d& matrix);

/// Converts the path of a file: str, bytes or os.PathLike. Throws TypeError otherwise.
std::string path_of(const py::object& argument);

}  // namespace ribbon_mapper::python
