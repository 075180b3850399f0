# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Holds doc comments and the length of functions; the checks are checked, too."""
import pathlib
import unittest

import documented
import planted
from documented import cpp_reader

PROJECT = pathlib.Path(__file__).resolve().parents[2]


class Project(unittest.TestCase):
    def test_public_declarations_are_documented(self):
        self.assertEqual([], documented.undocumented(PROJECT))

    def test_functions_are_short(self):
        self.assertEqual([], documented.long_functions(PROJECT))

    def test_there_is_something_to_check(self):
        rooms = documented.declarations(PROJECT)
        self.assertGreater(len(rooms), 20)
        self.assertGreater(sum(map(len, rooms.values())), 1000)
        self.assertGreater(len(documented.functions(PROJECT, documented.CODE)), 1500)


class Reader(unittest.TestCase):
    def names(self, text, documented=None):
        return [each.name for each in cpp_reader.read(text)[0]
                if documented is None or each.documented == documented]

    def test_each_kind_of_declaration(self):
        text = """namespace a {
            class Forward;
            DECLARE_ALL_IN_ONE;
            using std::swap;
            enum class Colour { red, green = 2 };
            template <class T, int N = 3> struct Pair : Base<T> { T first{}, *second = nullptr; };
            using Alias = std::map<int, int>;
            inline constexpr int kNumbers[2] = {1, 2};
            double square(double x, std::vector<int> more = {});
            bool operator==(const A& a, const A& b);
            }"""
        self.assertEqual(
            ["Colour", "Colour::red", "Colour::green", "Pair", "first", "Alias", "kNumbers",
             "square", "operator=="], self.names(text))

    def test_what_is_not_public_or_says_itself(self):
        text = """namespace { int hidden(); }
            namespace detail { int hidden(); }
            class A : public B {
              int private_by_default();
             public:
              A(const A&); A(A&&) noexcept; A& operator=(const A&);
              A() = default; ~A();
              void run() override;
              explicit A(int x) : x_{x}, B(x) { if (x) { run(); } }
              friend void swap(A&, A&);
             protected:
              void hidden();
             private:
              struct Hidden { int x; };
            };
            inline int A::size() const { return 1; }"""
        self.assertEqual(["A", "A::A"], self.names(text))

    def test_comments_above_and_behind(self):
        text = ("/// A type.\nstruct A {\n  int a;  ///< behind\n\n  /// Above.\n  int b;\n"
                "  int c;  // not a doc comment\n  int d() const {  ///< behind a head\n"
                "    return 1;\n  }\n  int e() {\n    return 1;  ///< within a body\n  }\n};\n")
        self.assertEqual(["A", "a", "b", "A::d", "A::e"], self.names(text, documented=True))
        self.assertEqual(["c"], self.names(text, documented=False))

    def test_functions_of_all_kinds(self):
        text = ("class A {\n  A() : a_{1}, b_(2) {\n    f();\n  }\n  int g() { return 1; }\n};\n"
                "template <class T>\nauto A::f() -> T {\n  return [&] {\n    return 1;\n  }();\n}\n"
                'TEST(A, b) {\n  const char* s = "}{";\n}\n')
        self.assertEqual([("A", 2, 3), ("g", 5, 1), ("f", 7, 6), ("TEST", 13, 3)],
                         [tuple(each) for each in cpp_reader.read(text)[1]])


class PlantedDefects(planted.PlantedProject):
    def test_an_undocumented_declaration_among_many(self):
        self.plant("sim/a/a.hpp", "/// Runs.\nvoid f();\n" * 30)
        self.plant("sim/b/b.hpp", "/// Runs.\nvoid f();\n" * 30 + "void g();\n")
        self.assertEqual(["sim/b/b.hpp:61: function g has no doc comment"],
                         documented.undocumented(self.root))

    def test_a_long_method_and_a_long_test(self):
        body = "  ++a;\n" * 39
        self.plant("sim/a.hpp", "class A {\n  void f() {\n" + body + "  }\n};\n")
        self.plant("test/a.cpp", "TEST(A, b) {\n" + body + "}\n")
        self.plant("test/b.py", "def f():\n" + "    f()\n" * 40)
        self.assertEqual(
            ["sim/a.hpp:2: f has 41 lines, more than 40",
             "test/a.cpp:1: TEST has 41 lines, more than 40",
             "test/b.py:1: f has 41 lines, more than 40"], documented.long_functions(self.root))


if __name__ == "__main__":
    unittest.main()
