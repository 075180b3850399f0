# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""What all figures have in common: matplotlib without a screen, and files that are whole."""

import os
import sys

try:
    import matplotlib
except ImportError:
    sys.exit("matplotlib is missing: sudo apt install python3-matplotlib")

matplotlib.use("Agg")
matplotlib.rcParams.update({
    "font.size": 8,
    "svg.hashsalt": "ribbon_mapper",  # the same run gives the same bytes
    "svg.fonttype": "none",
})


def save(figure, path, **options):
    """The old file stays until the new one is whole."""
    temporary = path.with_name(f".{path.name}.tmp")
    try:
        figure.savefig(temporary, format=path.suffix[1:], **options)
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def save_both(figure, path):
    """`path` without its ending."""
    save(figure, path.with_suffix(".svg"), metadata={"Date": None})
    save(figure, path.with_suffix(".png"), dpi=200)
