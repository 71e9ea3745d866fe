#!/usr/bin/env python3
"""clang-tidy over src/ and app/, all cores, only files that changed since they were last found clean.

    tools/tidy.py BUILD    BUILD: a configured build tree, for its compile_commands.json

A file is clean for as long as its text, every header of ours it includes, its compile command and .clang-tidy stay as they were;
the marks of clean files are kept in BUILD/tidy. Exit 1 with clang-tidy's words for files that are not.
"""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)
TOOL = "clang-tidy-19"
# The tree is g++'s: its warnings are g++'s and clang++'s own business (the asan tree compiles with clang++), not clang-tidy's.
FLAGS = ["--quiet", "--extra-arg=-Wno-everything"]


def own_files(path, seen):
    """The file and every header of ours that it reaches."""
    if path in seen:
        return seen
    seen.add(path)
    for target in INCLUDE.findall(path.read_text(encoding="utf-8")):
        for base in (ROOT / "src", ROOT / "app", path.parent):
            if (base / target).is_file():
                own_files((base / target).resolve(), seen)
                break
    return seen


def mark_of(path, command):
    """A digest of everything that clang-tidy's findings for this file depend on."""
    digest = hashlib.sha256((ROOT / ".clang-tidy").read_bytes() + command.encode())
    for part in sorted(own_files(path, set())):
        digest.update(str(part.relative_to(ROOT)).encode() + part.read_bytes())
    return digest.hexdigest()


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    marks = build / "tidy"
    marks.mkdir(exist_ok=True)
    commands = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = pathlib.Path(entry["file"]).resolve()
        if any(path.is_relative_to(ROOT / folder) for folder in ("src", "app")):
            commands[path] = mark_of(path, entry["command"])
    todo = sorted(p for p, mark in commands.items() if not (marks / mark).exists())

    def tidy(path):
        return path, subprocess.run([TOOL, "-p", str(build), *FLAGS, str(path)], capture_output=True, text=True)

    failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for path, result in pool.map(tidy, todo):
            if result.returncode == 0:
                (marks / commands[path]).touch()
            else:
                failed += 1
                print(f"{path.relative_to(ROOT)}:\n{result.stdout}{result.stderr}", flush=True)
    print(f"clang-tidy: {len(commands)} files, {len(todo)} looked at, {failed} with findings")
    return 1 if failed or not commands else 0


if __name__ == "__main__":
    sys.exit(main())
