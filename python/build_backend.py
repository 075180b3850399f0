# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""What `pip install .` calls: setuptools, for the setup.py of this folder.

In the root of a catkin package, a setup.py would be taken for one of catkin's.
"""
import os
import pathlib

from setuptools.build_meta import (  # noqa: F401
    build_wheel, get_requires_for_build_wheel, prepare_metadata_for_build_wheel)

os.chdir(pathlib.Path(__file__).resolve().parent)
