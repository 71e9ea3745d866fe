#!/usr/bin/env python3
"""The floors of the house, and a check that the sources keep them.

    tools/floors.py              check src/, app/ and src/CMakeLists.txt; exit 1 with file:line for each breach
    tools/floors.py --self-test  plant every kind of breach in a scratch tree and see each one found

Long functions are listed too, but do not fail the check.
"""
import pathlib
import re
import sys
import tempfile

# Lowest first. A module includes itself and modules of lower lines; those of one line are siblings and do not know each other.
FLOORS = [
    ["base"],
    ["math", "schema"],
    ["parallel"],
    ["fields", "laws"],
    ["mesh"],
    ["gas", "structure", "euler", "output", "radial"],
    ["contact"],
    ["model"],
    ["input", "simulation"],
    ["app"],
]
LEVEL = {module: level for level, line in enumerate(FLOORS) for module in line}

# Outside headers that belong behind one module's face.
OUTSIDE = {
    re.compile(r"(omp|mpi|cuda\w*|execution|thread|pthread|cub/.*|thrust/.*)(\.h|\.hpp|\.cuh)?$"): {"parallel"},
    re.compile(r"udunits2\.h$"): {"schema"},
    re.compile(r"(hdf5|H5\w*)\.h$"): {"output"},
    re.compile(r"toml\+\+/"): {"input"},
    re.compile(r"nlohmann/"): {"output", "simulation", "app"},
    re.compile(r"CLI/"): {"app"},
    re.compile(r"(iostream|print)$"): {"app"},
    re.compile(r"(gtest|gmock|benchmark)/"): set(),
}
PRINTS = re.compile(
    r"\bstd::(cout|cerr|clog)\b|(?<![\w:])(std::)?(printf|puts|putchar|vprintf)\s*\(|"
    r"\b(std::)?(fprintf|fputs|vfprintf|fwrite)\s*\([^;]*\b(stdout|stderr)\b|\bfmt::print(ln)?\s*\(\s*(stdout|stderr|\"|fg\(|fmt::)"
)
EXITS = re.compile(r"(?<![\w.:>])(std::|::)?(exit|_exit|quick_exit|abort|terminate)\s*\(")
DIRECTIVE = re.compile(r"^\s*#\s*(if|ifdef|ifndef|elif|define|undef)\b")
PRAGMA = re.compile(r"^\s*#\s*pragma\s+(?!once\b)(\w+)|\b_Pragma\b")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
LONGEST_FILE = 600
LONG_FUNCTION = 70


def without_comments(text, keep_strings=True):
    """The text with comments (and, if asked, the insides of strings) blanked, every line kept in its place."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|R"([^(\s]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)

    def blank(match):
        found = match.group(0)
        if found[0] == "/" or not keep_strings:
            return "".join(c if c == "\n" else " " for c in found) if found[0] == "/" else '"' + re.sub(r"[^\n]", " ", found[1:-1]) + '"'
        return found

    return pattern.sub(blank, re.sub(r"(?<=\d)'(?=\d)", "_", text))


class House:
    """The sources under a root: what they include, and the breaches found in them."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.breaches = []
        self.notes = []
        self.includes = {}  # header path from src/ -> [(included path, line)]

    def breach(self, path, line, text):
        self.breaches.append(f"{path.relative_to(self.root)}:{line}: {text}")

    def check(self):
        for path in sorted([*self.root.glob("src/**/*.[ch]pp"), *self.root.glob("app/**/*.[ch]pp")]):
            self.check_file(path)
        self.check_cycles()
        self.check_cmake()
        return self

    def check_file(self, path):
        parts = path.relative_to(self.root).parts
        module = "app" if parts[0] == "app" else parts[1]
        if module not in LEVEL:
            self.breach(path, 1, f"module '{module}' stands on no floor; give it one in tools/floors.py")
            return
        text = path.read_text(encoding="utf-8")
        code = without_comments(text)
        self.check_includes(path, module, code)
        bare = without_comments(text, keep_strings=False)
        for number, line in enumerate(bare.split("\n"), 1):
            self.check_line(path, module, number, line)
        if text.count("\n") > LONGEST_FILE:
            self.breach(path, LONGEST_FILE + 1, f"file of {text.count(chr(10))} lines; above {LONGEST_FILE} split it by meaning")
        for name, first, length in long_functions(bare):
            self.notes.append(f"{path.relative_to(self.root)}:{first}: note: {name} has {length} lines")

    def check_includes(self, path, module, code):
        found = []
        for number, line in enumerate(code.split("\n"), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            quoted, target = match.group(1) == '"', match.group(2)
            if quoted:
                self.check_own_include(path, module, number, target)
                found.append((target, number))
            for outside, homes in OUTSIDE.items():
                if outside.match(target) and module not in homes:
                    self.breach(path, number, f"<{target}> belongs to {' and '.join(sorted(homes)) or 'tests'} only")
        self.includes[str(path.relative_to(self.root)).removeprefix("src/")] = (path, found)

    def check_own_include(self, path, module, number, target):
        other = target.split("/")[0]
        if "/" not in target or (other not in LEVEL and not (self.root / "app" / target).exists()):
            self.breach(path, number, f'"{target}": write "module/header.hpp"')
            return
        if other not in LEVEL or other == module:
            other = module
        if other != module and LEVEL[other] >= LEVEL[module]:
            kind = "a sibling of" if LEVEL[other] == LEVEL[module] else "above"
            self.breach(path, number, f"{module} includes {target}, but {other} stands {kind} {module}")
        if not any((self.root / base / target).exists() for base in ("src", "app", ".")):
            self.breach(path, number, f'"{target}" does not exist')

    def check_line(self, path, module, number, line):
        if module != "parallel":
            if DIRECTIVE.match(line):
                self.breach(path, number, "preprocessor conditions and macros belong to parallel/ only")
            if PRAGMA.search(line):
                self.breach(path, number, "pragmas belong to parallel/ only; use its loops")
        if module != "app":
            if PRINTS.search(line):
                self.breach(path, number, "only app/ prints; throw an error, or write to a file that was asked for")
            if EXITS.search(line):
                self.breach(path, number, "only app/ ends the program; throw an error")

    def check_cycles(self):
        """No header reaches itself, not even within its module."""
        done, trail = set(), []

        def visit(name):
            if name in trail:
                path = self.includes[name][0]
                self.breach(path, 1, "includes go round: " + " -> ".join(trail[trail.index(name):] + [name]))
                return
            if name in done or name not in self.includes:
                return
            trail.append(name)
            for target, _ in self.includes[name][1]:
                visit(target)
            trail.pop()
            done.add(name)

        for name in sorted(self.includes):
            visit(name)

    def check_cmake(self):
        """The build links only lower modules, and knows every module that has a folder."""
        path = self.root / "src/CMakeLists.txt"
        if not path.exists():
            return
        known = set()
        for number, line in enumerate(path.read_text().split("\n"), 1):
            match = re.match(r"\s*corpuscle_module\((.*)\)", line)
            if not match:
                continue
            module, *lower = match.group(1).split()
            known.add(module)
            for other in [module, *lower]:
                if other not in LEVEL:
                    self.breach(path, number, f"module '{other}' stands on no floor; give it one in tools/floors.py")
            for other in lower:
                if LEVEL.get(other, -1) >= LEVEL.get(module, 99):
                    self.breach(path, number, f"{module} links {other}, which does not stand below it")
        for folder in sorted(p.name for p in (self.root / "src").iterdir() if p.is_dir()):
            if folder not in known:
                self.breach(path, 1, f"src/{folder} is no module of the build")


def long_functions(bare):
    """(name, first line, lines) of functions longer than LONG_FUNCTION, in text without comments and strings."""
    found, opened, head_start = [], [], 0
    for position, char in enumerate(bare):
        if char == "{":
            head = bare[head_start:position]
            match = re.search(r"([~\w:]+|operator\S+)\s*\(", head)
            scope = re.search(r"\b(namespace|class|struct|enum|union)\b[^()]*$", head)
            inside = any(kind == "function" for kind, *_ in opened)
            kind = "function" if match and not scope and not inside and "=" not in head.split("(")[0] else "other"
            opened.append((kind, match.group(1) if match else "", position))
            head_start = position + 1
        elif char == "}" and opened:
            kind, name, start = opened.pop()
            lines = bare.count("\n", start, position) + 1
            if kind == "function" and lines > LONG_FUNCTION:
                found.append((name, bare.count("\n", 0, start) + 1, lines))
            head_start = position + 1
        elif char == ";":
            head_start = position + 1
    return found


# What the self-test plants: file, text, and the words by which the breach must be told; None where there is none.
PLANTED = [
    ("src/gas/fine.hpp", '#pragma once\n#include <vector>\n#include "base/low.hpp"\n// std::cout, #if, exit(1)\nconst char* s = "printf(";\n', None),
    ("src/output/fine.cpp", "void f() { fmt::print(file, text); std::fprintf(handle, text); }\n", None),
    ("app/fine.cpp", '#include <iostream>\n#include "gas/fine.hpp"\nint main() { std::cout << 1; }\n', None),
    ("src/parallel/fine.hpp", "#pragma once\n#include <omp.h>\n#if 1\n#pragma omp parallel\n#endif\n", None),
    ("src/base/low.hpp", "#pragma once\n", None),
    ("src/base/up.hpp", '#include "gas/fine.hpp"\n', "src/base/up.hpp:1: base includes gas/fine.hpp, but gas stands above base"),
    ("src/structure/side.hpp", '\n#include "gas/fine.hpp"\n', "src/structure/side.hpp:2: structure includes gas/fine.hpp, but gas stands a sibling of"),
    ("src/gas/short.hpp", '#include "fine.hpp"\n', 'src/gas/short.hpp:1: "fine.hpp": write'),
    ("src/gas/lost.hpp", '#include "base/lost.hpp"\n', 'src/gas/lost.hpp:1: "base/lost.hpp" does not exist'),
    ("src/gas/round.hpp", '#include "gas/back.hpp"\n', "includes go round: gas/back.hpp -> gas/round.hpp -> gas/back.hpp"),
    ("src/gas/back.hpp", '#include "gas/round.hpp"\n', "includes go round"),
    ("src/gas/omp.cpp", "\n\n#pragma omp parallel for\n", "src/gas/omp.cpp:3: pragmas belong"),
    ("src/gas/if.cpp", "#ifdef X\n#endif\n", "src/gas/if.cpp:1: preprocessor conditions"),
    ("src/gas/macro.cpp", "#define X 1\n", "src/gas/macro.cpp:1: preprocessor conditions"),
    ("src/gas/print.cpp", "void f()\n{\n    std::printf(text);\n}\n", "src/gas/print.cpp:3: only app/ prints"),
    ("src/gas/fmt.cpp", 'void f() { fmt::print("text"); }\n', "src/gas/fmt.cpp:1: only app/ prints"),
    ("src/gas/error.cpp", "void f() { std::fprintf(stderr, text); }\n", "src/gas/error.cpp:1: only app/ prints"),
    ("src/gas/exit.cpp", "void f() { std::exit(1); }\n", "src/gas/exit.cpp:1: only app/ ends"),
    ("src/gas/hdf.cpp", "#include <hdf5.h>\n", "src/gas/hdf.cpp:1: <hdf5.h> belongs to output only"),
    ("src/gas/stream.cpp", "#include <iostream>\n", "src/gas/stream.cpp:1: <iostream> belongs to app only"),
    ("src/gas/test.cpp", "#include <gtest/gtest.h>\n", "src/gas/test.cpp:1: <gtest/gtest.h> belongs to tests only"),
    ("src/gas/long.cpp", "\n" * (LONGEST_FILE + 1), f"src/gas/long.cpp:{LONGEST_FILE + 1}: file of {LONGEST_FILE + 1} lines"),
    ("src/attic/a.hpp", "\n", "src/attic/a.hpp:1: module 'attic' stands on no floor"),
    ("src/CMakeLists.txt", "corpuscle_module(base)\ncorpuscle_module(gas base structure)\n", "src/CMakeLists.txt:2: gas links structure"),
]


def self_test():
    """Plants the breaches above, and fails unless each is found and nothing else is."""
    failures = []
    with tempfile.TemporaryDirectory() as scratch:
        for name, text, _ in PLANTED:
            path = pathlib.Path(scratch) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        breaches = House(scratch).check().breaches
    for name, _, words in PLANTED:
        if words is None:
            failures += [f"found where there is none: {b}" for b in breaches if b.startswith(name + ":")]
        elif not any(words in b for b in breaches):
            failures.append(f"not found: {words}")
    body = "    x = 1;\n" * LONG_FUNCTION
    long_ones = long_functions(f"namespace a {{\nstruct S {{\nint g() {{ return 1; }}\n}};\nvoid f(int x)\n{{\n{body}}}\n}}\n")
    if [(name, line) for name, line, _ in long_ones] != [("f", 6)]:
        failures.append(f"long functions: {long_ones}")
    print("\n".join(failures) if failures else f"{len(PLANTED)} planted files judged rightly")
    return 1 if failures else 0


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    if sys.argv[1:]:
        print(__doc__)
        return 2
    house = House(pathlib.Path(__file__).resolve().parent.parent).check()
    print("\n".join(house.notes + house.breaches) or "the floors hold")
    return 1 if house.breaches else 0


if __name__ == "__main__":
    sys.exit(main())
