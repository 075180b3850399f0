#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a series in a bare room as users do: interrupted, resumed, distributed by GNU parallel.

Usage: series_command_test.py EXPERIMENT PACKAGE
"""
import json
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

EXPERIMENT, PACKAGE = sys.argv[1], pathlib.Path(sys.argv[2])
ROOM = ['--world', str(PACKAGE / 'test/ros/room.sdf'), '--no-figure']
RUNS = ['--seeds', '1-3', '--drift', '0,2']


def lines_in(folder):
    path = folder / 'runs.jsonl'
    return path.read_text().count('\n') if path.exists() else 0


class SeriesCommand(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def series(self, name, jobs='2', **options):
        return subprocess.run([EXPERIMENT, *ROOM, *RUNS, '--jobs', jobs, '--output',
                               str(self.folder / name)], check=True, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, **options).stdout

    def content(self, name, file='runs.jsonl'):
        return (self.folder / name / file).read_text()

    def begin_and_kill(self, name, number=signal.SIGKILL):
        """Starts a series and ends it by a signal after its first run. Returns exit code and stderr."""
        process = subprocess.Popen([EXPERIMENT, *ROOM, *RUNS, '--output', str(self.folder / name)],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        end = time.monotonic() + 60.0
        while lines_in(self.folder / name) < 1 and time.monotonic() < end:
            time.sleep(0.01)
        process.send_signal(number)
        said = process.communicate()[1]
        return process.returncode, said

    def test_an_interrupted_series_ends_in_the_same_bytes(self):
        self.series('whole')
        self.begin_and_kill('parts')
        done = lines_in(self.folder / 'parts')
        self.assertIn(done, range(1, 6), 'the series was not killed in the middle')
        said = self.series('parts', jobs='1')
        self.assertIn('%d of 6 runs are done already' % done, said)
        self.assertEqual(self.content('parts'), self.content('whole'))
        self.assertEqual(self.content('whole').count('\n'), 6)
        summaries = [json.loads(self.content(name, 'summary.json')) for name in ('whole', 'parts')]
        self.assertEqual(summaries[0]['groups'], summaries[1]['groups'])

    def test_ctrl_c_says_what_is_kept(self):
        code, said = self.begin_and_kill('parts', signal.SIGINT)
        self.assertEqual(130, code)
        done = lines_in(self.folder / 'parts')
        self.assertIn(f'interrupted, {done} of 6 runs are kept in {self.folder}/parts; the same command '
                      'goes on', said)
        self.assertIn(f'{done} of 6 runs are done already', self.series('parts'))

    def test_ctrl_c_of_one_run_writes_nothing(self):
        output = self.folder / 'one'
        process = subprocess.Popen([EXPERIMENT, *ROOM, '--output', str(output)],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        for line in process.stderr:
            if ' %' in line:
                break
        process.send_signal(signal.SIGINT)
        self.assertIn('interrupted, nothing was written', process.stderr.read())
        self.assertEqual(130, process.wait())
        self.assertFalse(output.exists())
        process.stderr.close()

    def test_the_estimate_of_a_run_is_drawn(self):
        subprocess.run([EXPERIMENT, *ROOM, '--closure', 'self', '--output', str(self.folder)],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        subprocess.run(['/usr/bin/python3', str(PACKAGE / 'eval/figures/estimate.py'),
                        str(self.folder)], check=True)
        svg = (self.folder / 'estimate.svg').read_text()
        self.assertIn('cm RMS', svg)
        self.assertTrue((self.folder / 'estimate.png').exists())

    def test_no_run_is_repeated(self):
        self.series('whole')
        before = self.content('whole', 'timings.jsonl')
        self.assertIn('6 of 6 runs are done already', self.series('whole'))
        self.assertEqual(self.content('whole', 'timings.jsonl'), before)

    @unittest.skipUnless(shutil.which('parallel'),
                         'GNU parallel is missing: sudo apt install parallel')
    def test_gnu_parallel_gathers_the_same_lines(self):
        self.series('whole')
        (self.folder / 'gathered').mkdir()
        with open(self.folder / 'gathered/runs.jsonl', 'w') as file:
            subprocess.run(['parallel', '--will-cite', '--jobs', '2', EXPERIMENT, *ROOM, '--line',
                            '--seed', '{1}', '--drift', '{2}', ':::', '1', '2', '3', ':::', '0',
                            '2'], check=True, stdout=file, stderr=subprocess.DEVNULL)
        self.assertIn('6 of 6 runs are done already', self.series('gathered'))
        self.assertEqual(self.content('gathered'), self.content('whole'))


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=2)
