#!/usr/bin/env python3
"""The runs behind the table of docs/validation.md: the plate of examples/01_plate at three distances, two sets of TNT, four
particle counts and three seeds, and the empirical load beside them.

    tools/validate.py PROGRAM [--out DIR] [--most N] [--seeds N] [--dry]

PROGRAM: build/release/app/corpuscle. --out: where the runs go (results/validation); runs already there are not repeated. --most: leave out
counts above N. --seeds: seeds for each count (3). --dry: make the table of what is there, run nothing.
The counts are those of a whole plate; the case is a quarter of it and carries a quarter of them.
"""
import argparse
import csv
import json
import pathlib
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
CASE = ROOT / "examples/01_plate/case.toml"
EMPIRICAL_CASE = ROOT / "examples/01_plate/conwep.toml"
PAGE = ROOT / "docs/validation.md"
BEGIN, END = "<!-- plate: made by make validate -->", "<!-- plate: end -->"

DISTANCES = [400, 700, 1000]  # mm, from the charge's centre to the plate
EXPLOSIVES = ["tnt", "tnt_paper"]
WHOLE_COUNTS = [16_000, 80_000, 200_000, 800_000]
QUARTERS = 4
COLUMN = "center.displacement_z [m]"


def first_peak(deflections):
    """The first peak of a deflection curve: its highest value before it first falls back by half; wiggles on the way do not count."""
    highest = 0.0
    for value in deflections:
        highest = max(highest, value)
        if highest > 0.3 * max(deflections) and value < 0.5 * highest:
            break
    return highest


def settings(distance, explosive=None, count=None, seed=None):
    """The --set of one run."""
    center = f'[0, 0, "{distance} mm"]'
    chosen = []
    if explosive is None:
        return [f"load.0.conwep.center={center}"]
    chosen += [f"charge.0.center={center}", f"charge.0.detonation.0.point={center}", f'charge.0.explosive="{explosive}"']
    return chosen + [f"gas.particles={count // QUARTERS}", f"gas.seed={seed}"]


def run(program, case, folder, chosen, dry):
    """Runs one case unless it was run before; returns (first peak [mm], impulse on the whole plate [N s], wall [s], cpu [s]) or None."""
    summary_path = folder / "summary.json"
    if not summary_path.exists() or json.loads(summary_path.read_text())["status"] != "done":
        if dry:
            return None
        command = [str(program), "run", str(case), "--out", str(folder), "--quiet", "--force", "--set", "output.fields_every=1"]
        for setting in chosen:
            command += ["--set", setting]
        print(folder.name, flush=True)
        subprocess.run(command, check=True)
    summary = json.loads(summary_path.read_text())
    with open(folder / "history.csv", newline="") as file:
        rows = list(csv.DictReader(file, skipinitialspace=True))
    deflections = [-float(row[COLUMN]) for row in rows if row[COLUMN] not in ("", "nan")]
    impulse = QUARTERS * -summary["parts"]["plate"]["impulse_n_s"][2]
    return 1000 * first_peak(deflections), impulse, summary["wall_s"], summary["cpu_s"]


def spread(values, digits):
    """Mean and, of several, their deviation: "46.1 +- 0.3"."""
    mean = f"{statistics.mean(values):.{digits}f}"
    return mean if len(values) == 1 else f"{mean} +- {statistics.stdev(values):.{digits}f}"


def rows_of(program, options):
    """The rows of the table, each a list of texts."""
    rows = []
    for distance in DISTANCES:
        for explosive in EXPLOSIVES:
            for count in (c for c in WHOLE_COUNTS if c <= options.most):
                runs = []
                for seed in range(1, options.seeds + 1):
                    folder = options.out / f"{distance}_{explosive}_{count}_{seed}"
                    runs.append(run(program, CASE, folder, settings(distance, explosive, count, seed), options.dry))
                rows.append(row(distance, explosive, f"{count:,}".replace(",", " "), [r for r in runs if r]))
        empirical = run(program, EMPIRICAL_CASE, options.out / f"{distance}_conwep", settings(distance), options.dry)
        rows.append(row(distance, "ConWep load, no gas", "-", [empirical] if empirical else []))
    return [r for r in rows if r]


def row(distance, what, count, runs):
    """One row: means and deviations over the seeds; none if nothing was run."""
    if not runs:
        return None
    peaks, impulses, walls, cpus = zip(*runs)
    return [str(distance), what, count, str(len(runs)), spread(peaks, 1), spread(impulses, 0), f"{statistics.mean(walls):.1f}", f"{statistics.mean(cpus):.1f}"]


def write_table(rows):
    """Puts the table between its marks in docs/validation.md (at the end where there are none)."""
    head = ["distance [mm]", "explosive or load", "particles, whole plate", "seeds", "first peak [mm]", "impulse, whole plate [N s]", "wall [s]", "CPU [s]"]
    lines = ["| " + " | ".join(r) + " |" for r in [head, ["---"] * len(head), *rows]]
    table = "\n".join([BEGIN, *lines, END])
    text = PAGE.read_text() if PAGE.exists() else "# Validation\n"
    if BEGIN in text and END in text:
        text = text[:text.index(BEGIN)] + table + text[text.index(END) + len(END):]
    else:
        text = text.rstrip() + "\n\n" + table + "\n"
    PAGE.write_text(text)
    print(f"{len(rows)} rows in {PAGE.relative_to(ROOT)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "results/validation")
    parser.add_argument("--most", type=int, default=max(WHOLE_COUNTS))
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--dry", action="store_true")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    rows = rows_of(options.program.resolve(), options)
    if rows:
        write_table(rows)
    return 0 if rows else 1


if __name__ == "__main__":
    sys.exit(main())
