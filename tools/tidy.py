#!/usr/bin/env python3
"""clang-tidy over src/ and app/, all cores, only files that changed since they were last found clean.

    tools/tidy.py BUILD    BUILD: a configured build tree, for its compile_commands.json

Files of a module are looked at together, included by one source, as clang-tidy spends its time in the headers they share. If it has anything
to say about them (also that two of their local names clash), each half is looked at by itself, and so on: what it says of a file alone counts.
A file is clean for as long as its text, every header of ours it includes, its compile command and .clang-tidy stay as they were;
the marks of clean files are kept in BUILD/tidy. Exit 1 with clang-tidy's words for files that are not.
"""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)
USING = re.compile(r"^\s*using\s+(?:::)?(?:\w+::)+(\w+);", re.M)
TOOL = "clang-tidy-19"
# The tree is g++'s: its warnings are g++'s and clang++'s own business (the asan tree compiles with clang++), not clang-tidy's.
FLAGS = ["--quiet", f"--config-file={ROOT / '.clang-tidy'}", "--extra-arg=-Wno-everything"]
AT_ONCE = 16


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


def options_of(entry):
    """What a file is compiled with: its command without the compiler, the file and where the result goes."""
    words = shlex.split(entry["command"])[1:]
    kept = [w for i, w in enumerate(words) if w not in ("-c", "-o", entry["file"]) and words[i - 1 : i] != ["-o"]]
    return tuple(kept)


def batches_of(files, options):
    """The files in groups of the same options, at most AT_ONCE to a group, the groups as even as can be."""
    alike = {}
    for path in files:
        alike.setdefault(options[path], []).append(path)
    for group in alike.values():
        count = -(-len(group) // AT_ONCE)
        yield from (group[i::count] for i in range(count))


def idle_names(path):
    """Using-declarations that the file makes no use of: where sources are together, clang-tidy counts the use another makes of the name."""
    text = re.sub(r"//.*", "", path.read_text(encoding="utf-8"))
    idle = [name for name in USING.findall(text) if len(re.findall(rf"(?<!::)\b{name}\b", text)) == 0]
    return "".join(f"using-declaration of '{name}' is unused\n" for name in idle)


def look(path, options):
    """clang-tidy's words for a source; none if it is clean."""
    result = subprocess.run([TOOL, *FLAGS, str(path), "--", *options], capture_output=True, text=True)
    return result.stdout + result.stderr if result.returncode else ""


def look_at_all(batch, options, folder):
    """clang-tidy's words for each file of the batch: of all at once where it is clean, else of each half."""
    if len(batch) == 1:
        return {batch[0]: look(batch[0], options)}
    together = folder / f"{hashlib.sha256(str(batch).encode()).hexdigest()}.cpp"
    together.write_text("".join(f'#include "{path}"\n' for path in batch))
    words = look(together, options)
    together.unlink()
    if not words:
        return {path: "" for path in batch}
    middle = len(batch) // 2
    return look_at_all(batch[:middle], options, folder) | look_at_all(batch[middle:], options, folder)


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    marks = build / "tidy"
    marks.mkdir(exist_ok=True)
    mark, options = {}, {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = pathlib.Path(entry["file"]).resolve()
        if any(path.is_relative_to(ROOT / folder) for folder in ("src", "app")):
            mark[path], options[path] = mark_of(path, entry["command"]), options_of(entry)
    todo = sorted(path for path in mark if not (marks / mark[path]).exists())

    failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for found in pool.map(lambda batch: look_at_all(batch, options[batch[0]], marks), batches_of(todo, options)):
            for path, words in found.items():
                words += idle_names(path)
                if words:
                    failed += 1
                    print(f"{path.relative_to(ROOT)}:\n{words}", flush=True)
                else:
                    (marks / mark[path]).touch()
    print(f"clang-tidy: {len(mark)} files, {len(todo)} looked at, {failed} with findings")
    return 1 if failed or not mark else 0


if __name__ == "__main__":
    sys.exit(main())
