#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Texts of a figure: none over another, the first where they belong, none beyond the axes."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / 'eval/figures'))

from figure_files import counted  # noqa: E402
from text_places import TextPlaces  # noqa: E402

import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.text import Text  # noqa: E402


class TextPlacesTest(unittest.TestCase):
    def setUp(self):
        self.figure = plt.figure(figsize=(4, 3))
        self.axes = self.figure.add_axes([0.1, 0.1, 0.8, 0.8], xlim=(0, 10), ylim=(0, 10))
        self.places = TextPlaces(self.axes)

    def tearDown(self):
        plt.close(self.figure)

    def boxes(self):
        self.figure.canvas.draw()
        return [Text.get_window_extent(text) for text in self.axes.texts]

    def test_sixty_texts_do_not_overlap(self):
        drawn = [self.places.add(f'{i}.0 m²', (5 + 0.02 * i, 5 - 0.03 * i), fontsize=6)
                 for i in range(60)]
        boxes = self.boxes()
        self.assertEqual(len(boxes), drawn.count(True))
        self.assertGreater(len(boxes), 20)
        self.assertTrue(drawn[0], 'the first has its place')
        self.assertEqual(self.axes.texts[0].xyann, (0.0, 0.0))
        for i, a in enumerate(boxes):
            self.assertFalse(any(a.overlaps(b) for b in boxes[:i]), self.axes.texts[i])

    def test_a_text_that_was_moved_has_a_line(self):
        for _ in range(2):
            self.assertTrue(self.places.add('wall', (5, 5)))
        first, second = self.axes.texts
        self.assertIsNone(first.arrow_patch)
        self.assertIsNotNone(second.arrow_patch)

    def test_no_text_is_beyond_the_axes(self):
        self.assertTrue(self.places.add('a long text', (10, 10), fontsize=6))
        self.assertFalse(self.places.add('too long to be seen anywhere ' * 9, (5, 5)))
        frame = self.axes.get_window_extent()
        for box in self.boxes():
            self.assertTrue(frame.x0 <= box.x0 and box.x1 <= frame.x1)

    def test_one_has_a_singular(self):
        self.assertEqual(counted(1, 'duplicate', 'duplicates'), '1 duplicate')
        self.assertEqual(counted(0, 'duplicate', 'duplicates'), '0 duplicates')


if __name__ == '__main__':
    unittest.main()
