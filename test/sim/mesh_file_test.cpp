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

TEST_F(MeshFile, OtherFormatsThanGazebosAreRefused) {
  for (const char* name : {"lamp.off", "lamp.ply", "lamp.blend", "lamp.3ds", "lamp"})
    EXPECT_THAT(error_of_mesh(name, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
                AllOf(HasSubstr("'lamp::link::collision'"), HasSubstr(name),
                      HasSubstr(".dae, .obj or .stl")));
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
