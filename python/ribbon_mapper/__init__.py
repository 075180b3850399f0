# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Planes from the lines of a tilting laser, kept right when SLAM corrects the trajectory.

`Modeler` is where to begin; docs/how_to/python.md has an example. In an environment of ROS, the
messages and services are `ribbon_mapper.msg` and `ribbon_mapper.srv`.
"""
import typing

if typing.TYPE_CHECKING:
    from ribbon_mapper._core import (
        Laser, LineResult, Modeler, Outline, Plane, Statistics, __version__, planes_to_json,
        read_tum, to_tum)

__all__ = ["Laser", "LineResult", "Modeler", "Outline", "Plane", "Statistics", "__version__",
           "planes_to_json", "read_tum", "to_tum"]


def __getattr__(name: str) -> typing.Any:
    """Returns a part of the compiled module, which is loaded when it is needed: messages are not
    bound to one version of Python."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    import ribbon_mapper._core
    return getattr(ribbon_mapper._core, name)


def __dir__() -> typing.List[str]:
    return sorted([*globals(), *__all__])
