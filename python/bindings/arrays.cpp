// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "python/bindings/arrays.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

#include "modeler/geometry/pose_defect.hpp"

namespace ribbon_mapper::python {
namespace {

constexpr double kQuaternionTolerance = 0.01;  // as in TUM files
using RowMajorMatrix = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

constexpr py::ssize_t kMatrixSize = 16, kVectorSize = 7;
constexpr const char* kShapesOfPose = "(4, 4), or (7,) for x, y, z, qx, qy, qz, qw";

// Aligned, as they are read by pointers: a view of a packed record is copied.
constexpr int kArrayFlags =
    py::array::c_style | py::array::forcecast | py::detail::npy_api::NPY_ARRAY_ALIGNED_;
template <typename Number>
using Array = py::array_t<Number, kArrayFlags>;

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
  throw std::invalid_argument(name + " " + why);
}

std::string text_of(const py::handle& value) { return py::str(value).cast<std::string>(); }

/// Returns an argument as an array of real numbers in the order of C.
template <typename Number>
Array<Number> numbers_of(const py::object& argument, const std::string& name) {
  const py::array given = py::array::ensure(argument);
  if (!given) refuse(name, "must be an array of numbers");
  const char kind = given.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u') {
    refuse(name, "must be an array of numbers, not of " + text_of(given.dtype()));
  }
  Array<Number> numbers = Array<Number>::ensure(given);
  if (!numbers) throw py::error_already_set();
  return numbers;
}

[[noreturn]] void refuse_shape(const std::string& name, const std::string& wanted,
                               const py::array& given) {
  refuse(name, "must have the shape " + wanted + ", not " + text_of(given.attr("shape")));
}

/// Returns the pose of a matrix whose rows follow each other, or of a vector; nothing and why not.
std::optional<std::string> read_pose(const double* numbers, bool is_matrix, Pose& pose) {
  if (is_matrix) {
    const Eigen::Map<const RowMajorMatrix> matrix(numbers);
    pose.matrix() = matrix;
    if (matrix.allFinite() && matrix.row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0)) {
      return "has a last row that is not 0, 0, 0, 1";
    }
    return find_defect(pose);
  }
  const Eigen::Quaterniond rotation(numbers[6], numbers[3], numbers[4], numbers[5]);
  if (std::abs(rotation.norm() - 1.0) > kQuaternionTolerance) {
    return "has a quaternion (qx, qy, qz, qw) that is not of unit length";
  }
  pose = Pose::Identity();
  pose.linear() = rotation.normalized().toRotationMatrix();
  pose.translation() << numbers[0], numbers[1], numbers[2];
  return find_defect(pose);
}

/// Returns the poses that an array holds in its last dimensions.
std::vector<Pose> read_poses(const Array<double>& numbers, bool is_matrix,
                             const std::string& name) {
  const py::ssize_t size = is_matrix ? kMatrixSize : kVectorSize;
  std::vector<Pose> poses(static_cast<std::size_t>(numbers.size() / size));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double* const begin = numbers.data() + static_cast<py::ssize_t>(i) * size;
    if (const auto defect = read_pose(begin, is_matrix, poses[i])) {
      refuse(poses.size() == 1 ? name : name + ", pose " + std::to_string(i) + ",", *defect);
    }
  }
  return poses;
}

/// Returns whether the last dimensions, from `dimension` on, are those of a matrix; nothing if they
/// are those of no pose.
std::optional<bool> is_matrix(const py::array& numbers, py::ssize_t dimension) {
  const py::ssize_t left = numbers.ndim() - dimension;
  if (left == 2 && numbers.shape(dimension) == 4 && numbers.shape(dimension + 1) == 4) return true;
  if (left == 1 && numbers.shape(dimension) == kVectorSize) return false;
  return std::nullopt;
}

std::vector<Time> stamps_of(const py::object& argument, const std::string& name) {
  const py::array given = py::array::ensure(argument);
  if (!given || given.ndim() != 1) refuse(name, "must be an array of one dimension");
  const char kind = given.dtype().kind();
  if (given.size() > 0 && kind != 'i' && kind != 'u') {
    refuse(name, "must be whole nanoseconds (int64), not " + text_of(given.dtype()) +
                     ": np.round(seconds * 1e9).astype(np.int64)");
  }
  const Array<std::int64_t> numbers = Array<std::int64_t>::ensure(given);
  if (!numbers) throw py::error_already_set();
  std::vector<Time> stamps;
  for (py::ssize_t i = 0; i < numbers.size(); ++i) stamps.emplace_back(numbers.data()[i]);
  return stamps;
}

template <typename Numbers>
py::array_t<double> copied(std::vector<py::ssize_t> shape, const Numbers* source,
                           std::size_t size) {
  py::array_t<double> result(std::move(shape));
  std::copy_n(source, size, result.mutable_data());
  return result;
}

}  // namespace

std::vector<float> ranges_of(const py::object& argument, const char* name) {
  const Array<float> numbers = numbers_of<float>(argument, name);
  if (numbers.ndim() != 1) refuse_shape(name, "(n,)", numbers);
  return {numbers.data(), numbers.data() + numbers.size()};
}

Time stamp_of(const py::object& argument, const char* name) {
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(argument.ptr()));
  if (!number) {
    PyErr_Clear();
    refuse(name, "must be an int of nanoseconds, not " + text_of(py::type::of(argument)) +
                     ": round(seconds * 1e9)");
  }
  int overflow = 0;
  const long long value = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
  if (overflow != 0) refuse(name, "is too large for nanoseconds of 64 bits");
  return Time(value);
}

Pose pose_of(const py::object& argument, const char* name) {
  const Array<double> numbers = numbers_of<double>(argument, name);
  const std::optional<bool> matrix = is_matrix(numbers, 0);
  if (!matrix) refuse_shape(name, kShapesOfPose, numbers);
  return read_poses(numbers, *matrix, name).front();
}

std::pair<Pose, Pose> first_and_last_pose_of(const py::object& argument, const char* name) {
  const Array<double> numbers = numbers_of<double>(argument, name);
  const bool is_pair = numbers.ndim() > 0 && numbers.shape(0) == 2;
  const std::optional<bool> matrix = is_matrix(numbers, is_pair ? 1 : 0);
  if (!matrix) {
    refuse_shape(name, std::string(kShapesOfPose) + ", or two of them: (2, 4, 4) or (2, 7)",
                 numbers);
  }
  const std::vector<Pose> poses = read_poses(numbers, *matrix, name);
  return {poses.front(), poses.back()};
}

std::vector<StampedPose> trajectory_of(const py::object& stamps_ns, const py::object& poses) {
  const std::vector<Time> stamps = stamps_of(stamps_ns, "stamps_ns");
  const Array<double> numbers = numbers_of<double>(poses, "poses");
  const std::optional<bool> matrix = is_matrix(numbers, 1);
  if (!matrix && numbers.size() > 0) {
    refuse_shape("poses", "(n, 4, 4), or (n, 7) for x, y, z, qx, qy, qz, qw", numbers);
  }
  const std::vector<Pose> read = read_poses(numbers, matrix.value_or(true), "poses");
  if (read.size() != stamps.size()) {
    refuse("poses", "are " + std::to_string(read.size()) + ", but there are " +
                        std::to_string(stamps.size()) + " stamps");
  }
  std::vector<StampedPose> trajectory;
  for (std::size_t i = 0; i < read.size(); ++i) trajectory.push_back({stamps[i], read[i]});
  return trajectory;
}

py::tuple to_python(const std::vector<StampedPose>& trajectory) {
  const auto count = static_cast<py::ssize_t>(trajectory.size());
  py::array_t<std::int64_t> stamps(count);
  py::array_t<double> poses(std::vector<py::ssize_t>{count, 4, 4});
  std::int64_t* stamp = stamps.mutable_data();
  double* pose = poses.mutable_data();
  for (const StampedPose& each : trajectory) {
    *stamp++ = each.stamp.count();
    const RowMajorMatrix matrix = each.T_map_base.matrix();
    pose = std::copy_n(matrix.data(), kMatrixSize, pose);
  }
  return py::make_tuple(stamps, poses);
}

py::array_t<double> to_python(const std::vector<Eigen::Vector3d>& points) {
  static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double));
  return copied({static_cast<py::ssize_t>(points.size()), 3},
                points.empty() ? nullptr : points.front().data(), 3 * points.size());
}

py::array_t<double> to_python(const Eigen::Vector3d& vector) {
  return copied({3}, vector.data(), 3);
}

py::array_t<double> to_python(const Eigen::Matrix3d& matrix) {
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = matrix;
  return copied({3, 3}, rows.data(), 9);
}

std::string path_of(const py::object& argument) {
  return py::module_::import("os").attr("fsencode")(argument).cast<std::string>();
}

}  // namespace ribbon_mapper::python
