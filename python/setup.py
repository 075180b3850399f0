# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Builds the Python package: CMake compiles the library of modeler/ and the module of this folder,
and installs both into the wheel. Needs the Debian packages that `./install_dependencies` has."""
import os
import pathlib
import re
import subprocess
import sys

import setuptools
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parents[1]
BUILD = ROOT / "build" / "wheel"


def version():
    """Returns the version of the project."""
    return re.search("<version>([0-9.]+)</version>", (ROOT / "package.xml").read_text()).group(1)


class CMakeBuild(build_ext):
    """Builds the module with CMake."""

    def run(self):
        """Configures, builds, and installs into the folder that the wheel is made of."""
        build = BUILD / f"python-{sys.version_info.major}.{sys.version_info.minor}"
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count())
        package = pathlib.Path(self.get_ext_fullpath(self.extensions[0].name)).resolve().parent
        for words in [
                ["-S", ROOT / "modeler", "-B", build, "-DBUILD_TESTING=OFF",
                 "-DBUILD_SHARED_LIBS=OFF", "-DRIBBON_MAPPER_IO=ON", "-DRIBBON_MAPPER_PYTHON=ON",
                 "-DRIBBON_MAPPER_PYTHON_DESTINATION=.",
                 f"-DPython3_EXECUTABLE={sys.executable}"],
                ["--build", build, "--target", "ribbon_mapper_python", "--parallel", jobs],
                ["--install", build, "--component", "python", "--prefix", package.parent]]:
            subprocess.run(["cmake", *words], check=True)


BUILD.mkdir(parents=True, exist_ok=True)
setuptools.setup(
    name="ribbon_mapper",
    version=version(),
    description="Planes from the lines of a tilting laser, kept right when SLAM corrects the "
                "trajectory",
    license="BSD-3-Clause",
    python_requires=">=3.8",
    install_requires=["numpy"],
    packages=["ribbon_mapper"],
    package_data={"ribbon_mapper": ["_core.pyi", "py.typed"]},
    ext_modules=[setuptools.Extension("ribbon_mapper._core", [])],
    cmdclass={"build_ext": CMakeBuild},
    options={"build": {"build_base": str(BUILD / "setuptools")},
             "egg_info": {"egg_base": str(BUILD)}},
    zip_safe=False)
