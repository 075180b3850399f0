# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""What headers offer without a doc comment, and which functions are too long."""
import ast
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import cpp_reader  # noqa: E402

CODE = ["bench", "eval", "examples", "modeler", "python", "sim", "slam"]
MAX_LINES_OF_A_FUNCTION = 40


def declarations(root):
    """Returns the public declarations of each room with headers: {room: [(file, declaration)]}."""
    rooms = {}
    for path in sources(root, CODE, {".hpp"}):
        name = path.relative_to(root)
        found, _ = cpp_reader.read(path.read_text())
        rooms.setdefault(name.parent.as_posix(), []).extend((name, each) for each in found)
    return {room: found for room, found in rooms.items() if found}


def undocumented(root):
    """Returns one message for each public declaration without a doc comment."""
    return [f"{name}:{each.line}: {each.kind} {each.name} has no doc comment"
            for found in declarations(root).values() for name, each in found
            if not each.documented]


def functions(root, tops):
    """Returns (file, function) of all functions of C++ and Python, methods among them."""
    found = []
    for path in sources(root, tops, {".hpp", ".cpp", ".py"}):
        name = path.relative_to(root)
        read = _of_python if path.suffix == ".py" else _of_cpp
        found += [(name, function) for function in read(path.read_text())]
    return found


def _of_cpp(text):
    return cpp_reader.read(text)[1]


def _of_python(text):
    kinds = (ast.FunctionDef, ast.AsyncFunctionDef)
    return [cpp_reader.Function(node.name, node.lineno, node.end_lineno - node.lineno + 1)
            for node in ast.walk(ast.parse(text)) if isinstance(node, kinds)]


def long_functions(root):
    """Returns one message for each function that is too long."""
    return [f"{name}:{function.line}: {function.name} has {function.length} lines, "
            f"more than {MAX_LINES_OF_A_FUNCTION}"
            for name, function in functions(root, CODE + ["test", "tools"])
            if function.length > MAX_LINES_OF_A_FUNCTION]


def sources(root, tops, suffixes):
    """Returns the files below the folders `tops` that end in one of the suffixes, sorted."""
    return [path for top in tops for path in sorted((root / top).rglob("*"))
            if path.suffix in suffixes]
