"""The runs behind the plate's table: the plate of examples/01_plate at three distances, two sets of TNT, four particle counts
and three seeds, and the empirical load beside them. The counts are those of a whole plate; the case is a quarter of it and
carries a quarter of them."""
import csv
import json
import statistics
import subprocess

from page import ROOT, spread, table, write

CASE = ROOT / "examples/01_plate/case.toml"
EMPIRICAL_CASE = ROOT / "examples/01_plate/conwep.toml"

DISTANCES = [400, 700, 1000]  # mm, from the charge's centre to the plate
EXPLOSIVES = ["tnt", "tnt_paper"]
WHOLE_COUNTS = [16_000, 80_000, 200_000, 800_000]
QUARTERS = 4
TIME = "time [s]"
COLUMN = "center.displacement_z [m]"


def first_peak(deflections):
    """The first peak of a deflection curve: its highest value before it first falls back by half; wiggles on the way do not count."""
    highest = 0.0
    for value in deflections:
        highest = max(highest, value)
        if highest > 0.3 * max(deflections) and value < 0.5 * highest:
            break
    return highest


def curve(folder):
    """Times [ms] and deflections of the centre [mm] of a run."""
    with open(folder / "history.csv", newline="") as file:
        rows = [row for row in csv.DictReader(file, skipinitialspace=True) if row[COLUMN] not in ("", "nan")]
    return [1000 * float(row[TIME]) for row in rows], [-1000 * float(row[COLUMN]) for row in rows]


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
    impulse = QUARTERS * -summary["parts"]["plate"]["impulse_n_s"][2]
    return first_peak(curve(folder)[1]), impulse, summary["wall_s"], summary["cpu_s"]


def rows_of(program, out, options):
    """The rows of the table, each a list of texts."""
    rows = []
    for distance in DISTANCES:
        for explosive in EXPLOSIVES:
            for count in (c for c in WHOLE_COUNTS if c <= options.most):
                runs = []
                for seed in range(1, options.seeds + 1):
                    folder = out / f"{distance}_{explosive}_{count}_{seed}"
                    runs.append(run(program, CASE, folder, settings(distance, explosive, count, seed), options.dry))
                rows.append(row(distance, explosive, f"{count:,}".replace(",", " "), [r for r in runs if r]))
        empirical = run(program, EMPIRICAL_CASE, out / f"{distance}_conwep", settings(distance), options.dry)
        rows.append(row(distance, "ConWep load, no gas", "-", [empirical] if empirical else []))
    return [r for r in rows if r]


def row(distance, what, count, runs):
    """One row: means and deviations over the seeds; none if nothing was run."""
    if not runs:
        return None
    peaks, impulses, walls, cpus = zip(*runs)
    return [str(distance), what, count, str(len(runs)), spread(peaks, 1), spread(impulses, 0), f"{statistics.mean(walls):.1f}", f"{statistics.mean(cpus):.1f}"]


def make(build, out, options):
    """Makes the table."""
    rows = rows_of(build / "app/corpuscle", out, options)
    head = ["distance [mm]", "explosive or load", "particles, whole plate", "seeds", "first peak [mm]", "impulse, whole plate [N s]", "wall [s]", "CPU [s]"]
    if rows:
        write("plate", table(head, rows))
