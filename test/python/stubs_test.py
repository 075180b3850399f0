# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Holds that stubs and module agree, and that everything has a docstring by the project's rules."""
import ast
import importlib.util
import inspect
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import ribbon_mapper
import ribbon_mapper._core as core

PROJECT = pathlib.Path(__file__).resolve().parents[2]
STUB = PROJECT / "python/ribbon_mapper/_core.pyi"
# What pybind11 gives every class: its metaclass, and a constructor where Python has none.
ALLOWED = r"""ribbon_mapper\._core\.[A-Z]\w+
ribbon_mapper\._core\.(Outline|Plane|Statistics)\.__init__
ribbon_mapper\._core\.LineResult\.__(get|set)state__
.*\._pybind11_conduit_v1_
"""
PACKAGE = pathlib.Path(ribbon_mapper.__file__).parent


def stub_signatures():
    """Returns {name: parameters} of all functions and methods in the stub, without `self`."""
    found = {}
    for node in ast.parse(STUB.read_text()).body:
        inside = node.body if isinstance(node, ast.ClassDef) else [node]
        prefix = f"{node.name}." if isinstance(node, ast.ClassDef) else ""
        for function in inside:
            if isinstance(function, ast.FunctionDef) and not any(
                    "property" == getattr(each, "id", "") for each in function.decorator_list):
                found[prefix + function.name] = parameters(function.args)
    return found


def parameters(args):
    """Returns (name, default as text or None, whether it is a keyword only) of each parameter."""
    places = args.args[1:] if args.args and args.args[0].arg == "self" else args.args
    defaults = [None] * (len(places) - len(args.defaults)) + args.defaults
    return [(arg.arg, default and ast.unparse(default), False)
            for arg, default in zip(places, defaults)] + [
        (arg.arg, default and ast.unparse(default), True)
        for arg, default in zip(args.kwonlyargs, args.kw_defaults)]


def module_signature(name):
    """Returns the same as the first line of a docstring by pybind11 says it."""
    target = core
    for part in name.split("."):
        target = getattr(target, part)
    first = target.__doc__.splitlines()[0]
    text = re.sub(r"\(self: [\w.]+(, )?", "(", first)
    text = re.sub(r"<(\w+\.)*(\w+)[^>]*>", "None", text)
    function = ast.parse(f"def {text}: ...").body[0]
    return parameters(function.args)


def public(target):
    """Returns the documented names of a module or a class."""
    return {name: value for name, value in vars(target).items() if not name.startswith("_")}


class Stubs(unittest.TestCase):
    maxDiff = None

    def test_parameters(self):
        own = {name: signature for name, signature in stub_signatures().items()
               if not name.startswith("LineResult.")}
        self.assertGreater(len(own), 10)
        for name, signature in own.items():
            with self.subTest(name):
                self.assertEqual(signature, module_signature(name))

    def test_names_by_stubtest(self):
        if not importlib.util.find_spec("mypy"):
            self.skipTest("./install_dependencies test")
        if tuple(int(part) for part in np.__version__.split(".")[:2]) < (1, 21):
            self.skipTest("numpy has no types before 1.21")
        with tempfile.TemporaryDirectory() as folder:
            allowed = pathlib.Path(folder, "allowed")
            allowed.write_text(ALLOWED)
            run = subprocess.run(
                [sys.executable, "-m", "mypy.stubtest", "ribbon_mapper._core", "--allowlist",
                 str(allowed), "--ignore-unused-allowlist"], cwd=folder, text=True,
                env={**os.environ, "MYPYPATH": str(PACKAGE.parent)}, stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT)
        self.assertEqual(0, run.returncode, run.stdout)

    def test_the_package_has_all_of_the_module(self):
        names = set(public(core)) | {"__version__"}
        self.assertEqual(names, set(ribbon_mapper.__all__))
        for name in names:
            self.assertIs(getattr(core, name), getattr(ribbon_mapper, name))
        self.assertLessEqual(names, set(dir(ribbon_mapper)))
        with self.assertRaisesRegex(AttributeError, "has no attribute 'Modeller'"):
            ribbon_mapper.Modeller

    def test_the_version_is_that_of_the_project(self):
        self.assertIn(f"<version>{ribbon_mapper.__version__}</version>",
                      (PROJECT / "package.xml").read_text())

    def test_the_stub_is_beside_the_module(self):
        self.assertEqual(STUB.read_text(), (PACKAGE / "_core.pyi").read_text())
        self.assertTrue((PACKAGE / "py.typed").exists())

    def test_messages_do_without_the_module(self):
        code = ("import sys, ribbon_mapper\n"
                "sys.exit('ribbon_mapper._core' in sys.modules or 'numpy' in sys.modules)")
        subprocess.run([sys.executable, "-c", code], check=True,
                       env={**os.environ, "PYTHONPATH": str(PACKAGE.parent)})


class Docstrings(unittest.TestCase):
    def texts(self):
        """Returns the docstring of each public name."""
        for name, value in public(core).items():
            yield name, value.__doc__
            if inspect.isclass(value):
                for member, inner in public(value).items():
                    is_value = isinstance(inner, (core.LineResult, property)) and (
                        value is core.LineResult)
                    if not is_value:
                        inner = getattr(inner, "__func__", inner)
                        yield f"{name}.{member}", inner.__doc__

    def test_all_have_one_with_short_sentences(self):
        found = dict(self.texts())
        self.assertGreater(len(found), 35)
        for name, text in found.items():
            with self.subTest(name):
                self.assertTrue(text)
                is_function = re.match(r"\w+\(.*\) -> ", text)
                if is_function:
                    text = "\n".join(text.splitlines()[1:]).strip()
                    self.assertRegex(text, r"^[A-Z]\w+s ")  # a verb in the third person
                for sentence in re.split(r"(?<=[.:;])\s", " ".join(text.split())):
                    self.assertLessEqual(len(sentence.split()), 25, sentence)


if __name__ == "__main__":
    unittest.main()
