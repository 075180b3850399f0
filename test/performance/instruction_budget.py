#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts the instructions of a fixed input with callgrind and compares them with a budget.

Unlike times, instruction counts do not depend on the load of the machine. `--renew` replaces the
budget, for changes that are worth their cost.
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

MAX_RATIO = 1.10  # to the budget; compilers and C libraries differ a little
SKIPPED = 77  # exit code that ctest reports as skipped
STAGES = {
    'scan': 'ribbon_mapper::sim::Tour::next_scan',
    'line': 'ribbon_mapper::Modeler::add_scan_line',
    'correct': 'ribbon_mapper::Modeler::correct',
    'planes': 'ribbon_mapper::Modeler::planes',
}


def counted(program, directory):
    """Runs the program under callgrind. Returns the instructions of each stage and the output."""
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
            sys.exit(f'instruction_budget: {name} was not called or was inlined: '
                     f'update STAGES in {__file__}')
        counts[stage] = int(found.group(1).replace(',', ''))
    return counts, run.stdout.strip()


def compare(counts, result, budget):
    """Prints counts and budget. Returns whether all counts are within the budget."""
    good = True
    for stage, count in counts.items():
        share = count / budget['instructions'][stage]
        word = ('OVER BUDGET' if share > MAX_RATIO else
                'under budget: renew it' if share < 1 / MAX_RATIO else 'ok')
        good &= share <= MAX_RATIO
        allowed = budget['instructions'][stage]
        print(f'{stage:8} {count:>15,} of {allowed:>15,}  {share:6.3f}  {word}')
    if result != budget['result']:
        print(f'the result is "{result}", not "{budget["result"]}" as at the last renewal')
    return good


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('program', help='the built instructions_input')
    parser.add_argument('budget', type=pathlib.Path,
                        help='test/performance/instruction_budget.json')
    parser.add_argument('--renew', action='store_true', help='replace the budget')
    arguments = parser.parse_args()
    if not shutil.which('valgrind'):
        print('instruction_budget: skipped, valgrind is missing (./install_dependencies test)')
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
    print(f'instruction_budget: to accept the new costs: {sys.argv[0]} --renew {arguments.program} '
          f'{arguments.budget}')
    return 1


if __name__ == '__main__':
    sys.exit(main())
