#!/usr/bin/env python3
"""Shows that the build itself refuses a wrong include: for every pair of modules, tries it with the include folders CMake gives.

    tools/floors_build.py INCLUDES COMPILER    INCLUDES: floors/includes.txt of a build tree, one line per module

A module must find the headers of every module that it may include by the floors and is linked to, and of no other.
"""
import pathlib
import subprocess
import sys
import tempfile

import floors


def first_header(module):
    """A header of the module, as it is included; None if it has none yet."""
    source = pathlib.Path(__file__).resolve().parent.parent / "src"
    headers = sorted((source / module).rglob("*.hpp"))
    return str(headers[0].relative_to(source)) if headers else None


def compiles(compiler, folders, text, scratch):
    """Does this text compile where these folders are searched? Returns that and the compiler's words."""
    probe = pathlib.Path(scratch) / "probe.cpp"
    probe.write_text(text)
    result = subprocess.run([compiler, "-std=c++20", "-fsyntax-only", *[f"-I{f}" for f in folders], str(probe)], capture_output=True, text=True)
    return result.returncode == 0, result.stderr


def found(compiler, folders, header, scratch):
    """Is the header found? (Without compiling what is in it: that is the build's own work.)"""
    return compiles(compiler, folders, f'#if !__has_include("{header}")\n#error\n#endif\n', scratch)[0]


def refused(compiler, folders, header, scratch):
    """Is `#include "header"` an error, and for the reason that there is no such file?"""
    done, words = compiles(compiler, folders, f'#include "{header}"\n', scratch)
    return not done and header in words and ("No such file" in words or "file not found" in words)


def main():
    table, compiler = pathlib.Path(sys.argv[1]), sys.argv[2]
    folders = {line.split()[0]: line.split()[1:] for line in table.read_text().splitlines() if line.strip()}
    headers = {module: first_header(module) for module in folders}
    wrong, refusals, finds = [], 0, 0
    with tempfile.TemporaryDirectory() as scratch:
        for module in folders:
            for other, header in headers.items():
                if header is None:
                    continue
                if module == other or floors.LEVEL[other] < floors.LEVEL[module]:
                    finds += found(compiler, folders[module], header, scratch)
                elif refused(compiler, folders[module], header, scratch):
                    refusals += 1
                else:
                    wrong.append(f'{module} can include "{header}", which does not stand below it')
            if headers[module] and not found(compiler, folders[module], headers[module], scratch):
                wrong.append(f'{module} cannot include its own "{headers[module]}"')
    print("\n".join(wrong) or f"{refusals} wrong includes refused, {finds} right ones found")
    return 1 if wrong or refusals == 0 or finds == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
