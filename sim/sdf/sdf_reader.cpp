// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sdf/sdf_reader.hpp"

#include <algorithm>
#include <optional>
#include <sdf/sdf.hh>
#include <stdexcept>

#include "sim/sdf/seen_sdf.hpp"
#include "sim/shapes/mesh_file.hpp"

namespace ribbon_mapper::sim {
namespace {

using Eigen::Vector3d;
using Geometry = decltype(Shape::geometry);

constexpr std::size_t kLongestText = 600;

// libsdformat 13 took its mathematics to another namespace.
#if SDF_MAJOR_VERSION < 13
namespace math = ignition::math;
#else
namespace math = gz::math;
#endif

Vector3d to_eigen(const math::Vector3d& v) { return {v.X(), v.Y(), v.Z()}; }

Pose to_pose(const math::Pose3d& pose) {
  const math::Quaterniond& q = pose.Rot();
  Pose result = Pose::Identity();
  result.linear() = Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).normalized().toRotationMatrix();
  result.translation() = to_eigen(pose.Pos());
  return result;
}

std::string joined(const sdf::Errors& errors) {
  std::string text;
  for (const sdf::Error& error : errors) text += (text.empty() ? "" : "; ") + error.Message();
  return text.size() > kLongestText ? text.substr(0, kLongestText) + "..." : text;
}

// Sizes by the scale of a <state>, as Gazebo Classic computes them.
void enlarge(BoxShape& box, const Vector3d& scale) { box.size_m = box.size_m.cwiseProduct(scale); }
void enlarge(CylinderShape& cylinder, const Vector3d& scale) {
  cylinder.radius_m *= std::max(scale.x(), scale.y());
  cylinder.length_m *= scale.z();
}
void enlarge(SphereShape& sphere, const Vector3d& scale) { sphere.radius_m *= scale.maxCoeff(); }
void enlarge(PlaneShape&, const Vector3d&) {}
void enlarge(MeshShape& mesh, const Vector3d& scale) {
  for (Vector3d& vertex : mesh.vertices_m) vertex = vertex.cwiseProduct(scale);
}

/// Walks through models and links and collects their collisions.
class Reader {
 public:
  Reader(const std::string& path, const std::vector<std::string>& model_paths, bool visuals)
      : path_(path), seen_(seen_sdf(path, model_paths, visuals)) {}

  SdfShapes read() {
    const sdf::Root root = parsed();
    for (std::uint64_t i = 0; i < root.WorldCount(); ++i) {
      const sdf::World& world = *root.WorldByIndex(i);
      for (std::uint64_t m = 0; m < world.ModelCount(); ++m)
        add(*world.ModelByIndex(m), Pose::Identity(), "");
    }
    if (shapes_.empty()) fail("no collision shape in it; " + advice());
    return {std::move(shapes_), std::move(seen_.notes)};
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error("world " + path_ + ": " + what);
  }

  std::string advice() const {
    const std::size_t count = seen_.notes.visual_only.size();
    if (count == 0) return "a world needs models with <collision>";
    return std::to_string(count) + " of its models have visuals, no <collision>: take those by " +
           "--visuals (nodes: ~visuals), or add collisions";
  }

  sdf::Root parsed() const {
    sdf::Root root;
#if SDF_MAJOR_VERSION < 11
    const sdf::Errors errors = root.LoadSdfString(seen_.xml);
#else
    sdf::ParserConfig config;
    config.SetWarningsPolicy(sdf::EnforcementPolicy::WARN);
    const sdf::Errors errors = root.LoadSdfString(seen_.xml, config);
#endif
    if (!errors.empty()) fail(joined(errors) + " (check it with `ign sdf --check`)");
    return root;
  }

  template <typename Element>
  Pose pose_of(const Element& element) const {
    math::Pose3d pose;
    const sdf::Errors errors = element.SemanticPose().Resolve(pose);
    if (!errors.empty()) fail("pose of " + quoted(element.Name()) + ": " + joined(errors));
    return to_pose(pose);
  }

  void add(const sdf::Model& model, const Pose& T_map_parent, const std::string& prefix) {
    const std::string name = prefix + model.Name();
    const std::optional<Pose> by_state = seen_.state.T_map(name);
    const Pose T_map_model = by_state ? *by_state : T_map_parent * pose_of(model);
    for (std::uint64_t i = 0; i < model.LinkCount(); ++i)
      add(*model.LinkByIndex(i), T_map_model, name);
    for (std::uint64_t i = 0; i < model.ModelCount(); ++i)
      add(*model.ModelByIndex(i), T_map_model, name + "::");
  }

  void add(const sdf::Link& link, const Pose& T_map_model, const std::string& model) {
    const std::string link_name = model + "::" + link.Name();
    const std::optional<Pose> by_state = seen_.state.T_map(link_name);
    const Pose T_map_link = by_state ? *by_state : T_map_model * pose_of(link);
    for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
      const sdf::Collision& collision = *link.CollisionByIndex(i);
      Shape shape{link_name + "::" + collision.Name(), T_map_link * pose_of(collision),
                  geometry_of(*collision.Geom(), link_name + "::" + collision.Name()), ""};
      if (collision.Element()->HasElement(kLabelElement)) {
        const auto label = collision.Element()->GetElement(kLabelElement);
        shape.label = label->GetValue() ? label->Get<std::string>() : "";
      }
      std::visit([&](auto& s) { enlarge(s, seen_.state.scale(model)); }, shape.geometry);
      shapes_.push_back(std::move(shape));
    }
  }

  Geometry geometry_of(const sdf::Geometry& geometry, const std::string& name) const {
    switch (geometry.Type()) {
      case sdf::GeometryType::BOX:
        return BoxShape{to_eigen(geometry.BoxShape()->Size())};
      case sdf::GeometryType::CYLINDER:
        return CylinderShape{geometry.CylinderShape()->Radius(),
                             geometry.CylinderShape()->Length()};
      case sdf::GeometryType::SPHERE:
        return SphereShape{geometry.SphereShape()->Radius()};
      case sdf::GeometryType::PLANE:
        return PlaneShape{to_eigen(geometry.PlaneShape()->Normal())};
      case sdf::GeometryType::MESH:
        return mesh_of(*geometry.MeshShape(), name);
      default:
        fail(quoted(name) + " has a geometry that cannot be read");
    }
  }

  MeshShape mesh_of(const sdf::Mesh& mesh, const std::string& name) const {
    try {
      return load_mesh(mesh.Uri(), {mesh.Submesh(), mesh.CenterSubmesh(), to_eigen(mesh.Scale())});
    } catch (const std::runtime_error& error) {
      fail(quoted(name) + " needs the " + error.what());
    }
  }

  std::string path_;
  SeenSdf seen_;
  std::vector<Shape> shapes_;
};

}  // namespace

SdfShapes read_sdf(const std::string& path, const std::vector<std::string>& model_paths,
                   bool visuals) {
  return Reader(path, model_paths, visuals).read();
}

}  // namespace ribbon_mapper::sim
