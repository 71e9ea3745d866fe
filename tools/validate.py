#!/usr/bin/env python3
"""The runs behind the tables and figures of docs/validation.md, topic by topic (one file each in tools/validation).

    tools/validate.py BUILD [TOPIC...] [--out DIR] [--most N] [--seeds N] [--dry]

BUILD: build/release. TOPIC: which to make (all). --out: where runs are kept (results/validation); those already there are not repeated.
--most: leave out particle counts above N. --seeds: seeds for each row (3). --dry: write what is there, run nothing.
"""
import argparse
import importlib
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tools/validation"))


def main():
    topics = sorted(file.stem for file in (ROOT / "tools/validation").glob("*.py") if file.stem != "page")
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("topics", nargs="*", metavar="TOPIC", choices=[*topics, []], help=", ".join(topics))
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "results/validation")
    parser.add_argument("--most", type=int, default=10**9)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--dry", action="store_true")
    options = parser.parse_args()
    for topic in options.topics or topics:
        out = options.out / topic
        out.mkdir(parents=True, exist_ok=True)
        importlib.import_module(topic).make(options.build.resolve(), out, options)
    return 0


if __name__ == "__main__":
    sys.exit(main())
