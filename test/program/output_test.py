#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a program cannot print is a failure: exit code 1 and a message. Usage: output_test.py PROGRAM..."""
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BAG = ROOT / "test" / "data" / "small_room.bag"
ROOM = ["--world", ROOT / "test" / "ros" / "room.sdf", "--route",
        ROOT / "test" / "ros" / "room.route.yaml"]
PROGRAMS = {}


def work_of(program, folder):
    """Returns arguments with which a program succeeds and prints."""
    return {"offline_modeler": ["--bag", BAG, "--output", folder],
            "bag_check": [BAG],
            "record_tour": [*ROOM, "--bag", folder / "a.bag", "--seconds", "1"],
            "experiment": [*ROOM, "--no-figure", "--output", folder]}[program]


def run(program, arguments, output):
    return subprocess.run([PROGRAMS[program], *map(str, arguments)], stdout=output,
                          stderr=subprocess.PIPE, text=True, check=False, timeout=100)


class Output(unittest.TestCase):
    def test_a_full_disk_is_reported(self):
        with tempfile.TemporaryDirectory() as folder, open("/dev/full", "w") as full:
            for program in PROGRAMS:
                for arguments in (["--help"], work_of(program, pathlib.Path(folder))):
                    found = run(program, arguments, full)
                    self.assertEqual(found.returncode, 1, (program, arguments))
                    self.assertIn(f"{program}: the standard output cannot be written", found.stderr)
                    self.assertIn("No space left on device", found.stderr)

    def test_the_same_succeeds_elsewhere(self):
        with tempfile.TemporaryDirectory() as folder:
            for program in PROGRAMS:
                for arguments in (["--help"], work_of(program, pathlib.Path(folder))):
                    found = run(program, arguments, subprocess.PIPE)
                    self.assertEqual(found.returncode, 0, (program, arguments, found.stderr))
                    self.assertTrue(found.stdout)

    def test_an_empty_folder_name_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            for program in PROGRAMS:
                arguments = work_of(program, pathlib.Path(folder))
                if "--output" not in arguments:
                    continue
                arguments[arguments.index("--output") + 1] = ""
                found = run(program, arguments, subprocess.PIPE)
                self.assertEqual(found.returncode, 1, program)
                self.assertIn("name of the output directory is empty", found.stderr)

    def test_a_recording_that_is_stopped_is_a_bag(self):
        with tempfile.TemporaryDirectory() as folder:
            bag = pathlib.Path(folder) / "a.bag"
            flat = ["--world", "worlds/apartment.sdf", "--route", "worlds/apartment.route.yaml"]
            with subprocess.Popen([PROGRAMS["record_tour"], *flat, "--bag", bag], text=True,
                                  stderr=subprocess.PIPE) as recording:
                while recording.poll() is None and (not bag.exists() or bag.stat().st_size < 1e6):
                    time.sleep(0.01)
                recording.send_signal(signal.SIGINT)
                said = recording.stderr.read()
            self.assertEqual(recording.returncode, 130, said)
            recorded = int(re.search(r"interrupted, (\d+) of 9456 lines are in", said).group(1))
            checked = run("bag_check", [bag], subprocess.PIPE)
            self.assertIn(f"/tilt_scan: {recorded} messages", checked.stdout)


if __name__ == "__main__":
    PROGRAMS = {pathlib.Path(path).name: path for path in sys.argv[1:]}
    unittest.main(argv=sys.argv[:1])
