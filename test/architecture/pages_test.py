# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Holds the links of the pages and the form of their commands; the checks are checked, too."""
import pathlib
import unittest

import pages
import planted

PROJECT = pathlib.Path(__file__).resolve().parents[2]


class Project(unittest.TestCase):
    maxDiff = None

    def test_links_lead_somewhere(self):
        self.assertEqual([], pages.broken_links(PROJECT))

    def test_every_page_is_reached(self):
        self.assertEqual([], pages.unreached(PROJECT))

    def test_fences_name_their_language_and_marks_their_reason(self):
        self.assertEqual([], pages.wrong_blocks(PROJECT))

    def test_there_is_something_to_check(self):
        self.assertGreater(len(pages.pages(PROJECT)), 4)
        self.assertTrue([block for block in pages.blocks(PROJECT) if block.language == "bash"])


class PlantedDefects(planted.PlantedProject):
    def test_good_pages(self):
        self.plant("README.md", "# A title\n[a](#a-title) [b](docs/b.md#the-second-one-1) "
                   "[c](https://example.org/x) `[d](no.md)`\n```text\n[e](no.md)\n```\n")
        self.plant("docs/b.md", "## The `second` one\n## The second one\n[up](../README.md)\n")
        self.assertEqual([], pages.broken_links(self.root) + pages.unreached(self.root)
                         + pages.wrong_blocks(self.root))

    def test_a_broken_link_and_a_missing_heading(self):
        self.plant("README.md", "# A\n[a](docs/no.md)\n![b](b.png)\n[c](#no)\n")
        self.assertEqual(["README.md:2: no such file: docs/no.md",
                          "README.md:3: no such file: b.png",
                          "README.md:4: no such heading: #no"], pages.broken_links(self.root))

    def test_a_page_that_nothing_leads_to(self):
        self.plant("README.md", "[a](docs/a.md)\n")
        self.plant("docs/a.md", "")
        self.plant("docs/b.md", "[a](a.md)\n")
        self.assertEqual(["docs/b.md: no link from README.md leads here"],
                         pages.unreached(self.root))

    def test_fences_without_language_and_marks_without_reason(self):
        self.plant("README.md", "```\nls\n```\n```console\nls\n```\n"
                   "<!-- not run -->\n```bash\nls\n```\n")
        messages = pages.wrong_blocks(self.root)
        self.assertEqual(3, len(messages), messages)
        for message, part in zip(messages, ["without a language", "not console", "a reason"]):
            self.assertIn(part, message)

    def test_a_wrong_command(self):
        self.plant("README.md", "```bash\ntest -e README.md | cat\n```\n"
                   "```bash\nls no_such_file\ntrue\n```\n")
        self.plant("docs/how_to/a.md", "<!-- not run:\nneeds a robot -->\n\n```bash\nfalse\n```\n")
        messages = pages.failing_commands(self.root, self.root)
        self.assertEqual(1, len(messages), messages)
        self.assertIn("README.md:4: exit status 2", messages[0])
        self.assertIn("no_such_file", messages[0])

    def test_a_command_that_does_not_end(self):
        self.plant("README.md", "```bash\nsleep 100\n```\n")
        self.assertEqual(["README.md:1: not done after 0.1 s"],
                         pages.failing_commands(self.root, self.root, timeout_s=0.1))


if __name__ == "__main__":
    unittest.main()
