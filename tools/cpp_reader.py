# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads the declarations and functions of a C++ file as clang-format leaves it, without a compiler.

A declaration is public if it is at namespace scope of a header, or a public member of a public
type: types, aliases, functions, methods, data members, enumerators and constants. Not counted are
forward declarations, friends, overriding or defaulted methods, destructors, copy and move members,
definitions outside of their class, and what is in an anonymous or `detail` namespace.
"""
import collections
import re

Declaration = collections.namedtuple("Declaration", "kind name line documented")
Function = collections.namedtuple("Function", "name line length")

_TOKEN = re.compile(r"""
    (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<directive>^[ \t]*\#(?:[^\n\\]|\\.)*)
  | (?P<string>R"(?P<mark>[^\s()\\]*)\(.*?\)(?P=mark)"|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)+')
  | (?P<word>[A-Za-z_]\w*|\d(?:'?[\w.])*)
  | (?P<mark_>::|->|&&|[^\s\w])
""", re.X | re.S | re.M)
_PAIRS = {"(": ")", "[": "]", "{": "}", "<": ">"}
_SPECIFIERS = {"inline", "static", "constexpr", "extern", "virtual", "explicit", "mutable", "const",
               "typename"}


def read(text):
    """Returns (public declarations, functions with a body) of a C++ text."""
    reader = _Reader(text)
    reader.scope("namespace", public=True)
    return reader.declarations, reader.functions


class _Reader:
    def __init__(self, text):
        self.tokens, self.lines, self.at = [], [], 0
        self.above, self.behind = set(), set()
        self.declarations, self.functions = [], []
        line, end = 1, 0
        for match in _TOKEN.finditer(text):
            line += text.count("\n", end, match.start())
            end = match.start()
            if match.lastgroup == "comment" or match.group("comment"):
                self._comment(match.group(), line)
            elif not match.group("directive"):
                self.tokens.append('""' if match.group("string") else match.group())
                self.lines.append(line)

    def _comment(self, text, line):
        if text.startswith(("///<", "//!<", "/**<")):
            self.behind.add(line)
        elif text.startswith(("///", "/**")):
            self.above.add(line + text.count("\n"))

    def scope(self, kind, public, name="", shown=True):
        """Reads statements up to the closing brace; `shown`: whether what is around is public."""
        while self.at < len(self.tokens):
            token = self.tokens[self.at]
            if token == "}":
                self.at += 1
                return
            if kind == "class" and token in {"public", "protected", "private"}:
                public = shown and token == "public"
                self.at += 2
            elif token == ";":
                self.at += 1
            else:
                self._statement(kind, public, name)

    def _statement(self, kind, public, owner):
        begin = self.at
        head, arguments = self._head()
        opens = self.at < len(self.tokens) and self.tokens[self.at] == "{"
        words = [word for word in head if word not in _SPECIFIERS and word not in {"[]", '""'}]
        if words[:1] == ["template"]:
            words = [word for word in words[1:] if word not in {"<>"}]
        first = words[0] if words else ""
        if first == "namespace":
            self._namespace(words, public, opens)
        elif first in {"class", "struct", "union", "enum"} and "()" not in head and opens:
            self._type(begin, first, words, public)
        elif "()" in _before(head, "="):
            self._function(begin, head, words, arguments, public, owner, opens)
        else:
            self._other(begin, first, head, words, public)

    def _head(self):
        """Collects a statement's tokens up to its end or body; pairs of brackets become one."""
        head, arguments = [], []
        while self.at < len(self.tokens):
            token = self.tokens[self.at]
            if token in {";", "}"} or (token == "{" and _opens_body(head)):
                break
            if head and head[-1] == "operator" and not re.match(r"[\w(]", token):
                while self.tokens[self.at] != "(":
                    head[-1] += self.tokens[self.at]
                    self.at += 1
                continue
            if token in {"(", "[", "{"} or (token == "<" and "=" not in head and head):
                start = self.at
                self._skip(token)
                head.append(token + _PAIRS[token])
                if token == "(" and not arguments:
                    arguments = self.tokens[start + 1:self.at - 1]
                continue
            head.append(token)
            self.at += 1
        return head, arguments

    def _skip(self, opening):
        """Moves behind the bracket that closes the one at hand."""
        closing, self.at = _PAIRS[opening], self.at + 1
        while self.at < len(self.tokens) and self.tokens[self.at] != closing:
            token = self.tokens[self.at]
            nested = token in {"(", "[", "{"} or (token == "<" and opening == "<")
            if nested:
                self._skip(token)
            else:
                self.at += 1
        self.at += 1

    def _end_statement(self):
        while self.at < len(self.tokens) and self.tokens[self.at] not in {";", "}"}:
            self._skip("{") if self.tokens[self.at] == "{" else self._next()
        if self.at < len(self.tokens) and self.tokens[self.at] == ";":
            self.at += 1

    def _next(self):
        self.at += 1

    def _namespace(self, words, public, opens):
        if not opens:
            return self._end_statement()
        hidden = len(words) == 1 or {"detail", "internal"} & set(words)
        self.at += 1
        return self.scope("namespace", public and not hidden)

    def _type(self, begin, first, words, public):
        name = [word for word in words[1:] if re.match(r"\w", word) and
                word not in {"class", "struct", "final", "alignas"}]
        name = name[0] if name else ""
        if public and name:
            self._declare("type", name, begin, self.at)
        self.at += 1
        if first == "enum":
            self._enumerators(public, name)
        else:
            self.scope("class", public and first != "class", name, shown=public)
        self._end_statement()

    def _enumerators(self, public, owner):
        while self.tokens[self.at] != "}":
            begin = self.at
            while self.tokens[self.at] not in {",", "}"}:
                self._skip(self.tokens[self.at]) if self.tokens[self.at] in "({" else self._next()
            if public:
                self._declare("enumerator", f"{owner}::{self.tokens[begin]}", begin, self.at)
            self.at += self.tokens[self.at] == ","
        self.at += 1

    def _function(self, begin, head, words, arguments, public, owner, opens):
        place = head.index("()")
        name = head[place - 1] if place else ""
        if opens:
            self._skip("{")
            first = self.lines[begin]
            self.functions.append(Function(name, first, self.lines[self.at - 1] - first + 1))
        end = self.at - 1 if opens else self.at
        implied = ("friend" in head or "~" in head or {"override", "final"} & set(head)
                   or head[-2:] in (["=", "default"], ["=", "delete"])
                   or head[max(0, place - 2)] == "::" or first_is(words, {"using", "static_assert"})
                   or _copies(owner, name, arguments))
        if public and not implied and re.match(r"[A-Za-z_]\w|operator|[a-z]$|\w", name):
            kind = "method" if owner else "function"
            body = begin + 1 if opens else end
            self._declare(kind, f"{owner}::{name}" if owner else name, begin, max(body, begin), end)
        if not opens:
            self._end_statement()

    def _other(self, begin, first, head, words, public):
        forward = first in {"class", "struct", "union", "enum"} and len(words) <= 3
        imported = first == "using" and "=" not in head
        macro = len(head) == 1  # ROS_DECLARE_ALLINONE_SERIALIZER;
        silent = forward or imported or macro or first in {"friend", "static_assert", "typedef"}
        if public and head and not silent and "template" != head[-1]:
            kind = "alias" if first == "using" else "data"
            names = [word for word in _before(_before(head, "="), "{}")
                     if re.match(r"[A-Za-z_]\w*$", word)]
            name = words[1] if first == "using" else (names[-1] if names else "?")
            self._declare(kind, name, begin, self.at)
        self._end_statement()

    def _declare(self, kind, name, begin, *ends):
        """Adds a declaration; its comment is above, or behind on one of its lines."""
        first = self.lines[begin]
        last = max(self.lines[min(end, len(self.lines) - 1)] for end in ends)
        documented = first - 1 in self.above or any(
            line in self.behind for line in range(first, last + 1))
        self.declarations.append(Declaration(kind, name, first, documented))


def first_is(words, names):
    return bool(words) and words[0] in names


def _before(head, mark):
    return head[:head.index(mark)] if mark in head else head


def _opens_body(head):
    """Whether a brace after these tokens begins a body, not an initialiser."""
    if "=" in head:
        return False
    words = [word for word in head if word not in _SPECIFIERS and word not in {"<>", "[]"}]
    if words[:1] == ["template"]:
        words = words[1:]
    if words[:1] and words[0] in {"namespace", "class", "struct", "union", "enum"}:
        return "()" not in words
    if words == ['""']:
        return True  # extern "C"
    if "()" not in head:
        return False
    if ":" in head[head.index("()"):]:
        return not re.match(r"[\w<]", head[-1])  # a member's initialiser follows its name
    return True


def _copies(owner, name, arguments):
    """Whether a member copies or moves its own type: Name(const Name&), Name& operator=(Name&&)."""
    words = [word for word in arguments if word != "const"]
    return bool(owner) and words[:1] == [owner] and words[1:2] in (["&"], ["&&"]) and (
        name == owner or name == "operator=")
