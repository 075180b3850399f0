#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Samples `bench --only profile` with perf and draws the functions that take the most time."""
import argparse
import collections
import re
import subprocess
import tempfile

import matplotlib
matplotlib.use('Agg')
from matplotlib import pyplot  # noqa: E402

STAGES = {'lines': 'lines: points to associated ribbons', 'correct': 'correct()',
          'planes': 'planes(), cells included'}
SHOWN = 9  # number of functions per stage


def sampled(program, output, data):
    """Returns the shares of all samples by stage and function."""
    subprocess.run(['perf', 'record', '-q', '-e', 'cpu-clock', '-F', '2000', '-o', data, program,
                    '--only', 'profile', '--output', output], check=True, stdout=subprocess.DEVNULL)
    text = subprocess.run(['perf', 'report', '-i', data, '--stdio', '--percent-limit', '0',
                           '--sort', 'comm,sym', '-t', '|'],
                          check=True, capture_output=True, text=True).stdout
    stages = collections.defaultdict(collections.Counter)
    for line in text.splitlines():
        fields = [field.strip() for field in line.split('|')]
        if len(fields) != 3 or line.startswith('#') or fields[1] not in STAGES:
            continue
        stages[fields[1]][short(fields[2])] += float(fields[0].rstrip('%'))
    return stages


def short(symbol):
    """Returns a function's name without namespace and arguments; all of the kernel is one."""
    kind, name = re.match(r'\[(.)\]\s*(.*)', symbol).groups()
    if kind == 'k':
        return 'kernel: fresh memory pages'
    if re.search(r'malloc|free|operator new|operator delete|unlink_chunk', name):
        return 'malloc, free'
    name = name.replace('(anonymous namespace)::', '').replace('ribbon_mapper::', '')
    name = re.sub(r'std::_Hashtable<.*', 'std::unordered_map', name)
    name = re.sub(r'^void ', '', name)
    return name.split('(')[0].split('<')[0]


def draw(stages, picture):
    """Draws a panel for each stage, in shares of its own time."""
    whole = sum(sum(functions.values()) for functions in stages.values())
    figure, panels = pyplot.subplots(1, len(STAGES), figsize=(15, 4.2))
    for panel, (stage, title) in zip(panels, STAGES.items()):
        functions = stages[stage]
        total = sum(functions.values())
        bars = functions.most_common(SHOWN)
        bars.append(('all others', total - sum(share for _, share in bars)))
        labels = [label for label, _ in bars][::-1]
        panel.barh(labels, [100 * share / total for _, share in bars][::-1], color='#4878a8')
        panel.set_title(f'{title}\n{100 * total / whole:.0f} % of the time', fontsize=10)
        panel.set_xlabel('% of the stage')
        panel.tick_params(axis='y', labelsize=8)
        panel.spines[['top', 'right']].set_visible(False)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('program', help='the built bench')
    parser.add_argument('--output', default='results/bench', help='folder with the cached tours')
    parser.add_argument('--picture', default='docs/profile.png')
    arguments = parser.parse_args()
    with tempfile.NamedTemporaryFile() as data:
        stages = sampled(arguments.program, arguments.output, data.name)
    draw(stages, arguments.picture)


if __name__ == '__main__':
    main()
