#!/usr/bin/env pvpython
"""Opens files with ParaView's own readers and compares what they hold with FOLDER/expected.json.

    pvpython tools/check_paraview.py FOLDER

expected.json is a list: {"file": ..., "times": [...], "points": n, "cells": n, "bounds": [6 numbers],
"point_arrays": {name: [lowest, highest of each component, ...]}, "cell_arrays": {...}} at the last time.
Exit code 1 and a line for each difference.
"""
import json
import os
import sys

from paraview import simple


def close(found, expected):
    return len(found) == len(expected) and all(abs(a - b) <= 1e-6 * max(1.0, abs(b)) for a, b in zip(found, expected))


def ranges(attributes):
    """Lowest and highest of each component of each array, one list an array."""
    found = {}
    for i in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(i)
        parts = range(array.GetNumberOfComponents())
        found[array.Name] = [value for part in parts for value in array.GetRange(part)]
    return found


def differences(folder, expected):
    """Every difference between a file as ParaView sees it and what was expected of it."""
    reader = simple.OpenDataFile(os.path.join(folder, expected["file"]))
    if reader is None:
        return ["ParaView knows no reader for it"]
    times = list(getattr(reader, "TimestepValues", []) or [])
    reader.UpdatePipeline(times[-1] if times else 0.0)
    info = reader.GetDataInformation()
    found = {"times": times, "points": info.GetNumberOfPoints(), "cells": info.GetNumberOfCells()}
    found["bounds"] = list(info.GetBounds())
    wrong = []
    for key in ("points", "cells"):
        if found[key] != expected[key]:
            wrong.append(f"{key}: {found[key]}, expected {expected[key]}")
    for key in ("times", "bounds"):
        if key in expected and not close(found[key], expected[key]):
            wrong.append(f"{key}: {found[key]}, expected {expected[key]}")
    for key, data in (("point_arrays", reader.PointData), ("cell_arrays", reader.CellData)):
        arrays = ranges(data)
        for name, limits in expected.get(key, {}).items():
            if name not in arrays or not close(arrays[name], limits):
                wrong.append(f"{key} '{name}': {arrays.get(name)}, expected {limits}")
    simple.Delete(reader)
    return wrong


def main():
    folder = sys.argv[1]
    with open(os.path.join(folder, "expected.json"), encoding="utf-8") as file:
        cases = json.load(file)
    failed = False
    for case in cases:
        wrong = differences(folder, case)
        failed = failed or bool(wrong)
        for line in wrong:
            print(f"{case['file']}: {line}")
        if not wrong:
            print(f"{case['file']}: as expected")
    sys.stdout.flush()
    os._exit(1 if failed else 0)  # ParaView's own clean-up needs a display


if __name__ == "__main__":
    main()
