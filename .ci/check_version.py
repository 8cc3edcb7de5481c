#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that every place which states the version agrees with include/cleave/version.hpp."""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
problems = []


def expect(where, found, wanted):
    if found != wanted:
        problems.append(f"{where}: says {found}, and include/cleave/version.hpp says {wanted}")


header = (ROOT / "include/cleave/version.hpp").read_text(encoding="utf-8")
numbers = dict(re.findall(r"#define CLEAVE_VERSION_(MAJOR|MINOR|PATCH) (\d+)", header))
version = ".".join(numbers[part] for part in ("MAJOR", "MINOR", "PATCH"))
minor = f"{numbers['MAJOR']}.{numbers['MINOR']}"

expect("CLEAVE_VERSION_STRING", re.search(r'CLEAVE_VERSION_STRING "([^"]*)"', header).group(1), version)
expect("the inline namespace", re.search(r"inline namespace (\w+)", header).group(1), "v" + minor.replace(".", "_"))

changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
newest = re.search(r"^## (\S+)", changelog, re.MULTILINE)
expect("CHANGELOG.md", newest.group(1) if newest else "nothing", version)

# What a reader is told to ask CMake for.
texts = [ROOT / "README.md", *(ROOT / "docs").rglob("*.md"), *(ROOT / "tests/package").rglob("CMakeLists.txt")]
for path in texts:
    if path.is_file():
        for found in re.findall(r"find_package\(cleave (\d[\d.]*)", path.read_text(encoding="utf-8")):
            expect(path.relative_to(ROOT), found, minor)

for text in problems:
    print(text)
print(f"version: {version}, {len(problems)} disagreements")
sys.exit(1 if problems else 0)
