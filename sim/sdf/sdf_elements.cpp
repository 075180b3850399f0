// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sdf/sdf_elements.hpp"

#include <algorithm>

namespace ribbon_mapper::sim {
namespace {

using tinyxml2::XMLElement;

/// Elements of SDF that no laser sees, and that whoever made them may look for.
const std::set<std::string> kThings{
    "actor",  "audio_sink", "audio_source",     "battery", "gripper",    "inertial",  "joint",
    "light",  "material",   "particle_emitter", "plugin",  "population", "projector", "road",
    "sensor", "visual"};

/// Elements of SDF that are settings.
const std::set<std::string> kSettings{"allow_auto_disable",
                                      "atmosphere",
                                      "audio",
                                      "cast_shadows",
                                      "enable_wind",
                                      "gravity",
                                      "gui",
                                      "kinematic",
                                      "laser_retro",
                                      "magnetic_field",
                                      "max_contacts",
                                      "meta",
                                      "must_be_base_link",
                                      "name",
                                      "physics",
                                      "placement_frame",
                                      "scene",
                                      "self_collide",
                                      "spherical_coordinates",
                                      "static",
                                      "surface",
                                      "transparency",
                                      "velocity_decay",
                                      "visibility_flags",
                                      "wind"};

/// Returns true if one letter is wrong, missing or too much, or two neighbours are exchanged.
bool is_nearly(const std::string& a, const std::string& b) {
  if (a.size() > b.size()) return is_nearly(b, a);
  const auto [in_a, in_b] = std::mismatch(a.begin(), a.end(), b.begin());
  if (a.size() + 1 == b.size()) return std::equal(in_a, a.end(), in_b + 1, b.end());
  if (a.size() != b.size() || in_a == a.end()) return false;
  if (std::equal(in_a + 1, a.end(), in_b + 1)) return true;
  return in_a + 1 != a.end() && in_a[0] == in_b[1] && in_a[1] == in_b[0] &&
         std::equal(in_a + 2, a.end(), in_b + 2);
}

bool holds_shape(const XMLElement& element) {
  static const std::set<std::string> kShapes{"box",      "collision", "cylinder",
                                             "geometry", "mesh",      "sphere"};
  bool holds = kShapes.count(element.Name()) > 0;
  for_each_child(element, [&](const XMLElement& child) { holds = holds || holds_shape(child); });
  return holds;
}

}  // namespace

void leave_out(const XMLElement& element, const ElementNames& read_here, const SdfScope& scope,
               SdfNotes& notes) {
  const std::string name = element.Name();
  if (kThings.count(name) > 0) ++notes.left_out[name];
  if (kThings.count(name) > 0 || kSettings.count(name) > 0) return;
  if (name.find(':') != std::string::npos) return;  // an element of another namespace
  const std::string tag = "<" + quoted(name) + ">";
  for (const std::string& known : read_here)
    if (is_nearly(name, known))
      scope.fail(element, "has " + tag + ": is <" + known + "> meant? Correct or remove it");
  if (holds_shape(element))
    scope.fail(element, "has a shape in " + tag + ", where none is read; correct or remove it");
  notes.warnings.insert(tag + " is unknown and was left out");
}

}  // namespace ribbon_mapper::sim
