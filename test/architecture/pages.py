# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Markdown pages: their links lead somewhere, all are reached, and their commands are run.

A block of commands is fenced as ```bash. It is run by the tests, unless a comment right before it
says why not: <!-- not run: needs a robot -->. Every fence names its language, so that no command
escapes.
"""
import collections
import pathlib
import re
import subprocess

Block = collections.namedtuple("Block", "page line language marked reason text")

_LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\]]*\])*\]\(<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\)")
_MARK = re.compile(r"<!--\s*not run(?::\s*(.*?))?\s*-->", re.S)
# Pages whose commands are run. What others show is output, or belongs to one recording.
COMMAND_PAGES = ["README.md", "CONTRIBUTING.md", "docs/how_to/*.md", "examples/README.md"]


def pages(root):
    """Returns the Markdown pages of the repository (of the folder, where it is none)."""
    listed = subprocess.run(["git", "ls-files", "*.md"], cwd=root, text=True, capture_output=True)
    names = listed.stdout.split() if listed.returncode == 0 else []
    return sorted(root / name for name in names if (root / name).exists()) or sorted(
        root.rglob("*.md"))


def broken_links(root):
    """Returns one message for each relative link without a file or heading behind it."""
    messages = []
    for page in pages(root):
        for line, target in _links(page.read_text()):
            place, _, anchor = target.partition("#")
            path = (page.parent / place).resolve() if place else page
            where = f"{page.relative_to(root)}:{line}"
            if not path.exists():
                messages.append(f"{where}: no such file: {target}")
            elif anchor and path.suffix == ".md" and anchor not in _anchors(path.read_text()):
                messages.append(f"{where}: no such heading: {target}")
    return messages


def unreached(root):
    """Returns one message for each page to which no chain of links leads from README.md."""
    todo, reached = [(root / "README.md").resolve()], set()
    while todo:
        page = todo.pop()
        if page in reached or page.suffix != ".md" or not page.exists():
            continue
        reached.add(page)
        todo += [(page.parent / target.partition("#")[0]).resolve()
                 for _, target in _links(page.read_text()) if not target.startswith("#")]
    return [f"{page.relative_to(root)}: no link from README.md leads here"
            for page in pages(root) if page.resolve() not in reached]


def _links(text):
    """Yields (line, target) of the relative links outside of code."""
    fenced = False
    for number, line in enumerate(text.splitlines(), 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
        elif not fenced:
            for target in _LINK.findall(re.sub(r"`[^`]*`", "``", line)):
                if not re.match(r"[a-z][a-z+.-]*:", target):
                    yield number, target


def _anchors(text):
    """Returns the anchors of the headings, as GitHub makes them."""
    found = collections.Counter()
    anchors = set(re.findall(r'<a (?:id|name)="([^"]+)"', text))
    for heading in re.findall(r"^#+ +(.*?)\s*#*$", _without_code(text), re.M):
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        slug = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        anchors.add(f"{slug}-{found[slug]}" if found[slug] else slug)
        found[slug] += 1
    return anchors


def _without_code(text):
    return re.sub(r"```.*?```", "", text, flags=re.S)


def blocks(root):
    """Returns the fenced blocks of the pages whose commands are run."""
    return [block for pattern in COMMAND_PAGES for page in sorted(root.glob(pattern))
            for block in _blocks_of(page, page.relative_to(root))]


def _blocks_of(page, name):
    lines, begin, before = page.read_text().splitlines(), None, ""
    for number, line in enumerate(lines, 1):
        fence = re.match(r"\s*```(\S*)", line)
        if not fence and begin is None and line.strip():
            open_comment = before.startswith("<!--") and "-->" not in before
            before = f"{before}\n{line}" if open_comment else line
        elif fence and begin is None:
            begin, language = number, fence.group(1)
        elif fence:
            mark = _MARK.match(before.strip())
            yield Block(str(name), begin, language, bool(mark), mark.group(1) if mark else None,
                        "\n".join(lines[begin:number - 1]))
            begin, before = None, ""


def wrong_blocks(root):
    """Returns one message for each fence without a language, or mark without a reason."""
    messages = []
    for block in blocks(root):
        where = f"{block.page}:{block.line}"
        if not block.language:
            messages.append(f"{where}: a fence without a language (bash, text, cpp, ...)")
        elif block.language in {"sh", "shell", "console"}:
            messages.append(f"{where}: commands are fenced as bash, not {block.language}")
        elif block.marked and not block.reason:
            messages.append(f"{where}: 'not run' without a reason")
    return messages


def failing_commands(root, folder, timeout_s=600):
    """Runs the blocks in `folder`, a copy of `root`; returns one message for each that fails."""
    messages = []
    for block in blocks(root):
        if block.language != "bash" or block.marked:
            continue
        where = f"{block.page}:{block.line}"
        try:
            run = subprocess.run(["bash", "-eo", "pipefail", "-c", block.text], cwd=folder,
                                 text=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, timeout=timeout_s)
        except subprocess.TimeoutExpired:
            messages.append(f"{where}: not done after {timeout_s} s")
            continue
        if run.returncode != 0:
            messages.append(f"{where}: exit status {run.returncode}:\n{run.stdout[-1000:]}")
    return messages


def scratch_copy(root, build, folder):
    """Fills `folder` with the tracked files and a link to the build folder."""
    names = subprocess.check_output(["git", "ls-files", "-z"], cwd=root, text=True).split("\0")
    for name in filter(None, names):
        if (root / name).is_file():
            target = pathlib.Path(folder) / name
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes((root / name).read_bytes())
            target.chmod((root / name).stat().st_mode)
    (pathlib.Path(folder) / "build").symlink_to(build)
