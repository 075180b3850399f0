// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/world_content.hpp"

#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace ribbon_mapper::sim {
namespace {

// A laser of 30 m range on a robot of 0.65 m. Outdoor worlds of Gazebo are up to a kilometre wide.
constexpr double kWidest_m = 2000.0;
constexpr double kHighest_m = 200.0;
constexpr double kNarrowest_m = 0.1;
constexpr double kFarthest_m = 10'000.0;
constexpr std::size_t kMostNames = 5;

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string size_text(const Eigen::AlignedBox3d& extent) {
  const Eigen::Vector3d size = extent.sizes();
  std::ostringstream text;
  text << std::setprecision(4) << size.x() << " x " << size.y() << " x " << size.z() << " m";
  return text.str();
}

/// Returns the first names, and how many there are more.
std::string listed(const std::set<std::string>& names) {
  std::string text;
  std::size_t count = 0;
  for (const std::string& name : names) {
    if (count == kMostNames) break;
    text += (count++ == 0 ? "" : ", ") + name.substr(0, 60);
  }
  if (names.size() > count) text += " and " + std::to_string(names.size() - count) + " more";
  return text;
}

std::string left_out_text(const SdfNotes& notes) {
  std::string text;
  const auto add = [&](const std::string& what) { text += (text.empty() ? "" : ", ") + what; };
  if (!notes.visual_only.empty())
    add(counted(notes.visual_only.size(), "model") + " without collision (" +
        listed(notes.visual_only) + "; --visuals takes their visuals, nodes: ~visuals)");
  for (const auto& [name, count] : notes.left_out) add(counted(count, name));
  return text.empty() ? "nothing" : text;
}

}  // namespace

Eigen::AlignedBox3d plausible_extent(const std::string& path, const Tessellation& tessellation) {
  Eigen::AlignedBox3d extent;
  bool is_finite = true;
  for (const Triangle& triangle : tessellation.triangles)
    for (const Eigen::Vector3d& corner : triangle.corners_m) {
      is_finite = is_finite && corner.allFinite();
      if (tessellation.faces[triangle.face].bounded) extent.extend(corner);
    }
  const auto require = [&](bool condition, const std::string& what) {
    if (!condition) throw std::runtime_error("world " + path + ": " + what);
  };
  require(is_finite, "a corner of a shape is not finite; check the poses and meshes");
  if (extent.isEmpty()) return extent;
  const Eigen::Vector3d size = extent.sizes();
  require(size.maxCoeff() <= kWidest_m,
          "it spans " + size_text(extent) + ", too large for a laser of 30 m range; is it in " +
              "millimetres? SDF is in metres; scale meshes by <scale>0.001 0.001 0.001</scale>");
  require(size.maxCoeff() >= kNarrowest_m,
          "it spans " + size_text(extent) + ", less than a robot; SDF is in metres");
  require(extent.center().cwiseAbs().maxCoeff() <= kFarthest_m,
          "it lies more than 10 km from its origin; move its models there");
  return extent;
}

std::string content_text(const SdfShapes& sdf, const Eigen::AlignedBox3d& extent_m) {
  return counted(sdf.shapes.size(), "shape") +
         (extent_m.isEmpty() ? ", unbounded" : ", " + size_text(extent_m)) +
         "; left out: " + left_out_text(sdf.notes);
}

std::vector<std::string> warning_texts(const SdfNotes& notes, const Eigen::AlignedBox3d& extent_m) {
  std::vector<std::string> texts(notes.warnings.begin(), notes.warnings.end());
  if (texts.size() > kMostNames) {
    const std::size_t more = texts.size() - kMostNames;
    texts.resize(kMostNames);
    texts.push_back("and " + std::to_string(more) + " more such warnings");
  }
  if (notes.renamed > 0)
    texts.push_back(counted(notes.renamed, "element") + " of equal names renamed, as Gazebo does");
  if (!extent_m.isEmpty() && extent_m.sizes().z() > kHighest_m)
    texts.push_back("it spans " + size_text(extent_m) +
                    ", higher than a laser sees; is a mesh in millimetres?");
  return texts;
}

}  // namespace ribbon_mapper::sim
