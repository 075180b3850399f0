// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sdf/sdf_geometry.hpp"

#include <algorithm>
#include <map>

namespace ribbon_mapper::sim {
namespace {

using tinyxml2::XMLElement;

/// An element of a shape.
struct Part {
  std::string name;
  std::size_t numbers;  ///< 0 for other content
  NumberRange range;
  bool is_required;
};

const std::map<std::string, std::vector<Part>>& shapes() {
  static const std::map<std::string, std::vector<Part>> kShapes{
      {"empty", {}},
      {"box", {{"size", 3, kLength_m, true}}},
      {"cylinder", {{"radius", 1, kLength_m, true}, {"length", 1, kLength_m, true}}},
      {"sphere", {{"radius", 1, kLength_m, true}}},
      {"plane", {{"normal", 3, kCoordinate_m, false}, {"size", 0, {}, false}}},
      {"mesh",
       {{"uri", 0, {}, true}, {"scale", 3, kCoordinate_m, false}, {"submesh", 0, {}, false}}},
      {"submesh", {{"name", 0, {}, true}, {"center", 0, {}, false}}}};
  return kShapes;
}

std::string tag(const std::string& name) { return "<" + name + ">"; }

XMLElement& add(XMLElement& to, const char* name, const std::string& text) {
  XMLElement& element = *to.InsertNewChildElement(name);
  element.SetText(text.c_str());
  return element;
}

/// Copies the elements that are numbers. Checks the presence of all.
void copy_parts(const XMLElement& shape, XMLElement& to, const SdfScope& scope) {
  const std::vector<Part>& parts = shapes().at(shape.Name());
  for_each_child(shape, [&](const XMLElement& child) {
    const std::string name = child.Name();
    if (name.find(':') != std::string::npos) return;  // an element of another namespace
    const auto part = std::find_if(parts.begin(), parts.end(),
                                   [&](const Part& known) { return known.name == name; });
    if (part == parts.end())
      scope.fail(child, "has " + tag(quoted(name)) + ", which " + tag(shape.Name()) +
                            " does not know; correct or remove it");
    if (shape.FirstChildElement(child.Name()) != &child)
      scope.fail(child, "has " + tag(name) + " twice; remove one");
    if (part->numbers == 0) return;
    scope.numbers(child, part->numbers, part->range);
    add(to, child.Name(), text_of(child));
  });
  for (const Part& part : parts)
    if (part.is_required && shape.FirstChildElement(part.name.c_str()) == nullptr)
      scope.fail(shape, "has a " + tag(shape.Name()) + " without " + tag(part.name) + "; add it");
}

void require_not_zero(const XMLElement& shape, const char* name, const SdfScope& scope,
                      bool in_any) {
  const XMLElement* element = shape.FirstChildElement(name);
  if (element == nullptr) return;
  const std::vector<double> values = scope.numbers(*element, 3, kCoordinate_m);
  const auto zeros = std::count(values.begin(), values.end(), 0.0);
  if (zeros == 3 || (in_any && zeros > 0))
    scope.fail(*element, "has " + tag(name) + " " + quoted(text_of(*element)) +
                             ": must not be 0; correct it");
}

void copy_mesh(const XMLElement& mesh, XMLElement& to, const SdfScope& scope,
               const FindFile& find_mesh) {
  require_not_zero(mesh, "scale", scope, true);
  const XMLElement& uri = *mesh.FirstChildElement("uri");
  const std::string path = find_mesh(text_of(uri));
  if (path.empty())
    scope.fail(uri, "needs the mesh " + quoted(text_of(uri)) +
                        ", which was not found; add the folder that holds it to the model path "
                        "(--model-path, GAZEBO_MODEL_PATH)");
  add(to, "uri", path);
  const XMLElement* submesh = mesh.FirstChildElement("submesh");
  if (submesh == nullptr) return;
  XMLElement& copy = *to.InsertNewChildElement("submesh");
  copy_parts(*submesh, copy, scope);
  add(copy, "name", text_of(*submesh->FirstChildElement("name")));
  const XMLElement* center = submesh->FirstChildElement("center");
  const std::string is_centred = center ? text_of(*center) : "false";
  add(copy, "center", is_centred == "1" || is_centred == "true" ? "true" : "false");
}

}  // namespace

bool copy_geometry(const XMLElement& geometry, XMLElement& to, const SdfScope& scope,
                   const FindFile& find_mesh) {
  const XMLElement* shape = geometry.FirstChildElement();
  if (shape == nullptr) return false;
  const std::string name = shape->Name();
  if (name == "submesh" || shapes().count(name) == 0)
    scope.fail(*shape, "has a geometry other than box, cylinder, sphere, plane or mesh: " +
                           tag(quoted(name)) +
                           "; replace it by one of these (a heightmap: export it as a mesh)");
  if (shape->NextSiblingElement() != nullptr)
    scope.fail(*shape, "has two shapes in one geometry; make each a collision of its own");
  if (name == "empty") return false;
  XMLElement& copy = *to.InsertNewChildElement(name.c_str());
  copy_parts(*shape, copy, scope);
  if (name == "mesh") copy_mesh(*shape, copy, scope, find_mesh);
  if (name == "plane") {
    require_not_zero(*shape, "normal", scope, false);
    add(copy, "size", "1 1");  // for display only
  }
  return true;
}

void copy_pose(const XMLElement& from, XMLElement& to, const SdfScope& scope) {
  const XMLElement* pose = from.FirstChildElement("pose");
  if (pose == nullptr) return;
  const SdfFile& file = scope.file;
  const char* relative_to = pose->Attribute(file.version() < 107 ? "frame" : "relative_to");
  const bool is_relative = relative_to != nullptr && *relative_to != '\0';
  const char* format = pose->Attribute("rotation_format");
  const bool is_quaternion = format != nullptr && std::string(format) == "quat_xyzw";
  if (text_of(*pose).empty() && !is_relative) return;
  XMLElement& copy = *to.InsertNewChildElement("pose");
  if (!text_of(*pose).empty()) {
    scope.numbers(*pose, is_quaternion ? 7 : 6, kCoordinate_m);
    copy.SetText(text_of(*pose).c_str());
  }
  if (is_relative)  // before SDF 1.8, "::" was part of a name
    copy.SetAttribute("relative_to",
                      file.version() < 108 ? without_colons(relative_to).c_str() : relative_to);
  for (const char* name : {"rotation_format", "degrees"})
    if (const char* value = pose->Attribute(name)) copy.SetAttribute(name, value);
}

}  // namespace ribbon_mapper::sim
