# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Holds the arrows between the rooms and the sizes of files; the checks are checked, too."""
import pathlib
import unittest

import planted
import rooms

PROJECT = pathlib.Path(__file__).resolve().parents[2]
SPDX = "// SPDX-FileCopyrightText: x\n// SPDX-License-Identifier: x\n"


class Project(unittest.TestCase):
    def test_includes_follow_the_table(self):
        self.assertEqual([], rooms.wrong_includes(PROJECT))

    def test_files_are_short_and_licensed_and_no_folder_is_a_drawer(self):
        self.assertEqual([], rooms.wrong_files(PROJECT))

    def test_no_folder_is_full(self):
        self.assertEqual([], rooms.full_folders(PROJECT))

    def test_there_is_something_to_check(self):
        for room in ["modeler", "modeler/geometry", "modeler/surface", "modeler/ros/node", "sim/world", "eval/metrics"]:
            self.assertTrue(list((PROJECT / room).glob("*.hpp")), room)


class PlantedDefects(planted.PlantedProject):
    HEAD = SPDX

    def assert_one(self, messages, *parts):
        self.assertEqual(1, len(messages), messages)
        for part in parts:
            self.assertIn(part, messages[0])

    def test_what_is_allowed(self):
        self.plant("modeler/scan/a.hpp", '#include <Eigen/Core>\n#include <vector>\n'
                   '#include "modeler/geometry/pose.hpp"\n#include "modeler/scan/b.hpp"\n')
        self.plant("modeler/ros/node/a.cpp", '#include <ros/ros.h>\n#include "modeler/modeler.hpp"\n')
        self.plant("sim/world/a.cpp", '#include "modeler/geometry/time.hpp"\n')
        self.plant("bench/a/b/c.cpp", '#include "bench/d/e.hpp"\n#include "eval/metrics/patch.hpp"\n')
        self.assertEqual([], rooms.wrong_includes(self.root))
        self.assertEqual([], rooms.wrong_files(self.root))

    def test_each_wrong_arrow_is_found(self):
        for name, target in [
                ("modeler/geometry/a.cpp", '"modeler/scan/scan_line.hpp"'),
                ("modeler/scan/a.hpp", '"modeler/ribbon/ribbon.hpp"'),
                ("modeler/surface/a.cpp", '"modeler/modeler.hpp"'),
                ("modeler/surface/a.cpp", '"modeler/io/ply.hpp"'),
                ("modeler/io/a.cpp", '"modeler/ros/intake/line_log.hpp"'),
                ("modeler/ros/node/a.cpp", '"sim/world/world.hpp"'),
                ("modeler/a.cpp", '"eval/metrics/patch.hpp"'),
                ("sim/world/a.cpp", '"modeler/geometry/moments.hpp"'),
                ("sim/world/a.cpp", '"modeler/scan/laser_beams.hpp"'),
                ("sim/ros/a.cpp", '"modeler/ros/intake/line_poses.hpp"'),
                ("eval/metrics/a.cpp", '"eval/ros/tour_watch.hpp"'),
                ("eval/metrics/a.cpp", '"bench/sections.hpp"'),
                ("python/bindings/a.cpp", '"modeler/mesh/plane_mesh.hpp"'),
                ("modeler/io/a.cpp", '"python/bindings/arrays.hpp"'),
                ("bench/a/b.cpp", '"sim/ros/pacer.hpp"')]:
            with self.subTest(name=name, target=target):
                self.plant(name, f"  #  include {target}\n")
                self.assert_one(rooms.wrong_includes(self.root), name, target.strip('"'))
                (self.root / name).unlink()

    def test_ros_is_found_in_each_room_without_it(self):
        without = [room for room, row in rooms.ROOMS.items() if row.libraries is not rooms.ANY]
        self.assertGreater(len(without), 30)
        for room in without:
            for target in ["ros/ros.h", "tf2/buffer_core.h", "tf2_ros/buffer.h", "rosbag/bag.h",
                           "sensor_msgs/LaserScan.h", "ribbon_mapper/Save.h", "pcl/io/pcd_io.h"]:
                with self.subTest(room=room, target=target):
                    self.plant(f"{room}/a.hpp", f"#include <{target}>\n")
                    self.assert_one(rooms.wrong_includes(self.root), room, target)
            (self.root / room / "a.hpp").unlink()

    def test_a_room_that_is_not_in_the_table(self):
        self.plant("modeler/attic/a.cpp", "")
        self.assert_one(rooms.wrong_includes(self.root), "modeler/attic", "add it to the table")

    def test_a_drawer(self):
        self.plant("sim/utils/a.cpp", "")
        self.assert_one(rooms.wrong_files(self.root), "sim/utils")

    def test_a_long_file(self):
        self.plant("eval/metrics/a.cpp", "\n" * 299)
        self.assert_one(rooms.wrong_files(self.root), "eval/metrics/a.cpp", "301 lines")

    def test_a_full_folder(self):
        for number in range(20):
            self.plant(f"sim/world/{number}.cpp", "")
        self.assertEqual([], rooms.full_folders(self.root))
        self.plant("sim/world/one_more.hpp", "")
        self.assert_one(rooms.full_folders(self.root), "sim/world holds 21 sources")

    def test_a_file_without_licence(self):
        (self.root / "eval").mkdir()
        (self.root / "eval/a.py").write_text("print()\n")
        self.assert_one(rooms.wrong_files(self.root), "eval/a.py", "SPDX")


if __name__ == "__main__":
    unittest.main()
