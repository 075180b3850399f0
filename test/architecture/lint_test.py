# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plants mistakes in a project of its own, and holds that lint and the warnings find each."""
import json
import pathlib
import shutil
import subprocess
import unittest

import planted

PROJECT = pathlib.Path(__file__).resolve().parents[2]
SETTINGS = PROJECT / "cmake/settings.cmake"


@unittest.skipUnless(shutil.which("clang-tidy-14"), "./install_dependencies lint")
class Lint(planted.PlantedProject):
    def lint(self, text, name="modeler/a.cpp"):
        """Returns the exit status and the output of lint on a project of one source."""
        return self.lint_sources({name: text})

    def lint_sources(self, texts):
        """Does the same with several sources, by their names."""
        sources = [self.plant(name, text) for name, text in texts.items()]
        for rules in [".clang-format", ".clang-tidy"]:
            shutil.copy(PROJECT / rules, self.root)
        (self.root / "build").mkdir(exist_ok=True)
        (self.root / "build/compile_commands.json").write_text(json.dumps([{
            "directory": str(self.root), "file": str(source),
            "command": f"/usr/bin/c++ -std=c++17 -Wall -Wextra -Wshadow -o a.o -c {source}"}
            for source in sources]))
        for words in [["init", "-q"], ["add", "-A"]]:
            subprocess.run(["git", *words], cwd=self.root, check=True)
        run = subprocess.run([PROJECT / "tools/lint", "--root", self.root], text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        return run.returncode, run.stdout

    def assert_found(self, text, *parts, **source):
        status, output = self.lint(text, **source)
        self.assertEqual(1, status, output)
        for part in parts:
            self.assertIn(part, output)

    def test_nothing_to_find(self):
        text = ("#include <vector>\n\nnamespace a {\ninline constexpr int kSize = 2;\n"
                "}  // namespace a\n")
        self.assertEqual((0, "lint: clean\n"), self.lint(text))
        self.assertEqual((0, "lint: clean\n"), self.lint(text))  # from the cache

    def test_format(self):
        self.assert_found("int  a;\n", "modeler/a.cpp:1:4: error", "-Wclang-format-violations")

    def test_names(self):
        for text, part in [("constexpr int size_m = 1;\n", "constant 'size_m'"),
                           ("int someFunction() { return 1; }\n", "function 'someFunction'"),
                           ("struct my_type {};\n", "struct 'my_type'"),
                           ("enum class A { Red };\n", "enum constant 'Red'"),
                           ("class A {\n  int a;\n};\n", "private member 'a'"),
                           ("int f(int theValue) { return theValue; }\n", "parameter 'theValue'"),
                           ("#define some_macro 1\n", "macro definition 'some_macro'")]:
            with self.subTest(text):
                self.assert_found(text, part, "readability-identifier-naming")

    def test_names_of_poses_matrices_and_units(self):
        text = ("inline constexpr int kWall_m = 1;\n\nint f(int T_map_base, int H) {\n"
                "  const int R_model_base = H + kWall_m;\n  return R_model_base + T_map_base;\n}\n")
        self.assertEqual((0, "lint: clean\n"), self.lint(text))

    def test_bug_prone_code(self):
        text = ("#include <string>\n#include <utility>\n\nstd::size_t f(std::string a) {\n"
                "  const std::string b = std::move(a);\n  return a.size() + b.size();\n}\n")
        self.assert_found(text, "'a' used after it was moved", "bugprone-use-after-move")

    def test_warnings_of_clang(self):
        text = "int f(int a) {\n  for (int a = 0; a < 2; ++a) {\n  }\n  return a;\n}\n"
        self.assert_found(text, "clang-diagnostic-shadow")
        self.assert_found(text, "-Wshadow", name="test/a.cpp")

    def test_warnings_of_clang_about_one_of_several_sources(self):
        unused = "namespace {\nconstexpr int kUnused = 3;\n}  // namespace\n"
        status, output = self.lint_sources({
            "modeler/a.cpp": unused, "modeler/b.cpp": "// nothing\n", "modeler/c.cpp": unused})
        self.assertEqual(1, status, output)
        self.assertIn("lint: 2 failures", output)
        for name in ["a", "c"]:
            self.assertIn(f"modeler/{name}.cpp:2:15: error: unused variable 'kUnused'", output)

    def test_nothing_in_the_database(self):
        self.assert_found("", "names no source", name="elsewhere/a.cpp")


class Warnings(planted.PlantedProject):
    def build(self, text, compiler, target="ribbon_mapper_core_options"):
        """Returns the exit status and the output of building one source with our warnings."""
        self.plant("a.cpp", text)
        self.plant("CMakeLists.txt",
                   f"cmake_minimum_required(VERSION 3.16)\nproject(a CXX)\ninclude({SETTINGS})\n"
                   f"add_library(a STATIC a.cpp)\ntarget_link_libraries(a {target})\n")
        build = self.root / compiler / target
        subprocess.run(["cmake", "-S", self.root, "-B", build, "-DRIBBON_MAPPER_WERROR=ON",
                        f"-DCMAKE_CXX_COMPILER={compiler}"], check=True, stdout=subprocess.DEVNULL)
        run = subprocess.run(["cmake", "--build", build], text=True, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT)
        return run.returncode, run.stdout

    def compilers(self):
        return [name for name in ["g++", "clang++-14"] if shutil.which(name)]

    def test_conversions_are_errors_in_the_core(self):
        text = "int f(double x);\nint f(double x) { return x; }\n"
        for compiler in self.compilers():
            with self.subTest(compiler):
                status, output = self.build(text, compiler)
                self.assertNotEqual(0, status)
                self.assertRegex(output, r"error: .*(float-)?conversion")
                self.assertEqual(0, self.build(text, compiler, "ribbon_mapper_options")[0])

    def test_shadows_are_errors(self):
        text = "int f(int a) {\n  for (int a = 0; a < 2; ++a) {\n  }\n  return a;\n}\n"
        for compiler in self.compilers():
            with self.subTest(compiler):
                status, output = self.build(text, compiler, "ribbon_mapper_options")
                self.assertNotEqual(0, status)
                self.assertIn("shadow", output)


if __name__ == "__main__":
    unittest.main()
