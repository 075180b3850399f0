// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "test/sim/sdf/world_file.hpp"

namespace ribbon_mapper::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class MeshFile : public WorldFile {
 protected:
  std::string error_of_mesh(const std::string& name, const std::string& content) const {
    write(name, content);
    return error_of_content(kBoxAhead + sdf_model("lamp", "0 0 0 0 0 0", sdf_mesh(name)));
  }
};

/// Returns a tetrahedron's base and side in COLLADA, each part of which may be replaced.
std::string dae(const std::string& count = "12", const std::string& indices = "0 1 2 0 1 3",
                const std::string& corners = "4") {
  return "<?xml version='1.0'?><COLLADA version='1.4.1'><library_geometries><geometry id='g'><mesh>"
         "<source id='p'><float_array id='a' count='" +
         count +
         "'>0 0 0 1 0 0 0 1 0 0 0 1</float_array><technique_common><accessor source='#a' count='4' "
         "stride='3'><param name='X' type='float'/><param name='Y' type='float'/>"
         "<param name='Z' type='float'/></accessor></technique_common></source>"
         "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>"
         "<triangles count='2'><input semantic='VERTEX' source='#v' offset='0'/><p>" +
         indices +
         "</p></triangles><polylist count='1'><input semantic='VERTEX' source='#v' offset='0'/>"
         "<vcount>" +
         corners +
         "</vcount><p>0 1 2 3</p></polylist></mesh></geometry>"
         "</library_geometries><library_visual_scenes><visual_scene id='s'><node id='n'>"
         "<instance_geometry url='#g'/></node></visual_scene></library_visual_scenes>"
         "<scene><instance_visual_scene url='#s'/></scene></COLLADA>";
}

/// assimp 5.2 aborts, crashes and hangs on these.
TEST_F(MeshFile, WhatEndsAssimpEndsNotTheProgram) {
  for (const std::string& damaged :
       {dae("12", "0 1 2 0 1 3", "}"), dae("inf"), dae("12", "0 0,5 2 0 1 3")})
    EXPECT_THAT(error_of_mesh("lamp.dae", damaged),
                AllOf(HasSubstr("'lamp::link::collision'"), HasSubstr("lamp.dae"),
                      HasSubstr("export it again, as .dae, .obj or .stl")));
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0\n1\nrtex\n41 0 1 2\n";
  EXPECT_THAT(error_of_mesh("lamp.ply", ply), HasSubstr("lamp.ply"));
}

TEST_F(MeshFile, ColladaIsRead) {
  write("lamp.dae", dae());
  EXPECT_GT(load(sdf_model("lamp", "0 0 0 0 0 0", sdf_mesh("lamp.dae"))).triangles().size(), 3U);
}

TEST_F(MeshFile, DamagedFilesAreRefused) {
  for (const char* name : {"lamp.dae", "lamp.obj", "lamp.stl", "lamp.STL"}) {
    EXPECT_THAT(error_of_mesh(name, ""), AllOf(HasSubstr("lamp::link"), HasSubstr(name)));
    EXPECT_THAT(error_of_mesh(name, "<COLLADA><library_geometries>"), HasSubstr(name));
    EXPECT_THAT(error_of_mesh(name, std::string(200, '\xff')), HasSubstr(name));
  }
  EXPECT_THAT(error_of_mesh("lamp.obj", "v nan 0 0\nv 1 inf 0\nv 0 1 0\nf 1 2 3\n"),
              HasSubstr("not finite"));
  EXPECT_THAT(error_of_mesh("lamp.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"),
              HasSubstr("lamp.obj"));
}

TEST_F(MeshFile, TheEndingMayBeInCapitals) {
  write("WALL.OBJ", "v 5 -1 -1\nv 5 1 -1\nv 5 0 1\nf 1 2 3\n");
  EXPECT_NEAR(range_ahead(load(sdf_model("wall", "0 0 0 0 0 0", sdf_mesh("WALL.OBJ")))), 5.0, 1e-6);
}

}  // namespace
}  // namespace ribbon_mapper::sim
