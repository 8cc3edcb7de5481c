#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the Markdown pages: links lead somewhere, and every C++ snippet is text of a program that a test compiles.

A snippet names its source in a comment on the line before its fence:

    <!-- snippet: examples/union_2d.cpp#operations -->
    ```cpp
    Region<2> c = a | b;
    ```

and must equal, but for indentation, the lines of that file between `// [operations]` and `// [/operations]` (`#` instead
of `//` in CMake files; without `#tag` the whole file below its licence line). C++ sources must lie in examples/ or
tests/, where every .cpp file is built. Other languages need no comment, but are checked where they have one.
"""
import re
import sys
import textwrap
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COMPILED = ("examples/", "tests/")
problems = []
snippets = 0
links = 0


def pages():
    yield from sorted(ROOT.glob("*.md"))
    yield from sorted((ROOT / "docs").rglob("*.md"))
    yield from sorted((ROOT / "benchmarks").rglob("*.md"))


def tidy(lines):
    return textwrap.dedent("\n".join(line.rstrip() for line in lines)).strip("\n")


def source_text(reference):
    """The text that a snippet comment refers to, or None with a reason."""
    name, _, tag = reference.partition("#")
    path = ROOT / name
    if not path.is_file():
        return None, f"there is no file {name}"
    lines = path.read_text(encoding="utf-8").splitlines()
    if not tag:
        return tidy(line for line in lines if "SPDX-License-Identifier" not in line), None
    opening = [i for i, line in enumerate(lines) if re.fullmatch(rf"\s*(//|#) \[{re.escape(tag)}\]", line)]
    closing = [i for i, line in enumerate(lines) if re.fullmatch(rf"\s*(//|#) \[/{re.escape(tag)}\]", line)]
    if len(opening) != 1 or len(closing) != 1 or closing[0] < opening[0]:
        return None, f"{name} has not exactly one [{tag}] ... [/{tag}]"
    return tidy(lines[opening[0] + 1 : closing[0]]), None


def check_snippet(where, language, reference, body):
    global snippets
    if language == "cpp":
        snippets += 1
        if reference is None:
            problems.append(f"{where}: a C++ snippet without <!-- snippet: file#tag --> on the line before it")
            return
        name = reference.partition("#")[0]
        if not name.startswith(COMPILED) or not name.endswith(".cpp"):
            problems.append(f"{where}: {name} is not a .cpp file in {' or '.join(COMPILED)}")
            return
    if reference is None:
        return
    wanted, reason = source_text(reference)
    if wanted is None:
        problems.append(f"{where}: {reason}")
    elif tidy(body) != wanted:
        problems.append(f"{where}: differs from {reference}, which reads\n{textwrap.indent(wanted, '    ')}")


def anchors(path):
    """The anchors of a page: its headings in lower case, words joined by hyphens."""
    found = set()
    for line in path.read_text(encoding="utf-8").splitlines():
        heading = re.match(r"#+\s+(.*)", line)
        if heading:
            text = re.sub(r"[^\w\- ]", "", heading.group(1).strip().lower())
            found.add(text.replace(" ", "-"))
    return found


def check_link(page, number, target):
    global links
    if re.match(r"[a-z]+:", target):
        return  # the web is not asked
    links += 1
    name, _, anchor = target.partition("#")
    path = (page.parent / name).resolve() if name else page
    if ROOT not in path.parents and path != ROOT:
        problems.append(f"{page.relative_to(ROOT)}:{number}: {target} leads out of the repository")
    elif not path.exists():
        problems.append(f"{page.relative_to(ROOT)}:{number}: {target} leads nowhere")
    elif anchor and path.suffix == ".md" and anchor not in anchors(path):
        problems.append(f"{page.relative_to(ROOT)}:{number}: {path.name} has no heading for #{anchor}")


def check_page(page):
    fence = None  # (marker, language, reference, first line, body)
    reference = None
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if fence is not None:
            if line.strip() == fence[0]:
                check_snippet(f"{page.relative_to(ROOT)}:{fence[3]}", fence[1], fence[2], fence[4])
                fence = None
                reference = None
            else:
                fence[4].append(line)
            continue
        opened = re.match(r"\s*(```+)\s*(\w*)", line)
        if opened:
            language = {"c++": "cpp", "cc": "cpp"}.get(opened.group(2), opened.group(2))
            fence = (opened.group(1), language, reference, number, [])
            continue
        comment = re.fullmatch(r"\s*<!-- snippet: (\S+) -->\s*", line)
        reference = comment.group(1) if comment else None
        prose = re.sub(r"`[^`]*`", "", line)
        for target in re.findall(r"\]\(<?([^)\s>]+)", prose) + re.findall(r'(?:src|href)="([^"]+)"', prose):
            check_link(page, number, target)
    if fence is not None:
        problems.append(f"{page.relative_to(ROOT)}:{fence[3]}: a fence that is never closed")


def main():
    count = 0
    for page in pages():
        count += 1
        check_page(page)
    for text in problems:
        print(text)
    print(f"docs: {count} pages, {links} links, {snippets} C++ snippets, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
