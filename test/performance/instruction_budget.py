#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts the instructions of a fixed input by callgrind and holds them against a budget.

Instructions do not depend on the load of a machine, so this cannot flake as a stopwatch would.
`--renew` writes the budget anew, for a change that is meant to cost what it costs.
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOM = 1.10  # of the budget: compilers and C libraries differ a little
SKIPPED = 77  # tells ctest
STAGES = {
    'scan': 'ribbon_mapper::sim::Tour::next_scan',
    'line': 'ribbon_mapper::Modeler::add_scan_line',
    'correct': 'ribbon_mapper::Modeler::correct',
    'planes': 'ribbon_mapper::Modeler::planes',
}


def counted(program, directory):
    """Runs the program under callgrind; instructions by stage, and what it printed."""
    profile = pathlib.Path(directory) / 'callgrind.out'
    command = ['valgrind', '--tool=callgrind', '--collect-atstart=no',
               f'--callgrind-out-file={profile}']
    command += [f'--toggle-collect={name}(*' for name in STAGES.values()]
    run = subprocess.run(command + [program], check=True, capture_output=True, text=True)
    table = subprocess.run(['callgrind_annotate', '--inclusive=yes', '--threshold=100', profile],
                           check=True, capture_output=True, text=True).stdout
    counts = {}
    for stage, name in STAGES.items():
        found = re.search(r'^\s*([\d,]+) .*:' + re.escape(name) + r'\(', table, re.MULTILINE)
        if not found:
            sys.exit(f'guard: {name} was not called, or it was inlined: name another in {__file__}')
        counts[stage] = int(found.group(1).replace(',', ''))
    return counts, run.stdout.strip()


def compare(counts, result, budget):
    """Prints both; true if all is within the budget and the work is the same."""
    good = True
    for stage, count in counts.items():
        share = count / budget['instructions'][stage]
        word = 'OVER THE BUDGET' if share > ROOM else 'renew it' if share < 1 / ROOM else 'ok'
        good &= share <= ROOM
        allowed = budget['instructions'][stage]
        print(f'{stage:8} {count:>15,} of {allowed:>15,}  {share:6.3f}  {word}')
    if result != budget['result']:
        print(f'the result is "{result}", not "{budget["result"]}" as when the budget was written')
    return good


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('program', help='bench/guard/instructions_input as built')
    parser.add_argument('budget', type=pathlib.Path, help='bench/guard/budget.json')
    parser.add_argument('--renew', action='store_true', help='write the budget')
    arguments = parser.parse_args()
    if not shutil.which('valgrind'):
        print('guard: valgrind is not installed, nothing is counted (./install_dependencies bench)')
        return SKIPPED
    with tempfile.TemporaryDirectory() as directory:
        counts, result = counted(arguments.program, directory)
    if arguments.renew:
        budget = {'instructions': counts, 'result': result}
        arguments.budget.write_text(json.dumps(budget, indent=2) + '\n')
        print(f'wrote {arguments.budget}')
        return 0
    if compare(counts, result, json.loads(arguments.budget.read_text())):
        return 0
    print(f'guard: if the work is worth it: {sys.argv[0]} --renew {arguments.program} '
          f'{arguments.budget}')
    return 1


if __name__ == '__main__':
    sys.exit(main())
