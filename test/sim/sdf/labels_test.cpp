// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// <ribbon_mapper:label>: what a shape is.
#include "test/sim/sdf/world_file.hpp"

namespace ribbon_mapper::sim {
namespace {

using Labels = WorldFile;

std::string label(const std::string& text) {
  return "<ribbon_mapper:label>" + text + "</ribbon_mapper:label>";
}

std::string collision(const std::string& name, const std::string& content) {
  return "<collision name='" + name + "'>" + content +
         "<geometry><box><size>1 1 1</size></box></geometry></collision>";
}

/// Returns the label of the faces whose names hold `part`.
std::string label_in(const World& world, const std::string& part) {
  for (const Face& face : world.faces()) {
    if (face.name.find(part) != std::string::npos) return face.label;
  }
  return "no face " + part;
}

TEST_F(Labels, AreThoseOfTheNearestElementAbove) {
  const World world =
      load("<model name='m'><static>1</static>" + label("wall") + "<link name='l'>" +
           collision("a", "") + collision("b", label(" floor ")) + "</link><link name='k'>" +
           label("slope") + collision("c", "") + "</link></model><model name='n'><link name='l'>" +
           collision("d", "") + "</link></model>");
  EXPECT_EQ("wall", label_in(world, "::a/"));
  EXPECT_EQ("floor", label_in(world, "::b/"));
  EXPECT_EQ("slope", label_in(world, "::c/"));
  EXPECT_EQ("", label_in(world, "::d/"));
}

}  // namespace
}  // namespace ribbon_mapper::sim
