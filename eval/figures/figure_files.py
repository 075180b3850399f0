# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by all figures: matplotlib without a display, and atomic replacement of files."""

import os
import pathlib
import sys

try:
    import matplotlib
except ImportError:
    sys.exit("matplotlib is missing: sudo apt install python3-matplotlib")

matplotlib.use("Agg")
matplotlib.rcParams.update({
    "font.size": 8,
    "svg.hashsalt": "ribbon_mapper",  # makes the bytes reproducible
    "svg.fonttype": "none",
})


def counted(number, singular, plural):
    """Returns a number with its noun."""
    return f"{number} {singular if number == 1 else plural}"


def save(figure, path, **options):
    """Replaces the file only after the new one is complete."""
    temporary = path.with_name(f".{path.name}.tmp")
    try:
        figure.savefig(temporary, format=path.suffix[1:], **options)
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def save_both(figure, path):
    """Saves SVG and PNG; `path` has no suffix."""
    save(figure, path.with_suffix(".svg"), metadata={"Date": None})
    save(figure, path.with_suffix(".png"), dpi=200)


def words_of(error):
    """Returns what a person needs to know of an error: the file, or the key that lacks."""
    return str(error) if isinstance(error, OSError) else repr(error)


def draw_as(name, draw):
    """Saves what `draw` makes of the folder on the command line as NAME.svg and NAME.png there."""
    if len(sys.argv) != 2:
        sys.exit(f"usage: {name}.py DIRECTORY")
    directory = pathlib.Path(sys.argv[1])
    try:
        save_both(draw(directory), directory / name)
    except (OSError, ValueError, KeyError, IndexError) as error:
        sys.exit(f"{name}.py: {words_of(error)}")
