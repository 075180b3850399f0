# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""The rooms of the house, and what each may include: the one place where this is written."""
import collections
import pathlib
import re

# Of ours: folders (without those below them, or with them if they end in /) or single files.
# Libraries: the first folder of an #include <folder/file>. ANY: all libraries, ROS among them.
Room = collections.namedtuple("Room", "ours libraries")
ANY = None

# The method, each room with what it may include of the others.
_CORE = {
    "geometry": [],
    "polygon": [],
    "scan": ["geometry"],
    "ribbon": ["geometry", "scan"],
    "trajectory": ["geometry"],
    "observations": ["geometry", "ribbon", "trajectory"],
    "association": ["geometry", "ribbon", "observations"],
    "surface": ["geometry", "polygon", "ribbon", "observations", "association"],
    "assembly": ["geometry", "polygon", "ribbon", "observations", "association", "surface"],
    "maps": ["geometry", "ribbon", "observations", "surface"],
    "semantics": ["geometry", "polygon", "surface"],
    "floor_plan": ["geometry", "polygon", "surface", "semantics"],
    "chain": ["geometry"],
    "registration": ["geometry", "ribbon", "trajectory", "observations", "association", "chain"],
}
_METHOD = [f"modeler/{name}" for name in _CORE]
_MODELER = _METHOD + ["modeler"]
_TOOLS = _MODELER + ["modeler/calibration", "modeler/storage", "modeler/io", "modeler/map_files",
                     "modeler/text", "modeler/mesh", "modeler/exports", "modeler/model_file", "modeler/report",
                     "modeler/program"]
_ROS = ["modeler/ros/messages", "modeler/ros/intake", "modeler/ros/node", "modeler/ros/run"]
_SIM = ["sim/shapes", "sim/sdf", "sim/world", "sim/rays", "sim/robot", "sim/tour", "sim/truth"]
_POSE = ["modeler/geometry/time.hpp", "modeler/geometry/pose.hpp"]

ROOMS = {
    **{f"modeler/{name}": Room([f"modeler/{other}" for other in others], ["Eigen", "geos_c.h", "tsl", "unsupported"])
       for name, others in _CORE.items()},
    "modeler": Room(_METHOD, ["Eigen"]),
    "modeler/calibration": Room(_MODELER, ["Eigen"]),
    "modeler/storage": Room([], ["sys"]),
    "modeler/text": Room([], ["Eigen", "nlohmann", "yaml-cpp"]),
    "modeler/io": Room(_MODELER + ["modeler/calibration", "modeler/storage", "modeler/text"],
                       ["Eigen", "nlohmann", "octomap", "yaml-cpp"]),
    "modeler/map_files": Room(_MODELER + ["modeler/storage", "modeler/io"], ["Eigen"]),
    "modeler/mesh": Room(_MODELER + ["modeler/storage", "modeler/io"], ["Eigen", "GL", "assimp"]),
    "modeler/exports": Room(_MODELER + ["modeler/storage", "modeler/io", "modeler/mesh",
                                        "modeler/text"],
                            ["CLI", "Eigen", "nlohmann"]),
    "modeler/model_file": Room(_MODELER + ["modeler/calibration", "modeler/storage", "modeler/io",
                                           "modeler/text"], ["Eigen"]),
    "modeler/report": Room(_MODELER + ["modeler/text"], ["Eigen", "nlohmann"]),
    "modeler/program": Room([], ["sys"]),
    "slam/lines": Room(_MODELER, ["Eigen"]),
    "slam/places": Room(_MODELER + ["slam/matching", "slam/lines"], ["Eigen", "tsl"]),
    "slam/tilting": Room(_MODELER + ["slam/lines", "slam/places"], ["Eigen"]),
    "modeler/ros/messages": Room(_TOOLS, ANY),
    "modeler/ros/intake": Room(_TOOLS + ["modeler/ros/messages"], ANY),
    "modeler/ros/maps": Room(_TOOLS + ["modeler/ros/messages"], ANY),
    "modeler/ros/node": Room(_TOOLS + ["modeler/ros/messages", "modeler/ros/intake",
                                       "modeler/ros/maps", "modeler/ros/run"], ANY),
    "modeler/ros/run": Room(["modeler/program/version.hpp"], ANY),
    "modeler/ros/calibrate": Room(_TOOLS + _ROS, ANY),
    "modeler/ros/tf_filter": Room(_TOOLS + _ROS, ANY),
    "modeler/ros/slam_adapter": Room(_TOOLS + _ROS, ANY),
    "modeler/ros/bag": Room(_TOOLS + _ROS, ANY),
    "modeler/ros/bag_timing": Room(_TOOLS + _ROS + ["modeler/ros/bag"], ANY),
    "modeler/ros/bag_check": Room(_TOOLS + _ROS + ["modeler/ros/bag", "modeler/ros/bag_timing"],
                                  ANY),
    "modeler/ros/offline": Room(_TOOLS + _ROS + ["slam/base_laser", "slam/places", "slam/tilting",
                                                 "modeler/ros/bag", "modeler/ros/bag_check"], ANY),
    # The estimate of the trajectory from a level laser knows beams, and nothing of planes.
    "slam/matching": Room(["modeler/geometry", "modeler/scan"], ["Eigen", "tsl"]),
    "slam/level": Room(["modeler/geometry", "slam/matching"], ["Eigen"]),
    "slam/base_laser": Room(["modeler/geometry", "modeler/scan", "slam/matching", "slam/level",
                             "slam/lines/odometry_source.hpp"], ["Eigen"]),
    "slam/ros": Room(_TOOLS + _ROS + ["modeler/ros/bag", "modeler/ros/bag_check", "slam/matching",
                                      "slam/level"], ANY),
    "slam/node": Room(_TOOLS + _ROS + ["slam/base_laser", "slam/lines", "slam/tilting"], ANY),
    # The simulator has its own beam geometry, so that an error in one cannot hide in the other.
    "sim/shapes": Room(_POSE, ["Eigen", "assimp", "sys"]),
    "sim/rays": Room(_POSE + ["sim/shapes"], ["Eigen", "BulletCollision", "embree3", "embree4"]),
    "sim/sdf": Room(_POSE + ["sim/shapes", "modeler/text"], ["Eigen", "sdf"]),
    "sim/world": Room(_POSE + ["sim/shapes", "sim/sdf", "sim/rays"], ["Eigen", "BulletCollision"]),
    "sim/robot": Room(_POSE + ["sim/shapes", "sim/rays", "sim/world"], ["Eigen"]),
    "sim/truth": Room(_POSE + ["sim/shapes", "sim/rays", "sim/world", "sim/robot"], ["Eigen"]),
    "sim/tour": Room(_POSE + ["sim/shapes", "sim/rays", "sim/world", "sim/robot", "modeler/text"],
                     ["Eigen", "yaml-cpp"]),
    # How messages and parameters are read, and how files are found and written, is one thing for
    # all nodes.
    "sim/ros": Room(_SIM + _POSE + ["modeler/ros/messages/message_conversions.hpp",
                                    "modeler/ros/node/strict_parameters.hpp",
                                    "modeler/ros/run/run_node.hpp",
                                    "modeler/program/installed_files.hpp",
                                    "modeler/program/interrupt.hpp",
                                    "modeler/program/progress_bar.hpp",
                                    "modeler/program/run_program.hpp",
                                    "modeler/program/version.hpp",
                                    "modeler/storage/atomic_file.hpp", "modeler/io/tum.hpp"], ANY),
    "eval/metrics": Room(_TOOLS + _SIM, ["Eigen"]),
    "eval/segmentation": Room(_TOOLS + _SIM + ["eval/metrics"], ["Eigen"]),
    "eval/semantics": Room(_TOOLS + _SIM, ["Eigen"]),
    "eval/results": Room(_TOOLS + _SIM + ["eval/metrics", "eval/segmentation", "eval/semantics",
                                          "eval/experiment"],
                         ["Eigen", "nlohmann"]),
    "eval/experiment": Room(_TOOLS + _SIM + ["slam/base_laser", "slam/tilting", "eval/metrics",
                                             "eval/segmentation", "eval/semantics",
                                             "eval/results"],
                            ["Eigen", "CLI", "nlohmann", "sys"]),
    "eval/ros": Room(_TOOLS + _ROS + _SIM + ["sim/ros", "eval/metrics", "eval/segmentation",
                                             "eval/results",
                                             "eval/experiment"], ANY),
    # Python's door to the method: no ROS, no programs.
    "python/bindings": Room(_MODELER + ["modeler/io", "modeler/model_file"], ["Eigen", "pybind11"]),
    "examples": Room(_TOOLS + _ROS + ["modeler/ros/bag", "examples"], ANY),
    "bench/": Room(_TOOLS + _SIM + ["modeler/ros/", "eval/", "bench/"], ANY),
}

MAX_LINES_OF_A_FILE = 300
MAX_SOURCES_OF_A_FOLDER = 20
TOPS = ["bench", "eval", "examples", "modeler", "python", "sim", "slam", "test", "tools"]
SOURCES = {".hpp", ".cpp", ".py"}


def wrong_includes(root):
    """Returns one message for each include that ROOMS does not allow, below the folder `root`."""
    messages = []
    for top in sorted({room.split("/")[0] for room in ROOMS}):
        for path in sorted((root / top).rglob("*")):
            if path.suffix in {".hpp", ".cpp"}:
                messages += _wrong_includes_of(path, path.relative_to(root))
    return messages


def _holds(room, folder):
    return folder == room or (room.endswith("/") and f"{folder}/".startswith(room))


def _wrong_includes_of(path, name):
    folder = name.parent.as_posix()
    room = next((row for room, row in ROOMS.items() if _holds(room, folder)), None)
    if room is None:
        table = pathlib.Path(__file__).name
        return [f"{name}: {folder} is no room, add it to the table in {table}"]
    messages = []
    for bracket, target in re.findall(r'^\s*#\s*include\s*([<"])([^>"]+)', path.read_text(), re.M):
        if bracket == '"':
            source = str(pathlib.PurePosixPath(target).parent)
            allowed = any(target == ours or _holds(ours, source) for ours in [folder] + room.ours)
        else:
            allowed = "/" not in target or room.libraries is ANY or (
                target.split("/")[0] in room.libraries)
        if not allowed:
            messages.append(f"{name} may not include {target}")
    return messages


def wrong_files(root):
    """Returns one message for each source that is too long, unlicensed, or in a drawer."""
    messages = []
    for top in TOPS:
        for path in sorted((root / top).rglob("*")):
            name = path.relative_to(root)
            if path.is_dir() and re.fullmatch(r"utils?|common|helpers?|misc", path.name):
                messages.append(f"{name}: a folder's name says what lives there")
            if path.suffix in SOURCES:
                messages += _wrong_text(path.read_text().splitlines(), name)
    return messages


def full_folders(root):
    """Returns one message for each folder with too many sources, tests among them."""
    folders = collections.Counter(
        path.parent.relative_to(root).as_posix()
        for top in TOPS
        for path in (root / top).rglob("*") if path.suffix in SOURCES)
    return [f"{folder} holds {count} sources, more than {MAX_SOURCES_OF_A_FOLDER}"
            for folder, count in sorted(folders.items()) if count > MAX_SOURCES_OF_A_FOLDER]


def _wrong_text(lines, name):
    messages = []
    if len(lines) > MAX_LINES_OF_A_FILE:
        messages.append(f"{name} has {len(lines)} lines, more than {MAX_LINES_OF_A_FILE}")
    head = [line for line in lines if not line.startswith("#!")][:2]
    if ["SPDX" in line for line in head] != [True, True]:
        messages.append(f"{name} does not begin with two SPDX lines")
    return messages
