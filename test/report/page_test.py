#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of a model, opened, clicked and resized in a headless Chromium.

Usage: page_test.py SAMPLE_PAGES, the program that writes the pages.
"""

import io
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from browser import Browser, browser_program

NO_TEST = 77  # ctest then says that it was skipped
BACKGROUND = (244, 246, 248)  # of the view, in stage.js
PHONE = (360, 740)

# Where a point of the map is in the window, in pixels.
POINT = """(() => {
  const box = document.querySelector("#view").getBoundingClientRect();
  const at = report.stage.project(new THREE.Vector3(%f, %f, %f).sub(report.data.centre));
  return [at[0] + box.left, at[1] + box.top]; })()"""

# Points of the sample in map [m]: of the floor beside the table, of the table, of the wall.
FLOOR, TABLE, WALL = (1.5, 3.0, 0.0), (3.2, 1.2, 0.7), (5.0, 4.0, 1.5)


def pixels(png):
    """Returns the rows of a PNG file as an array of whole numbers."""
    import matplotlib.image
    return (matplotlib.image.imread(io.BytesIO(png))[..., :3] * 255).round().astype(int)


class PageTest(unittest.TestCase):
    """Each test opens a page of its own."""

    folder = None

    @classmethod
    def setUpClass(cls):
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()

    def setUp(self):
        self.browser.problems.clear()
        self.browser.resize(1280, 900)

    def tearDown(self):
        self.assertEqual(self.browser.problems, [])

    def open(self, name):
        self.browser.open(pathlib.Path(self.folder) / name)

    def text(self, css):
        return self.browser.run(f"document.querySelector({css!r}).textContent")

    def at(self, point):
        return self.browser.run(POINT % point)

    def colour_at(self, point):
        x, y = self.at(point)
        return tuple(pixels(self.browser.picture())[int(y), int(x)])

    def click(self, point):
        self.browser.click(*self.at(point))

    def press(self, css, key, code):
        self.browser.run(f"document.querySelector({css!r}).focus()")
        self.browser.key(key, code)

    def drawn_pixels(self):
        """Returns how many pixels of the view are not of its background."""
        box = self.browser.run("""(() => { const b = document.querySelector("#view")
            .getBoundingClientRect(); return [b.left, b.top, b.right, b.bottom]; })()""")
        left, top, right, bottom = [int(value) for value in box]
        view = pixels(self.browser.picture())[top + 2:bottom - 40, left + 2:right - 2]
        return int((abs(view - BACKGROUND).max(axis=2) > 3).sum())

    def test_planes_are_drawn_where_they_are(self):
        self.open("room.html")
        self.browser.run("document.querySelector('#show_path').click()")
        floor, table = self.colour_at(FLOOR), self.colour_at(TABLE)
        self.assertLess(max(floor) - min(floor), 12, f"the floor is grey, not {floor}")
        self.assertGreater(max(abs(a - b) for a, b in zip(floor, BACKGROUND)), 20)
        self.assertGreater(max(table) - min(table), 12, f"the table has a colour, not {table}")
        self.assertGreater(self.drawn_pixels(), 50000)

    def test_doors_and_holes_are_open(self):
        self.open("room.html")
        self.browser.run("document.querySelector('#show_path').click()")
        in_door, beside = self.colour_at((2.5, 4.0, 1.2)), self.colour_at((3.5, 4.0, 1.2))
        self.assertLess(max(abs(a - b) for a, b in zip(in_door, BACKGROUND)), 4)
        self.assertGreater(max(abs(a - b) for a, b in zip(beside, BACKGROUND)), 20)
        in_hole, floor = self.colour_at((4.0, 1.5, 0.7)), self.colour_at(FLOOR)
        self.assertEqual(in_hole, floor)

    def test_names_do_not_cover_each_other(self):
        self.open("room.html")
        shown = self.browser.run("""(() => {
            const at = (i) => new THREE.Vector3(0.1 * i, 0.07 * i, 0);
            const kinds = ["room", "plane"];
            report.stage.setTags([...Array(40).keys()].map((i) =>
                ({text: `room ${i}, 20.3 m²`, kind: kinds[i % 2], point: at(i)})));
            report.stage.draw();
            return [...document.querySelectorAll("#tags span")]
                .filter((span) => span.style.display !== "none")
                .map((span) => span.getBoundingClientRect())
                .map((box) => [box.left, box.top, box.right, box.bottom]); })()""")
        self.assertGreater(len(shown), 2)
        for i, a in enumerate(shown):
            for b in shown[:i]:
                is_apart = a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]
                self.assertTrue(is_apart, f"{a} covers {b}")

    def test_the_ceiling_is_shown_on_demand_only(self):
        self.open("room.html")
        self.browser.run("document.querySelector('#show_path').click()")
        self.browser.run("document.querySelector('#show_backs').click()")
        without = self.colour_at(FLOOR)
        self.browser.run("document.querySelector('#show_ceilings').click()")
        self.assertNotEqual(self.colour_at(FLOOR), without)

    def test_a_click_shows_the_numbers_of_a_plane(self):
        self.open("room.html")
        self.click(WALL)
        self.assertIn("Plane 2 · wall", self.text("#plane h3"))
        for number in ["13.00 m²", "0.250°", "−4.0 mm", "matches a true plane", "10400 points"]:
            self.assertIn(number, self.text("#plane table"))
        self.assertEqual(self.browser.run(
            "(() => { const c = document.querySelector('#plane canvas');"
            " return [c.width, c.height]; })()"), [120, 50])

    def test_cells_are_those_of_the_model(self):
        self.open("room.html")
        self.click(WALL)
        seen = self.browser.run("""(() => { const c = document.querySelector("#plane canvas");
            const p = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;
            const at = (u, v) => p[4 * ((c.height - 1 - v) * c.width + u) + 3];
            return [at(0, 0), at(39, 39), at(40, 39), at(59, 0), at(60, 0), at(50, 40)]; })()""")
        self.assertEqual(seen, [255, 255, 0, 0, 255, 255])

    def test_a_click_beside_the_model_and_escape_end_a_choice(self):
        for end in [lambda: self.browser.click(300, 100), lambda: self.browser.key("Escape", 27)]:
            self.open("room.html")
            self.click(TABLE)
            self.assertIn("Plane 4", self.text("#plane h3"))
            end()
            self.assertIn("No plane", self.text("#plane h3"))

    def test_a_plane_is_chosen_in_the_list(self):
        self.open("room.html")
        self.browser.run("document.querySelector('#planes summary').click()")
        self.browser.run("document.querySelectorAll('#planes button')[3].click()")
        self.assertIn("Plane 4", self.text("#plane h3"))

    def test_the_slider_leads_to_the_model_before(self):
        self.open("room.html")
        after = self.colour_at(TABLE)
        self.press("#model", "Home", 36)
        self.assertIn("before (3)", self.text("#planes summary"))
        self.assertNotEqual(self.colour_at(TABLE), after, "before, there is no table")
        self.click(TABLE)
        self.assertIn("Plane 1", self.text("#plane h3"), "below it is the floor")
        self.press("#model", "End", 35)
        self.assertEqual(self.text("#stops [aria-pressed=true]"), "after")
        self.assertIn("after (4)", self.text("#planes summary"))

    def test_between_two_models_both_are_seen(self):
        self.open("room.html")
        self.browser.run("document.querySelector('#show_path').click()")
        after = self.colour_at(TABLE)
        self.press("#model", "Home", 36)
        before = self.colour_at(TABLE)
        self.browser.run("(() => { const s = document.querySelector('#model'); s.value = 0.5;"
                         " s.dispatchEvent(new Event('input')); })()")
        self.assertNotIn(self.colour_at(TABLE), [before, after])

    def test_the_robot_moves_with_the_time(self):
        self.open("room.html")
        at_end = self.browser.run("report.path.robot.position.x")
        self.assertEqual(self.text("#time_text"), "4999.0 of 4999.0 s")
        self.press("#time", "Home", 36)
        self.assertEqual(self.text("#time_text"), "0.0 of 4999.0 s")
        self.assertAlmostEqual(at_end - self.browser.run("report.path.robot.position.x"), 5.0, 1)

    def test_a_drag_turns_the_view_and_chooses_nothing(self):
        self.open("room.html")
        before = self.at(WALL)
        x, y = self.at(FLOOR)
        self.browser.drag((x, y), (x + 150, y))
        self.browser.wait(f"Math.hypot(...(({POINT % WALL})).map((v, i) => "
                          f"v - {before}[i])) > 20")
        self.assertIn("No plane", self.text("#plane h3"))

    def test_arrow_keys_turn_the_view(self):
        self.open("room.html")
        before = self.at(WALL)
        self.press("#view", "ArrowLeft", 37)
        self.assertGreater(abs(self.at(WALL)[0] - before[0]), 5)

    def test_colours_say_what_the_truth_says(self):
        self.open("room.html")
        self.browser.run("(() => { const s = document.querySelector('#colours');"
                         " s.value = [...s.options].find((o) => o.text === 'against the truth')"
                         ".value; s.dispatchEvent(new Event('change')); })()")
        red, green, blue = self.colour_at(WALL)
        self.assertTrue(green > red and green > blue, f"green, not {(red, green, blue)}")
        self.assertIn("on no true plane", self.text("#legend"))

    def test_texts_are_all_there(self):
        self.open("room.html")
        whole = self.text("body")
        for text in ["A room", "scan.max_range_m", "ribbon_mapper 1.2.3", "rosrun it",
                     "run 0123456789abcdef", "5000", "kitchen, 24.0 m²"]:
            self.assertIn(text, whole)

    def test_hostile_texts_are_shown_and_not_run(self):
        self.open("hostile.html")
        self.assertIsNone(self.browser.run("window.hacked ?? null"))
        self.assertEqual(self.browser.run("document.images.length"), 0)
        self.assertIn("</script><script>window.hacked = 1", self.text("h1"))
        self.click(FLOOR)
        self.assertIn("onerror", self.text("#plane h3"))
        self.assertIsNone(self.browser.run("window.hacked ?? null"))

    def test_pages_of_no_plane_and_of_one_open(self):
        self.open("none.html")
        self.assertIn("0 planes", self.text("#subtitle"))
        self.open("one.html")
        self.assertIn("1 plane", self.text("#subtitle"))
        self.assertGreater(self.drawn_pixels(), 10000)

    def test_a_page_of_100000_planes_opens(self):
        with Browser() as browser:  # of its own: it draws for long without a graphics card
            browser.open(pathlib.Path(self.folder) / "many.html")
            self.assertIn("100000 planes",
                          browser.run("document.querySelector('#subtitle').textContent"))
            self.assertEqual(browser.run("report.surfaces[0].parts[0].indices.length"), 100000)
            self.assertEqual(browser.problems, [])

    def test_on_a_phone_nothing_is_cut_off_and_a_tap_chooses(self):
        self.browser.resize(*PHONE, is_phone=True)
        self.open("room.html")
        self.assertEqual(self.browser.run("document.documentElement.scrollWidth"), PHONE[0])
        sizes = self.browser.run("[...document.querySelectorAll('svg text')].map((t) =>"
                                 " t.getBoundingClientRect().height)")
        self.assertGreater(min(sizes), 10.0, "texts of plots are legible")
        self.browser.tap(*self.at(TABLE))
        self.browser.wait("document.querySelector('#plane h3').textContent.includes('Plane 4')")

    def test_without_3d_there_are_the_numbers(self):
        with Browser(options=["--disable-3d-apis"]) as browser:
            browser.open(pathlib.Path(self.folder) / "room.html")
            self.assertIn("cannot draw in 3D",
                          browser.run("document.querySelector('#message').textContent"))
            self.assertIn("before", browser.run("document.querySelector('#tables').textContent"))

    def test_the_page_names_no_other_file(self):
        page = (pathlib.Path(self.folder) / "room.html").read_text(encoding="utf-8")
        links = re.findall(r"""(?:src|href)\s*=\s*["']([^"']*)""", page.split("<script")[0])
        self.assertEqual(links, ["data:,"])


def main(program):
    if browser_program() is None:
        print("Skipped: missing chromium-headless-shell (./install_dependencies browser)")
        return NO_TEST
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, folder], check=True)
        PageTest.folder = folder
        return 0 if unittest.main(argv=[sys.argv[0]] + sys.argv[2:], exit=False).result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
