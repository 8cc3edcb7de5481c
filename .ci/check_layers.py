#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the shape of include/: floors, cycles, umbrellas, guards, and what may not be included where.

A header includes its own folder and the folders that its floor sees, never up and never sideways. Prints one line for
each violation and exits 1 if there is any.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
INCLUDE = ROOT / "include"

# folder: (floor, the folders it sees besides its own; each also brings what it sees itself)
FLOORS = {
    "base": (0, []),
    "number": (1, ["base"]),
    "execution": (1, ["base"]),
    "algebra": (2, ["number"]),
    "geometry": (3, ["algebra"]),
    "clip": (4, ["geometry"]),
    "bsp": (5, ["clip", "execution"]),
    "region": (6, ["bsp"]),
    "setop": (7, ["region"]),
    "query": (7, ["region"]),
    "mesh": (8, ["region"]),
    "shape": (9, ["mesh"]),
    "io": (9, ["mesh"]),
    "inspect": (10, ["setop", "query", "shape", "io"]),
}

# Adapters of optional libraries: no umbrella includes them.
OPT_IN = {
    "cleave/execution/tbb.hpp",
    "cleave/number/gmp.hpp",
    "cleave/number/boost_cpp.hpp",
    "cleave/number/boost_gmp.hpp",
}

STREAMS = {"iostream", "istream", "ostream", "fstream", "sstream", "iomanip", "ios", "syncstream", "spanstream"}
MAY_STREAM = {"io", "inspect"}

DUMPING_GROUNDS = {"detail", "details", "util", "utils", "utility", "common", "misc", "internal", "impl", "bits"}

LONG = 500

problems = []
notes = []


def problem(path, line, text):
    problems.append(f"{path.relative_to(ROOT)}:{line}: {text}" if line else f"{path.relative_to(ROOT)}: {text}")


def seen_from(folder):
    """The folders that a header of `folder` may include, its own among them."""
    seen = {folder}
    todo = [folder]
    while todo:
        for below in FLOORS[todo.pop()][1]:
            if below not in seen:
                seen.add(below)
                todo.append(below)
    return seen


def check_table():
    """The table itself: what a folder sees is on a lower floor."""
    for folder, (floor, sees) in FLOORS.items():
        for below in sees:
            if FLOORS[below][0] >= floor:
                problems.append(f"the table of floors: {folder} sees {below}, which is not below it")


def includes(path):
    for number, text in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', text)
        if match:
            yield number, match.group(1), match.group(2)


def folder_of(name):
    """The folder that the header `cleave/...` belongs to: its umbrella belongs to it too; None for those at the top."""
    parts = Path(name).parts
    if len(parts) == 2:
        stem = Path(name).stem
        return None if stem in ("version", "extern") else stem
    return parts[1]


def check_header(path, graph):
    name = path.relative_to(INCLUDE).as_posix()
    parts = Path(name).parts
    lines = path.read_text(encoding="utf-8").splitlines()

    if len(parts) > 3 or any(part in DUMPING_GROUNDS for part in parts):
        problem(path, 0, "no folder inside a folder, and none named " + ", ".join(sorted(DUMPING_GROUNDS)))
    if not lines or lines[0] != "// SPDX-License-Identifier: Apache-2.0":
        problem(path, 1, "the first line is the SPDX licence")
    if len(lines) < 2 or not lines[1].startswith("/// "):
        problem(path, 2, "the second line is a /// sentence that says what the header holds")
    guard = re.sub(r"[^A-Z0-9]", "_", name.upper())
    if f"#ifndef {guard}" not in lines or f"#define {guard}" not in lines:
        problem(path, 0, f"the include guard is {guard}")
    if len(lines) > LONG:
        notes.append(f"{path.relative_to(ROOT)}: {len(lines)} lines, over {LONG}: wants a second look")

    folder = folder_of(name) if name != "cleave.hpp" else None
    if folder is not None and folder not in FLOORS:
        problem(path, 0, f"the folder {folder} has no floor")
        return
    allowed = seen_from(folder) if folder is not None else set(FLOORS)
    graph[name] = []
    for number, bracket, target in includes(path):
        if target.startswith("cleave") and bracket == '"':
            problem(path, number, "headers of the library are included as <cleave/...>")
        if target in STREAMS and folder not in MAY_STREAM:
            problem(path, number, f"no <{target}> below io and inspect")
        if not (target == "cleave.hpp" or target.startswith("cleave/")):
            continue
        if not (INCLUDE / target).is_file():
            problem(path, number, f"there is no <{target}>")
            continue
        graph[name].append(target)
        if target == "cleave.hpp":
            problem(path, number, "nothing in the library includes everything")
        elif name == "cleave/version.hpp":
            problem(path, number, "the version header includes nothing")
        elif target != "cleave/version.hpp":
            other = folder_of(target)
            if other not in allowed:
                up = FLOORS.get(other, (99,))[0]
                kind = "sideways or past what it sees" if folder and up <= FLOORS[folder][0] else "upward"
                problem(path, number, f"{folder} (floor {FLOORS[folder][0]}) includes {other} (floor {up}): {kind}")
            # Umbrellas are for users; inside, each header says what it needs.
            if len(Path(target).parts) == 2 and name not in ("cleave.hpp", "cleave/extern.hpp"):
                problem(path, number, f"<{target}> is an umbrella; include the header that is meant")


def check_cycles(graph):
    state = {}
    for start in sorted(graph):
        stack = [(start, iter(graph[start]))] if start not in state else []
        state.setdefault(start, "open")
        while stack:
            name, rest = stack[-1]
            target = next(rest, None)
            if target is None:
                state[name] = "done"
                stack.pop()
            elif target not in state:
                state[target] = "open"
                stack.append((target, iter(graph.get(target, []))))
            elif state[target] == "open":
                names = [n for n, _ in stack]
                problems.append("include cycle: " + " -> ".join(names[names.index(target):] + [target]))


def reached_from(start, graph):
    reached = set()
    todo = [start]
    while todo:
        for target in graph.get(todo.pop(), []):
            if target not in reached:
                reached.add(target)
                todo.append(target)
    return reached


def check_umbrellas(graph):
    """Each folder's umbrella includes its own headers alone and reaches them all; cleave.hpp includes every umbrella."""
    everything = set(graph.get("cleave.hpp", []))
    for folder in FLOORS:
        own = {f"cleave/{folder}/{p.name}" for p in (INCLUDE / "cleave" / folder).glob("*.hpp")} - OPT_IN
        umbrella = f"cleave/{folder}.hpp"
        if not own:
            continue
        if umbrella not in graph:
            problems.append(f"include/{umbrella} is missing: the umbrella of {folder}/")
            continue
        included = set(graph[umbrella])
        for name in sorted(own - reached_from(umbrella, graph)):
            problems.append(f"include/{umbrella}: does not reach <{name}>")
        for name in sorted(included - own):
            problems.append(f"include/{umbrella}: includes <{name}>, which is not its own")
        if umbrella not in everything:
            problems.append(f"include/cleave.hpp: does not include <{umbrella}>")


def main():
    check_table()
    graph = {}
    for path in sorted(INCLUDE.rglob("*.hpp")):
        check_header(path, graph)
    check_cycles(graph)
    check_umbrellas(graph)
    for text in notes:
        print("note: " + text)
    for text in problems:
        print(text)
    print(f"layers: {len(graph)} headers, {len(problems)} violations")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
