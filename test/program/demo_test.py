#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo shows one voice, ends with one line for each run, and fails if a run has no results.
roslaunch is a script here; the recorded tour is modelled by the real program."""
import contextlib
import importlib.machinery
import importlib.util
import io
import json
import os
import pathlib
import sys
import tempfile
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
OFFLINE_MODELER = sys.argv.pop()


def demo_of(results):
    """Returns tools/demo as a module that writes to the folder `results`."""
    loader = importlib.machinery.SourceFileLoader("demo", str(REPOSITORY / "tools/demo"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("demo", loader))
    loader.exec_module(module)
    module.RESULTS = results
    module.page_in = lambda output: output / "report.html"
    return module


class Demo(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.demo = demo_of(self.folder / "results")

    def run_with(self, roslaunch, programs, *arguments):
        """Runs the demo with this roslaunch. Returns its exit code and what it printed."""
        script = self.folder / "roslaunch"
        script.write_text(roslaunch)
        script.chmod(0o755)
        path = os.environ["PATH"]
        self.addCleanup(os.environ.__setitem__, "PATH", path)
        os.environ["PATH"] = f"{self.folder}:{path}"
        self.demo.program = programs.get
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            code = self.demo.main(list(arguments))
        return code, printed.getvalue()

    def test_one_voice_is_shown(self):
        shown = self.demo.shown
        report = "1941 lines (0 dropped), 5390 ribbons, 25 planes; the tour runs at 5.0 x real time"
        self.assertEqual(report, shown(f"\x1b[0m[ INFO] [1795826036.3, 50.67]: {report}\x1b[0m\n"))
        self.assertIsNone(shown("[ INFO] [1795826036.6, 51.99]: Tour: line 2000 of 9456 (21 %)"))
        self.assertEqual("WARN: no transforms",
                         shown("\x1b[33m[ WARN] [1795826036.6, 51.99]: no transforms\x1b[0m"))
        self.assertEqual("corrected, final   22", shown("corrected, final   22\n"))
        for line in ["SUMMARY", "========", " * /use_sim_time: True", "    modeler (a_b/modeler)",
                     "process[modeler-4]: started with pid [25503]",
                     "\x1b[31m=======REQUIRED process [report-6] has died!",
                     "process has finished cleanly", "[report-6] killing on exit", "done", ""]:
            self.assertIsNone(shown(line), line)

    def test_arguments_of_the_simulator_are_refused_without_it(self):
        code, printed = self.run_with("", {"offline_modeler": OFFLINE_MODELER}, "seed:=7")
        self.assertEqual(1, code)
        self.assertIn("seed:=7: for the simulator only", printed)

    def test_each_run_ends_with_a_line(self):
        summary = json.dumps({"planes_noisy_as_built": 110, "planes_corrected": 22,
                              "truth_planes": 22, "matched": 22})
        code, printed = self.run_with(
            f"#!/bin/sh\nfor a; do case $a in output:=*) d=${{a#output:=}};; esac; done\n"
            f"mkdir -p $d; echo '{summary}' > $d/summary.json\n", {"pr2_simulator": "there"})
        self.assertEqual(0, code)
        for name, folder in self.demo.NAMES.items():
            self.assertIn(f"{name:>5}: 110 planes became 22, of 22 in the world 22 are right; open "
                          f"{self.folder}/results/{folder}/report.html\n", printed)

    def test_a_simulator_that_dies_is_a_failure(self):
        code, printed = self.run_with("#!/bin/sh\necho '[pr2_simulator-3] process has died'\n",
                                      {"pr2_simulator": "there"})
        self.assertEqual(1, code)
        self.assertEqual(2, printed.count("no results, see above"))

    def test_without_the_simulator_a_recorded_tour_is_modelled(self):
        code, printed = self.run_with("#!/bin/sh\nexit 1\n", {"offline_modeler": OFFLINE_MODELER})
        self.assertEqual(0, code, printed)
        self.assertIn("needs libsdformat-dev", printed)
        for name in self.demo.NAMES:
            self.assertRegex(printed, rf"{name:>5}: \d+ planes became 22, 22 are in the world; open")


if __name__ == "__main__":
    unittest.main()
