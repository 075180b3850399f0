#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Puts the page together from its sources and writes it as a C++ source.

Usage: embed_page.py PAGE_DIRECTORY OUTPUT.cpp

In page.html, `<!-- style: a.css b.css -->` and `<!-- script: a.js b.js -->` stand for the files
named, and `<!-- data -->` for what the program inserts.
"""

import pathlib
import re
import sys

CHUNK = 12000  # characters of a literal: compilers need only accept 65536
DELIMITER = "page_text"
DATA = "<!-- data -->"


def page_of(folder):
    """Returns the page as one text."""
    def files(match):
        tag = match.group(1)
        texts = [(folder / name).read_text(encoding="utf-8") for name in match.group(2).split()]
        text = "\n".join(texts)
        if f"</{tag}" in text.lower():
            raise SystemExit(f"a file of {match.group(0)} would end its element early")
        return f"<{tag}>\n{text}\n</{tag}>"
    page = (folder / "page.html").read_text(encoding="utf-8")
    return re.sub(r"<!-- (style|script): (.*?) -->", files, page, flags=re.DOTALL)


def function_of(name, text):
    """Returns a C++ function that returns a text."""
    chunks = [text[i:i + CHUNK] for i in range(0, len(text), CHUNK)]
    literals = "\n".join(f'R"{DELIMITER}({chunk}){DELIMITER}"sv,' for chunk in chunks)
    return (f"std::string_view {name}() {{\n"
            f"  static const std::string kText = joined({{\n{literals}\n}});\n"
            "  return kText;\n}\n")


def main(folder, output):
    page = page_of(pathlib.Path(folder))
    if page.count(DATA) != 1 or f"){DELIMITER}" in page:
        raise SystemExit(f"page.html must have {DATA} once, and no ){DELIMITER}")
    before, after = page.split(DATA)
    pathlib.Path(output).write_text(
        "// Written by modeler/report/embed_page.py from modeler/report/page.\n"
        '#include "modeler/report/page.hpp"\n\n'
        "#include <initializer_list>\n#include <string>\n\n"
        "using namespace std::string_view_literals;\n\n"
        "namespace ribbon_mapper {\nnamespace {\n\n"
        "std::string joined(std::initializer_list<std::string_view> parts) {\n"
        "  std::string text;\n  for (const std::string_view part : parts) text += part;\n"
        "  return text;\n}\n\n}  // namespace\n\n"
        + function_of("page_before_data", before) + "\n" + function_of("page_after_data", after)
        + "\n}  // namespace ribbon_mapper\n", encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
