// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sdf/seen_sdf.hpp"

#include <sdf/sdf_config.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "sim/sdf/model_files.hpp"
#include "sim/sdf/sdf_elements.hpp"
#include "sim/sdf/sdf_geometry.hpp"
#include "sim/sdf/unique_names.hpp"

namespace ribbon_mapper::sim {
namespace {

using tinyxml2::XMLElement;

constexpr const char* kVersion = SDF_MAJOR_VERSION < 12 ? "1.7" : "1.9";
constexpr std::size_t kMostIncludes = 10'000;
constexpr std::size_t kMostCollisions = 100'000;

/// Returns true if a link of the model has a child element `name`.
bool has_in_link(const XMLElement& model, const char* name) {
  bool has = false;
  for_each_child(model, [&](const XMLElement& child) {
    has = has || (child.Name() == std::string("link") && child.FirstChildElement(name) != nullptr);
  });
  return has;
}

XMLElement& add_named(XMLElement& to, const char* kind, const std::string& name) {
  XMLElement& element = *to.InsertNewChildElement(kind);
  element.SetAttribute("name", name.c_str());
  return element;
}

/// Copies attributes that refer to frames. Before SDF 1.8, "::" was part of a name.
void copy_reference(const char* value, XMLElement& to, const char* name, const SdfFile& file) {
  if (value == nullptr || *value == '\0') return;
  to.SetAttribute(name, file.version() < 108 ? without_colons(value).c_str() : value);
}

/// Copies the label of a collision. One without a label has that of its link, then of its models.
void copy_label(const XMLElement& from, XMLElement& collision) {
  for (const tinyxml2::XMLNode* at = &from; at != nullptr; at = at->Parent()) {
    const XMLElement* label = at->FirstChildElement(kLabelElement);
    if (label == nullptr) continue;
    collision.InsertNewChildElement(kLabelElement)->SetText(text_of(*label).c_str());
    return;
  }
}

/// Copies a file, element by element, into a new document.
class Builder {
 public:
  Builder(const std::string& path, const std::vector<std::string>& model_paths, bool visuals)
      : files_(path, model_paths), visuals_(visuals) {}

  SeenSdf build() {
    XMLElement& sdf = *xml_.NewElement("sdf");
    xml_.InsertEndChild(&sdf);
    sdf.SetAttribute("version", kVersion);
    XMLElement& world = add_named(sdf, "world", "default");
    const SdfScope scope{files_.world().path(), files_.world(), ""};
    for_each_child(scope.file.root(), [&](const XMLElement& child) {
      if (child.Name() == std::string("world"))
        add_world(child, world, scope);
      else
        add_placed(child, world, scope, {"world", "model"});
    });
    seen_.notes.renamed = make_names_unique(world);
    tinyxml2::XMLPrinter printer(nullptr, true);
    xml_.Print(&printer);
    seen_.xml = printer.CStr();
    return std::move(seen_);
  }

 private:
  void add_world(const XMLElement& from, XMLElement& to, const SdfScope& scope) {
    const XMLElement* state = from.FirstChildElement("state");
    if (state != nullptr) seen_.state.add(*state, scope);
    for_each_child(from, [&](const XMLElement& child) {
      if (child.Name() == std::string("state")) return;
      if (child.Name() == std::string("model") && seen_.state.is_deleted(name_of(child))) return;
      add_placed(child, to, scope, {"model", "include", "frame"});
    });
    const XMLElement* insertions = state ? state->FirstChildElement("insertions") : nullptr;
    if (insertions != nullptr)
      for_each_child(*insertions,
                     [&](const XMLElement& child) { add_placed(child, to, scope, {"model"}); });
  }

  /// Adds what may stand in a world and in a model.
  void add_placed(const XMLElement& from, XMLElement& to, const SdfScope& scope,
                  const ElementNames& read_here) {
    const std::string kind = from.Name();
    if (kind == "model")
      add_model(from, to, scope, nullptr, scope);
    else if (kind == "include")
      add_include(from, to, scope);
    else if (kind == "frame" || (kind == "joint" && scope.file.refers_to(name_of(from))))
      add_frame(from, to, scope);
    else
      leave_out(from, read_here, scope, seen_.notes);
  }

  /// Adds a model, placed and named by `include` if that is not null.
  void add_model(const XMLElement& from, XMLElement& to, const SdfScope& parent,
                 const XMLElement* include, const SdfScope& include_scope) {
    const XMLElement* name = include ? include->FirstChildElement("name") : nullptr;
    XMLElement& model =
        add_named(to, "model", name ? valid_name(text_of(*name), "model") : name_of(from));
    const SdfScope scope = parent.of(model);
    model.InsertNewChildElement("static")->SetText(true);
    place(from, model, scope, include, include_scope);
    const bool has_collision = has_in_link(from, "collision");
    const bool has_visual = has_in_link(from, "visual");
    const char* seen = has_collision || !visuals_ ? "collision" : "visual";
    if (!has_collision && has_visual && !visuals_) seen_.notes.visual_only.insert(scope.name);
    for_each_child(from, [&](const XMLElement& child) {
      if (child.Name() == std::string("pose")) return;
      if (child.Name() == std::string("link"))
        add_link(child, model, scope, seen);
      else
        add_placed(child, model, scope, {"pose", "link", "model", "include", "frame"});
    });
  }

  static void place(const XMLElement& from, XMLElement& model, const SdfScope& scope,
                    const XMLElement* include, const SdfScope& include_scope) {
    const bool is_placed = include != nullptr && include->FirstChildElement("pose") != nullptr;
    copy_pose(is_placed ? *include : from, model, is_placed ? include_scope : scope);
    const XMLElement* frame = include ? include->FirstChildElement("placement_frame") : nullptr;
    if (frame != nullptr)
      copy_reference(text_of(*frame).c_str(), model, "placement_frame", scope.file);
    else
      copy_reference(from.Attribute("placement_frame"), model, "placement_frame", scope.file);
  }

  /// Adds a frame. A joint is the frame of its child link.
  static void add_frame(const XMLElement& from, XMLElement& to, const SdfScope& parent) {
    XMLElement& frame = add_named(to, "frame", name_of(from));
    const XMLElement* child = from.FirstChildElement("child");
    copy_reference(child ? text_of(*child).c_str() : from.Attribute("attached_to"), frame,
                   "attached_to", parent.file);
    copy_pose(from, frame, parent.of(from));
  }

  /// Adds a link with its children of the kind `seen`, collision or visual.
  void add_link(const XMLElement& from, XMLElement& to, const SdfScope& parent, const char* seen) {
    const SdfScope scope = parent.of(from);
    XMLElement& link = add_named(to, "link", name_of(from));
    copy_pose(from, link, scope);
    for_each_child(from, [&](const XMLElement& child) {
      if (child.Name() == std::string("pose")) return;
      if (child.Name() == std::string(seen))
        add_collision(child, link, scope);
      else
        leave_out(child, {"pose", "collision", "visual"}, scope, seen_.notes);
    });
  }

  void add_collision(const XMLElement& from, XMLElement& to, const SdfScope& parent) {
    const SdfScope scope = parent.of(from);
    if (++collisions_ > kMostCollisions)
      scope.fail(from, "is one collision too many: " + std::to_string(kMostCollisions) +
                           " are read; divide the world");
    XMLElement& collision = add_named(to, "collision", name_of(from));
    copy_pose(from, collision, scope);
    copy_label(from, collision);
    for_each_child(from, [&](const XMLElement& child) {
      if (child.Name() != std::string("pose") && child.Name() != std::string("geometry"))
        leave_out(child, {"pose", "geometry"}, scope, seen_.notes);
    });
    const XMLElement* geometry = from.FirstChildElement("geometry");
    const auto find_mesh = [&](const std::string& uri) {
      return files_.find(uri, scope.file.folder());
    };
    XMLElement& copy = *collision.InsertNewChildElement("geometry");
    if (geometry != nullptr && copy_geometry(*geometry, copy, scope, find_mesh)) return;
    ++seen_.notes.left_out["empty collision"];
    to.DeleteChild(&collision);
  }

  void add_include(const XMLElement& include, XMLElement& to, const SdfScope& scope) {
    for_each_child(include, [&](const XMLElement& child) {
      const std::string kind = child.Name();
      if (kind != "uri" && kind != "pose")
        leave_out(child, {"uri", "pose", "name"}, scope, seen_.notes);
    });
    const XMLElement* uri = include.FirstChildElement("uri");
    if (uri == nullptr) scope.fail(include, "has an <include> without <uri>; add it");
    if (++includes_ > kMostIncludes || open_files_.size() > 20)
      scope.fail(include, "includes too many models: does one include itself?");
    const SdfFile* file = files_.model(text_of(*uri), scope, *uri);
    if (file == nullptr) {
      ++seen_.notes.left_out["light"];
      return;
    }
    const XMLElement* model = file->root().FirstChildElement("model");
    if (model == nullptr) {
      for_each_child(file->root(), [&](const XMLElement& child) {
        leave_out(child, {"model"}, {scope.world, *file, scope.name}, seen_.notes);
      });
      return;
    }
    open_files_.push_back(file);
    add_model(*model, to, {scope.world, *file, scope.name}, &include, scope);
    open_files_.pop_back();
  }

  ModelFiles files_;
  bool visuals_;
  tinyxml2::XMLDocument xml_;
  SeenSdf seen_;
  std::size_t includes_ = 0, collisions_ = 0;
  std::vector<const SdfFile*> open_files_;
};

}  // namespace

SeenSdf seen_sdf(const std::string& path, const std::vector<std::string>& model_paths,
                 bool visuals) {
  return Builder(path, model_paths, visuals).build();
}

}  // namespace ribbon_mapper::sim
