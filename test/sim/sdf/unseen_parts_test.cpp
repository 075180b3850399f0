// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a laser never sees does not matter, however wrong it is.
#include "test/sim/sdf/world_file.hpp"

namespace ribbon_mapper::sim {
namespace {

using testing::HasSubstr;

/// Something that no laser sees, in the place where it belongs.
struct Unseen {
  std::string name, place, xml;
};

std::ostream& operator<<(std::ostream& stream, const Unseen& unseen) {
  return stream << unseen.name;
}

std::string visual(const std::string& content) {
  return "<visual name='v'>" + content + "</visual>";
}

std::string joint(const std::string& type, const std::string& child) {
  return "<joint name='j' type='" + type + "'><parent>world</parent><child>" + child +
         "</child></joint>";
}

const std::string kBox = "<geometry><box><size>1 1 1</size></box></geometry>";
const std::string kInertia =
    "<inertia><ixx>0.02</ixx><ixy>0</ixy><ixz>0</ixz><iyy>0.04</iyy><iyz>0</iyz><izz>1.0</izz>"
    "</inertia>";

const std::vector<Unseen> kUnseen{
    {"script_without_uri", "link", visual(kBox + "<material><script/></material>")},
    {"colour_of_words", "link", visual(kBox + "<material><ambient>red</ambient></material>")},
    {"shader_without_type", "link", visual(kBox + "<material><shader type='x'/></material>")},
    {"visual_without_geometry", "link", visual("")},
    {"visual_of_a_missing_mesh", "link",
     visual("<geometry><mesh><uri>no.dae</uri></mesh></geometry>")},
    {"visual_pose_of_words", "link", visual("<pose>a b c</pose>" + kBox)},
    {"visual_of_no_size", "link", visual("<geometry><box/></geometry>")},
    {"visual_size_nan", "link", visual("<geometry><box><size>nan 1 1</size></box></geometry>")},
    {"visuals_of_equal_names", "link", visual(kBox) + visual(kBox)},
    {"visual_heightmap", "link",
     visual("<geometry><heightmap><uri>h.png</uri></heightmap></geometry>")},
    {"inertia_of_no_body", "link", "<inertial><mass>6</mass>" + kInertia + "</inertial>"},
    {"negative_mass", "link", "<inertial><mass>-1</mass></inertial>"},
    {"mass_of_words", "link", "<inertial><mass>heavy</mass></inertial>"},
    {"inertial_pose_cut", "link", "<inertial><pose>0 0</pose></inertial>"},
    {"sensor_of_no_type", "link", "<sensor name='s'/>"},
    {"sensor_of_unknown_type", "link", "<sensor name='s' type='nose'/>"},
    {"light_of_unknown_type", "world", "<light name='l' type='laser'/>"},
    {"light_without_name", "world", "<light type='point'/>"},
    {"lights_of_equal_names", "world",
     "<light name='l' type='point'/><light name='l' type='point'/>"},
    {"sky_at_noon", "world", "<scene><sky><time>noon</time></sky></scene>"},
    {"scene_of_words", "world", "<scene><ambient>dark</ambient><shadows>some</shadows></scene>"},
    {"physics_of_unknown_type", "world",
     "<physics type='aether'><max_step_size>x</max_step_size></physics>"},
    {"physics_twice", "world",
     "<physics name='p' default='1' type='ode'/><physics name='p' default='1' type='ode'/>"},
    {"gravity_of_words", "world", "<gravity>down</gravity>"},
    {"wind_of_words", "world", "<wind><linear_velocity>north</linear_velocity></wind>"},
    {"audio_without_device", "world", "<audio/>"},
    {"plugin_without_file", "world", "<plugin name='p'/>"},
    {"plugin_of_anything", "world", "<plugin filename='p.so'><box/><collision/></plugin>"},
    {"gui_of_words", "world", "<gui><camera name='c'><pose>far</pose></camera></gui>"},
    {"coordinates_on_mars", "world",
     "<spherical_coordinates><surface_model>MARS</surface_model></spherical_coordinates>"},
    {"actor_without_skin", "world", "<actor name='walker'><pose>here</pose></actor>"},
    {"road_of_no_width", "world", "<road name='r'><width>wide</width></road>"},
    {"element_of_nobody", "world", "<favourite_colour>blue</favourite_colour>"},
    {"element_of_a_namespace", "world", "<ignition:shop xmlns:ignition='x'>1</ignition:shop>"},
    {"joint_without_child", "model", joint("fixed", "nothing")},
    {"joint_of_unknown_type", "model", joint("rubber", "link")},
    {"joint_without_axis", "model", joint("revolute", "link")},
    {"joint_of_itself", "model",
     "<joint name='j' type='fixed'><parent>link</parent><child>link</child></joint>"},
    {"gripper_without_palm", "model", "<gripper name='g'/>"},
    {"static_perhaps", "model", "<static>perhaps</static>"},
    {"collide_perhaps", "model", "<self_collide>perhaps</self_collide>"},
    {"friction_of_words", "collision",
     "<surface><friction><ode><mu>slippery</mu></ode></friction></surface>"},
    {"retro_of_words", "collision", "<laser_retro>much</laser_retro>"},
    {"contacts_negative", "collision", "<max_contacts>-1</max_contacts>"},
};

class UnseenPart : public WorldFile, public testing::WithParamInterface<Unseen> {};
INSTANTIATE_TEST_SUITE_P(All, UnseenPart, testing::ValuesIn(kUnseen),
                         [](const auto& part) { return part.param.name; });

TEST_P(UnseenPart, DoesNotMatter) {
  const Unseen& part = GetParam();
  const auto at = [&](const std::string& place) { return part.place == place ? part.xml : ""; };
  const World world =
      load(at("world") + "<model name='m'><pose>5 0 0 0 0 0</pose>" + at("model") +
           "<link name='link'>" + at("link") + "<collision name='c'>" + at("collision") +
           "<geometry><box><size>2 2 2</size></box></geometry></collision></link></model>");
  EXPECT_NEAR(range_ahead(world), 4.0, 1e-9);
  EXPECT_EQ(world.faces().size(), 6U);
}

TEST_F(WorldFile, SaysWhatWasLoadedAndWhatWasLeftOut) {
  const World world = load(kBoxAhead + "<light name='l' type='point'/>" +
                           "<light name='k' type='point'/><plugin name='p' filename='p.so'/>");
  EXPECT_THAT(world.content(), HasSubstr("1 shape, 2 x 2 x 2 m"));
  EXPECT_THAT(world.content(), HasSubstr("left out: 2 lights, 1 plugin"));
  EXPECT_THAT(world.warnings(), testing::IsEmpty());
}

TEST_F(WorldFile, AnUnknownElementIsAWarning) {
  EXPECT_THAT(load(kBoxAhead + "<favourite_colour/>").warnings(),
              testing::ElementsAre(HasSubstr("'favourite_colour'")));
}

}  // namespace
}  // namespace ribbon_mapper::sim
