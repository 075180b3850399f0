// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes the pages that page_test.py opens: sample_pages DIRECTORY.

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "modeler/report/report.hpp"
#include "test/report/sample_model.hpp"

namespace {

using namespace ribbon_mapper;

constexpr const char* kHostile =
    "</script><script>window.hacked = 1</script><img src=x onerror='window.hacked = 2'><!--";

void write(const std::filesystem::path& path, const Report& report) {
  std::ofstream(path, std::ios::binary) << report.html();
}

/// Returns a page with all that a page can show.
Report room_page() {
  ReportHead head{"A room", "map", "0123456789abcdef", "ribbon_mapper 1.2.3", "rosrun it", {}};
  head.parameters = {{"scan.max_range_m", "12", "30"}};
  Report report(head);
  report.add_trajectory("before", sample_path(5000, 1.0));
  report.add_trajectory("after", sample_path(5000, 2.0));
  const std::vector<Plane> before{sample_floor(), sample_wall(2, 3.0), sample_wall(8, 3.3)};
  const std::vector<Plane> after{sample_floor(), sample_wall(2, 4.0), sample_ceiling(),
                                 sample_table()};
  const PlaneVerdict matched{PlaneVerdict::Kind::matched, 1, 0.25, -0.004};
  report.add_model({"before", &before, {}, 0});
  report.add_model(
      {"after", &after, {{"floor", {}}, {"wall", matched}, {"ceiling", {}}, {"table", {}}}, 1});
  report.set_truth({sample_floor(), sample_wall(2, 4.0)}, sample_path(5000, 2.0));
  report.add_room({"kitchen", 24.0, sample_floor().outlines});
  report.add_table({"Table", {"model", "planes"}, {{"before", "3"}, {"after", "4"}}});
  report.add_fact("Lines", "5000");
  return report;
}

Report hostile_page() {
  Report report(
      {kHostile, kHostile, kHostile, kHostile, kHostile, {{{kHostile, "\xff\xfe", "\0"}}}});
  const std::vector<Plane> planes{sample_floor()};
  report.add_trajectory(kHostile, sample_path(3, 1.0));
  report.add_model({kHostile, &planes, {{kHostile, {}}}, 0});
  report.add_room({kHostile, 1.0, planes.front().outlines});
  report.add_table({kHostile, {kHostile}, {{kHostile}}});
  report.add_fact(kHostile, "\xe2\x80\xa8 \xc0\xaf");
  return report;
}

Report page_of(const std::vector<Plane>& planes) {
  Report report({"Many planes", "map", "", "", "", {}});
  report.add_trajectory("now", {});
  report.add_model({"now", &planes});
  return report;
}

/// Returns walls in rows, as many as asked for.
std::vector<Plane> walls(std::size_t count) {
  std::vector<Plane> planes;
  for (std::size_t i = 0; i < count; ++i) {
    Plane plane = planes.empty() ? sample_wall(0, 0.0) : planes.front();
    const Eigen::Vector3d shift(8.0 * static_cast<double>(i % 300), static_cast<double>(i / 300),
                                0);
    plane.id = static_cast<std::int64_t>(i);
    plane.origin += shift;
    plane.centroid += shift;
    for (auto& point : plane.outlines.front().outer) point += shift;
    if (i > 0) plane.cells.resize(1);
    planes.push_back(plane);
  }
  return planes;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: sample_pages DIRECTORY\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  write(folder / "room.html", room_page());
  write(folder / "hostile.html", hostile_page());
  write(folder / "none.html", page_of({}));
  write(folder / "one.html", page_of({sample_table()}));
  write(folder / "many.html", page_of(walls(100'000)));
  return 0;
}
