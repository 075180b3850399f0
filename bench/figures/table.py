#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Inserts the rows of bench.json into docs/performance.md between its two markers."""
import argparse
import json
import pathlib

BEGIN, END = '<!-- rows: by bench/figures/table.py -->', '<!-- end of rows -->'

# Name of a ratio, its bar (a number or another ratio), and whether larger values are better.
BARS = [
    ('normals_vs_pcl', 20, True), ('normals_per_eigen', 2, False),
    ('line_per_eigen', 2, False), ('line_p999_over_median', 8, False),
    ('planes_vs_best_raw_peer', 20, True), ('planes_vs_best_voxel_peer', 3, True),
    ('f1', 'best_peer_f1', True),
    ('correction_vs_octomap', 500, True), ('correction_vs_rebuild', 20, True),
    ('correction_over_floor', 5, False),
    ('line_growth_exponent', 0.1, False), ('correction_growth_exponent', 1.1, False),
    ('correction_growth_exponent_to_three_million', None, False),
    ('correction_tenth_over_all', 0.2, False),
    ('revision_over_correction', 0.1, False), ('revision_with_planes', 0.25, False),
    ('revision_growth_exponent', 1.2, False),
    ('memory_vs_octomap', 0.1, False), ('memory_vs_raw', 1, False),
    ('rays_vs_raytest', None, True), ('rays_embree_vs_bullet', None, True),
    # Ratios of a recorded bag, without bars.
    ('bag_line_per_eigen', None, False), ('bag_normals_vs_pcl', None, True),
    ('bag_planes_vs_best_raw_peer', None, True), ('bag_planes_vs_best_voxel_peer', None, True),
    ('bag_memory_vs_octomap', None, False), ('bag_memory_vs_raw', None, False),
]


def duration(seconds):
    for unit, size in (('s', 1.0), ('ms', 1e-3), ('us', 1e-6)):
        if seconds >= size:
            return f'{seconds / size:.3g} {unit}'
    return f'{1e9 * seconds:.3g} ns'


def cell(value, digits=3):
    if value is None:
        return ''
    return f'{value:.0f}' if abs(value) >= 1000 or digits == 0 else f'{value:.{digits}g}'


def bars_table(summary):
    """Returns the table of ratios and their bars."""
    lines = ['| ratio | measured | bar | |', '|---|---|---|---|']
    for name, bar, larger in BARS:
        if name not in summary:
            continue
        value, limit = summary[name], summary.get(bar, bar)
        text, verdict = '', ''
        if limit is not None:
            text = f'{"at least" if larger else "at most"} {limit:.3g}'
            verdict = 'met' if (value >= limit if larger else value <= limit) else 'not met'
        lines.append(f'| `{name}` | {value:.3g} | {text} | {verdict} |')
    factors = [f'{summary[f"real_time_factor_{beams}"]:.0f} x at {beams} beams'
               for beams in (380, 720, 1040) if f'real_time_factor_{beams}' in summary]
    return lines + ['', 'Real time at 40 Hz: ' + ', '.join(factors) + '.']


def section_table(section, rows):
    lines = ['', f'**{section[0].upper() + section[1:]}**', '',
             '| | time | ns per item | over ours | peak MB | accuracy |',
             '|---|---|---|---|---|---|']
    for row in rows:
        time = '' if row['seconds'] is None else duration(row['seconds'])
        lines.append(f'| {row["name"]} | {time} | {cell(row["ns_per_item"])} | '
                     f'{cell(row["over_ours"])} | {cell(row["peak_mb"], 0)} | '
                     f'{row["accuracy"]} |')
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--bench', type=pathlib.Path, default='results/bench/bench.json')
    parser.add_argument('--document', type=pathlib.Path, default='docs/performance.md')
    arguments = parser.parse_args()
    bench = json.loads(arguments.bench.read_text())
    machine = bench['machine']
    lines = [f'Measured on {machine["processor"]} (cache {machine["cache"]}), one core; '
             f'{machine["compiler"]}, `{machine["flags"]}`; {machine["peers"]}.', '']
    lines += bars_table(bench['summary'])
    sections = list(dict.fromkeys(row['section'] for row in bench['rows']))
    for section in sections:
        lines += section_table(section, [r for r in bench['rows'] if r['section'] == section])
    text = arguments.document.read_text()
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    arguments.document.write_text(before + BEGIN + '\n' + '\n'.join(lines) + '\n' + END + after)


if __name__ == '__main__':
    main()
