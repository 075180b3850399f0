// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/sdf_reader.hpp"

#include <filesystem>
#include <optional>
#include <sdf/sdf.hh>
#include <stdexcept>

#include "sim/shapes/mesh_file.hpp"
#include "sim/world/resource_finder.hpp"

namespace ribbon_mapper::sim {
namespace {

namespace fs = std::filesystem;
using Geometry = decltype(Shape::geometry);

Eigen::Vector3d to_eigen(const ignition::math::Vector3d& v) { return {v.X(), v.Y(), v.Z()}; }

Pose to_pose(const ignition::math::Pose3d& pose) {
  const ignition::math::Quaterniond& q = pose.Rot();
  Pose result = Pose::Identity();
  result.linear() = Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).normalized().toRotationMatrix();
  result.translation() = to_eigen(pose.Pos());
  return result;
}

std::string joined(const sdf::Errors& errors) {
  std::string text;
  for (const sdf::Error& error : errors) text += (text.empty() ? "" : "; ") + error.Message();
  return text;
}

/// Walks through worlds, models and links and collects their collisions.
class Reader {
 public:
  Reader(std::string path, std::vector<std::string> model_paths)
      : path_(std::move(path)),
        folder_(fs::absolute(path_).parent_path().string()),
        model_paths_(std::move(model_paths)) {}

  std::vector<Shape> read() {
    if (!fs::is_regular_file(path_)) fail("no such file; give the path of an SDF world");
    const sdf::Root root = parsed();
    for (std::uint64_t i = 0; i < root.WorldCount(); ++i) {
      const sdf::World& world = *root.WorldByIndex(i);
      for (std::uint64_t m = 0; m < world.ModelCount(); ++m)
        add(*world.ModelByIndex(m), Pose::Identity(), "");
    }
    if (root.Model()) add(*root.Model(), Pose::Identity(), "");
    if (shapes_.empty()) fail("no collision shape in it; a world needs models with <collision>");
    return std::move(shapes_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error("world " + path_ + ": " + what);
  }

  sdf::Root parsed() const {
    sdf::ParserConfig config;
    config.SetWarningsPolicy(sdf::EnforcementPolicy::LOG);
    config.SetFindCallback(
        [this](const std::string& uri) { return find_resource(uri, folder_, model_paths_); });
    sdf::Root root;
    const sdf::Errors errors = root.Load(path_, config);
    if (!errors.empty())
      fail(joined(errors) + " (check it with `ign sdf --check`; models of includes are looked up " +
           "beside the file and in the model path)");
    return root;
  }

  template <typename Element>
  Pose pose_of(const Element& element) const {
    ignition::math::Pose3d pose;
    const sdf::Errors errors = element.SemanticPose().Resolve(pose);
    if (!errors.empty()) fail("pose of '" + element.Name() + "': " + joined(errors));
    return to_pose(pose);
  }

  void add(const sdf::Model& model, const Pose& T_map_parent, const std::string& prefix) {
    const Pose T_map_model = T_map_parent * pose_of(model);
    const std::string name = prefix + model.Name() + "::";
    for (std::uint64_t i = 0; i < model.LinkCount(); ++i)
      add(*model.LinkByIndex(i), T_map_model, name);
    for (std::uint64_t i = 0; i < model.ModelCount(); ++i)
      add(*model.ModelByIndex(i), T_map_model, name);
  }

  void add(const sdf::Link& link, const Pose& T_map_model, const std::string& prefix) {
    const Pose T_map_link = T_map_model * pose_of(link);
    for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
      const sdf::Collision& collision = *link.CollisionByIndex(i);
      const std::string name = prefix + link.Name() + "::" + collision.Name();
      if (const std::optional<Geometry> geometry = geometry_of(*collision.Geom(), name))
        shapes_.push_back({name, T_map_link * pose_of(collision), *geometry});
    }
  }

  std::optional<Geometry> geometry_of(const sdf::Geometry& geometry,
                                      const std::string& name) const {
    switch (geometry.Type()) {
      case sdf::GeometryType::EMPTY:
        return std::nullopt;
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
        fail("'" + name + "' has a geometry other than box, cylinder, sphere, plane or mesh; " +
             "replace it by one of these");
    }
  }

  MeshShape mesh_of(const sdf::Mesh& mesh, const std::string& name) const {
    const fs::path holder = mesh.FilePath();
    const std::string base = holder.empty() ? folder_ : fs::absolute(holder).parent_path().string();
    const std::string file = find_resource(mesh.Uri(), base, model_paths_);
    if (file.empty())
      fail("mesh '" + mesh.Uri() + "' of '" + name + "' not found; add the folder that holds it " +
           "to the model path (--model-path, GAZEBO_MODEL_PATH)");
    return load_mesh(file, {mesh.Submesh(), mesh.CenterSubmesh(), to_eigen(mesh.Scale())});
  }

  std::string path_, folder_;
  std::vector<std::string> model_paths_;
  std::vector<Shape> shapes_;
};

}  // namespace

std::vector<Shape> read_sdf(const std::string& path, const std::vector<std::string>& model_paths) {
  return Reader(path, model_paths).read();
}

}  // namespace ribbon_mapper::sim
