# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws number and correctness of planes over the drift of the localisation (dose and response).

Curves are medians over the seeds; bands range from the lower to the upper quartile.

Usage: python3 dose_response.py DIRECTORY

Reads summary.json of a series with several drifts from DIRECTORY, as the experiment writes it, and
writes dose_response.svg and dose_response.png there. If other conditions vary as well, only runs
with those of the first group are shown.
"""

import json

from figure_files import draw_as, matplotlib

import matplotlib.pyplot as plt  # noqa: E402 (needs the backend)

CONDITIONS = ("world", "route", "config", "noise", "tilt", "beams", "rate_hz", "speed_m_s", "deskew")
MODELS = {  # name: label, style
    "noisy_as_built": ("noisy, as built", {"color": "tab:red", "marker": "o"}),
    "noisy": ("noisy, final (control)", {"color": "tab:orange", "marker": "s"}),
    "corrected_as_built": ("corrected, as built", {"color": "tab:blue", "marker": "^"}),
    "corrected": ("corrected, final", {"color": "tab:green", "marker": "D"}),
}
PANELS = (  # key of a metric, title, axis label
    ("planes", "Number of planes", "planes"),
    ("f1", "Agreement of the planes with the truth", "F1 of the planes"),
    ("segcomp.correct_points_share", "Points in correct planes (SegComp, 80 %)",
     "share of all points"),
)


def groups_of(summary):
    """Returns one group per drift, in ascending order."""
    first = summary["groups"][0]
    same = [g for g in summary["groups"] if all(g[c] == first[c] for c in CONDITIONS)]
    return sorted(same, key=lambda group: group["drift"])


def draw_model(axes, groups, model, key):
    label, style = MODELS[model]
    values = [group["distribution"][f"four_models.{model}.{key}"] for group in groups]
    drifts = [group["drift"] for group in groups]
    axes.fill_between(drifts, [v["lower_quartile"] for v in values],
                      [v["upper_quartile"] for v in values], color=style["color"], alpha=0.2,
                      linewidth=0)
    axes.plot(drifts, [v["median"] for v in values], label=label, markersize=4, linewidth=1.2,
              **style)


def median_of(group, key):
    return group["distribution"][key]["median"]


def draw_end_errors(axes, groups):
    """Adds an upper axis with the median error of the last pose for each drift."""
    top = axes.secondary_xaxis("top")
    top.set_xticks([g["drift"] for g in groups])
    top.set_xticklabels(f"{median_of(g, 'end_drift_m'):.1f} m\n{median_of(g, 'end_drift_deg'):.0f}°"
                        for g in groups)
    top.tick_params(labelsize=6.5, length=2, pad=1)


def draw(directory):
    summary = json.loads((directory / "summary.json").read_text(encoding="utf-8"))
    groups = groups_of(summary)
    figure, panels = plt.subplots(1, len(PANELS), figsize=(9.6, 3.6))
    for axes, (key, title, name) in zip(panels, PANELS):
        for model in MODELS:
            draw_model(axes, groups, model, key)
        axes.set_xlabel("drift (1: gmapping's noise on the PR2)")
        axes.set_xticks([group["drift"] for group in groups])
        axes.set_ylabel(name)
        axes.set_title(title, fontsize=8.5, fontweight="bold", pad=26)
        axes.set_ylim(bottom=0)
        axes.grid(linewidth=0.3)
        axes.spines["right"].set_visible(False)
        draw_end_errors(axes, groups)
    panels[0].axhline(median_of(groups[0], "truth_planes"), color="black", linewidth=0.9,
                      linestyle=(0, (4, 3)), label="truth")
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=5, frameon=False)
    runs = sorted({group["runs"] for group in groups})
    figure.text(0.005, 0.985, f"{groups[0]['world']}, {'/'.join(map(str, runs))} seeds per drift; "
                "medians, bands from the lower to the upper quartile; above: median error of the "
                "last pose", fontsize=7.5, va="top")
    figure.tight_layout(rect=(0, 0.07, 1, 0.96))
    return figure


if __name__ == "__main__":
    draw_as("dose_response", draw)
