// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A process that uses the library may have set any locale: files are written and read the same.
#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <clocale>
#include <locale>
#include <sstream>

#include "modeler/io/calibrated_preset.hpp"
#include "modeler/io/config_file.hpp"
#include "modeler/io/octomap.hpp"
#include "modeler/io/planes_json.hpp"
#include "modeler/io/ply.hpp"
#include "modeler/io/tum.hpp"
#include "test/io/small_plane.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

/// Numbers as in German, in small groups: 1.2.3,5.
struct Commas : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\1"; }
};

/// Sets such a locale for C++, and for C where the system has one, during its lifetime.
class ForeignLocale {
 public:
  ForeignLocale() : cpp_(std::locale::global(std::locale(std::locale(), new Commas))) {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
      if (std::setlocale(LC_ALL, name) != nullptr) break;
    }
  }
  ~ForeignLocale() {
    std::locale::global(cpp_);
    std::setlocale(LC_ALL, "C");
  }
  ForeignLocale(const ForeignLocale&) = delete;
  ForeignLocale& operator=(const ForeignLocale&) = delete;

 private:
  std::locale cpp_;
};

/// Returns what is written of one model, trajectory and calibration.
std::string all_texts() {
  Calibration calibration;
  calibration.stopped.distance_variance_m2 = 0.000123456;
  calibration.moving.tolerance = {1.23456, 0.2};
  return planes_to_json({small_plane()}) + planes_to_ply_cloud({small_plane()}) +
         planes_to_ply_mesh({small_plane()}, 0.5) + planes_to_octomap({small_plane()}) +
         to_tum({{Time(1'500'000'000), planar_pose(1234.5, 2.0, 0.3)}}) + config_to_yaml({}) +
         calibrated_preset({}, calibration, "test");
}

TEST(Locale, ChangesNoByteOfAnyFile) {
  const std::string classic = all_texts();
  const ForeignLocale foreign;
  EXPECT_EQ(classic, all_texts());
}

TEST(Locale, ChangesNothingThatIsRead) {
  const TemporaryDirectory directory;
  const ForeignLocale foreign;
  write_content(directory.path() / "preset.yaml",
                "surface: {cell_size_m: 0.125}\nribbon: {min_points: 1000}\n");
  const ModelerConfig config = load_config(directory.path() / "preset.yaml");
  EXPECT_EQ(config.surface.cell_size_m, 0.125);
  EXPECT_EQ(config.ribbon.min_points, 1000);
  EXPECT_EQ(from_tum("1234.5 1234.5 0 0 0 0 0 1\n", "text").at(0).T_map_base.translation().x(),
            1234.5);
  std::istringstream stream(planes_to_octomap({small_plane()}));
  stream.imbue(std::locale::classic());
  octomap::OcTree tree(1.0);
  EXPECT_TRUE(tree.readBinary(stream));
}

}  // namespace
}  // namespace ribbon_mapper
