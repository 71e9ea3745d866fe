"""Hard spheres: their pressure in a closed box against Carnahan and Starling, and the plate of examples/01_plate at 700 mm with
them against the default rule of collision: three particle counts, three seeds, and what packing, step and mean free path do."""
import json
import statistics

from page import records, spread, table, write
from plate import CASE, run, settings

WHOLE_COUNTS = [16_000, 80_000, 200_000]
VARIED = 80_000
# what stands in the table, and the further --set of each row
RULES = [("displaced", []), ("hard_spheres", ['gas.collision="hard_spheres"'])]
VARIATIONS = [
    ("hard_spheres, packing of air 0.0025", ['gas.collision="hard_spheres"', "gas.packing=0.0025"]),
    ("hard_spheres, packing of air 0.04", ['gas.collision="hard_spheres"', "gas.packing=0.04"]),
    ("hard_spheres, cfl 0.1", ['gas.collision="hard_spheres"', "gas.cfl=0.1"]),
    ("displaced, mean_free_path 3", ["gas.mean_free_path=3"]),
    ("displaced, mean_free_path 10", ["gas.mean_free_path=10"]),
    ("displaced, mean_free_path 100", ["gas.mean_free_path=100"]),
]


def pressure_table(found):
    """Pressure of the closed box over that of the same gas without radius."""
    head = ["packing", "gamma", "cfl", "expected", "walls", "bounces", "bounces/expected", "translational share", "bounces a sphere and step"]
    rows = []
    for r in found:
        rows.append([f"{r['packing']:g}", f"{r['gamma']:.3g}", f"{r['cfl']:g}", f"{r['law']:.4f}", f"{r['wall']:.4f} ({r['wall_sigma']:.4f})",
                     f"{r['bounces']:.4f} ({r['bounces_sigma']:.4f})", f"{r['bounces'] / r['law']:.4f}", f"{r['translational']:.4f}", f"{r['met_a_step']:.2f}"])
    return table(head, rows)


def plate_row(program, out, name, count, further, options):
    """One row of the plate's table: means and deviations over the seeds."""
    runs, steps = [], []
    for seed in range(1, options.seeds + 1):
        folder = out / f"{''.join(c if c.isalnum() else '_' for c in name)}_{count}_{seed}"
        done = run(program, CASE, folder, settings(700, "tnt_paper", count, seed) + further, options.dry)
        if done:
            summary = json.loads((folder / "summary.json").read_text())
            runs.append(done)
            steps.append(summary["steps"])
    if not runs:
        return None
    peaks, impulses, _, cpus = zip(*runs)
    return [name, f"{count:,}".replace(",", " "), str(len(runs)), spread(peaks, 1), spread(impulses, 0), f"{statistics.mean(steps):.0f}", f"{statistics.mean(cpus):.1f}"]


def make(build, out, options):
    """Makes both tables."""
    program = build / "app/corpuscle"
    rows = [plate_row(program, out, name, count, further, options) for count in WHOLE_COUNTS if count <= options.most for name, further in RULES]
    rows += [plate_row(program, out, name, VARIED, further, options) for name, further in VARIATIONS if VARIED <= options.most]
    head = ["collision", "particles, whole plate", "seeds", "first peak [mm]", "impulse, whole plate [N s]", "steps", "CPU [s]"]
    found = records([build / "tests/validate_spheres"], out / "spheres.jsonl", options.dry)
    if found or any(rows):
        write("spheres", pressure_table(found) + "\n\n" + table(head, [r for r in rows if r]))
