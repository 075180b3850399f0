# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the commands of the pages in a copy of the repository: commands_test.py BUILD_FOLDER."""
import pathlib
import sys
import tempfile

import pages

PROJECT = pathlib.Path(__file__).resolve().parents[2]


def main():
    with tempfile.TemporaryDirectory() as folder:
        pages.scratch_copy(PROJECT, pathlib.Path(sys.argv[1]).resolve(), folder)
        messages = pages.failing_commands(PROJECT, folder)
    print("\n".join(messages) or "all commands of the pages succeed")
    return 1 if messages else 0


if __name__ == "__main__":
    sys.exit(main())
