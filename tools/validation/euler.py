"""The Eulerian solver against exact tubes and, for a charge in air, against itself from one dimension to three (validate_euler)."""
import math

from page import records, table, write

NAMES = ["Sod", "TNT against air"]


def tube_table(lines):
    """Errors and orders of the tubes."""
    rows = []
    for name in NAMES:
        before = None
        for r in (r for r in lines if r["kind"] == "tube" and r["name"] == name):
            orders = [f"{math.log2(a / b):.2f}" for a, b in zip(before["errors"], r["errors"])] if before else ["-"] * 3
            rows.append([name, r["cells"], *[f"{e:.2e}" for e in r["errors"]], " / ".join(orders)])
            before = r
    return table(["tube", "cells", "density", "velocity", "pressure", "orders"], rows)


def charge_table(lines):
    """The front of a charge's blast."""
    words = {"shells": "line of shells", "rings": "plane of rings", "boxes": "space of boxes"}
    rows = []
    for r in lines:
        if r["kind"] != "charge":
            continue
        along, upward, corner, across = (f"{front:.4f}" for front in r["fronts"])
        fronts = {"shells": [along, "-", "-", "-"], "rings": [along, upward, across, "-"], "boxes": [along, upward, corner, across]}[r["space"]]
        rows.append([words[r["space"]], r["cells"], r["in_radius"], *fronts, r["steps"], r["ns"], f"{r['energy_drift']:.0e}"])
    head = ["grid", "cells along x", "cells in the charge's radius", "front along x [m]", "along y [m]", "along x = y [m]", "along x = y = z [m]", "steps",
            "CPU ns per cell and step", "energy off by"]
    return table(head, rows)


def make(build, out, options):
    """Makes the tables."""
    lines = records([build / "tests/validate_euler"], out / "euler.jsonl", options.dry)
    if lines:
        write("euler", "\n\n".join(["Tubes: mean errors over the mean size of the exact values, and orders over the last halving (density / velocity / pressure).",
                                    tube_table(lines), "15 kg of TNT (JWL, lit at its centre) in air after 0.2 ms; the radial flow has the front at 0.8467 m.",
                                    charge_table(lines)]))
