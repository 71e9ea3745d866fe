"""The figures and tables of docs/paper.md: the plate of Teng and Wang by particles and on grids, at their counts and finer, what each costs, and the
error of each against its cost. One case file, examples/01_plate/case.toml, a quarter of the plate, is the particles; the same file with [euler] in place of [gas]
is the grid. Counts and impulses are those of the whole plate, four times what is in the model."""
import json
import math
import re
import statistics
import subprocess

from page import ROOT, Chart, spread, table, write
from plate import curve, first_peak

PAGE = ROOT / "docs/paper.md"
CASE = ROOT / "examples/01_plate/case.toml"
SIDES = (1.2, 1.2, 1.6)  # of the case's box [m]
QUARTERS = 4
END = "2 ms"  # past the first peak at every distance
EXPERIMENT = 47.0  # mm, 700 mm (Neuberger, Peles and Rittel 2009)
PRINTED = {("particles", 16_000): 143, ("particles", 80_000): 1299, ("particles", 200_000): 2816, ("particles", 800_000): 21807,
           ("grid", 120_000): 619, ("grid", 1_100_000): 53800}  # CPU seconds, the paper's Table 4
SHARP = ["gas.mean_free_path=0.25", "gas.cell_limit=8", "gas.partners=4", "gas.cfl=0.8"]
FROM_RADIAL = ['gas.start="spherical"']


def cells_of(count):
    """Cells along x, y and z, as near cubes as whole numbers allow, about `count` in all; the plate, an eighth above the lower edge, lies on
    their faces."""
    size = math.cbrt(math.prod(SIDES) / count)
    high = 8 * round(SIDES[2] / size / 8)
    wide = round(math.sqrt(count / high))
    return [wide, wide, high]


def on_grid(text, count):
    """The case with [euler] in place of [gas]: same box, edges and fill."""
    gas = re.search(r"^\[gas\]\n(.*?)(?=^\[)", text, re.MULTILINE | re.DOTALL)
    kept = [line for line in gas[1].splitlines() if re.match(r"(box|edges|fill) *=", line)]
    grid = "\n".join(["[euler]", *kept, f"cells = {cells_of(count)}", "", ""])
    return text[:gas.start()] + grid + text[gas.end():]


def prepared(method, count, folder):
    """The case file of a run: the example itself, or it with a grid, written beside the run."""
    if method == "particles":
        return CASE
    folder.parent.mkdir(parents=True, exist_ok=True)
    case = folder.with_suffix(".toml")
    case.write_text(on_grid(CASE.read_text(), count))
    return case


class Run:
    """One run, kept in its folder and not made twice: the centre's deflection over time, its first peak, the impulse on the plate, the cost."""

    def __init__(self, folder):
        summary = json.loads((folder / "summary.json").read_text())
        self.times, self.deflections = curve(folder)  # ms, mm
        self.peak = first_peak(self.deflections)  # mm
        self.impulse = -QUARTERS * summary["parts"]["plate"]["impulse_n_s"][2]  # on the whole plate [N s]
        self.cpu, self.memory = summary["cpu_s"], summary["peak_memory_bytes"]
        self.counts, self.steps, self.ledger = summary["counts"], summary["steps"], summary["ledger"]


class Runs:
    """Makes runs of the plate, and keeps them."""

    def __init__(self, program, out, options):
        self.program, self.out, self.options = program, out, options

    def __call__(self, method, count, distance=700, more=(), name=""):
        """The run, or None where it is not there and is not to be made. count: particles or cells in the quarter."""
        folder = self.out / f"{distance}_{method}_{count}{name}"
        done = folder / "summary.json"
        if not done.exists() or json.loads(done.read_text())["status"] != "done":
            if self.options.dry or count > self.options.most:
                return None
            self.make(folder, prepared(method, count, folder), self.settings(method, count, distance, more))
        return Run(folder)

    def settings(self, method, count, distance, more):
        center = f'[0, 0, "{distance} mm"]'
        chosen = [f'end_time="{END}"', "output.fields_every=1", f"charge.0.center={center}", f"charge.0.detonation.0.point={center}", *more]
        return [*chosen, f"gas.particles={count}"] if method == "particles" else chosen

    def make(self, folder, case, settings):
        command = [str(self.program), "run", str(case), "--out", str(folder), "--quiet", "--force", "--threads", "1"]
        for setting in settings:
            command += ["--set", setting]
        print(folder.name, flush=True)
        subprocess.run(command, check=True)


def spaced(count):
    return f"{count:,}".replace(",", " ")


def first_seed(method):
    """Settings and the end of the name of a run with the first seed; a grid has no seeds."""
    return (["gas.seed=1"] if method == "particles" else []), "_1"


def curves_figure(runs, distance, name):
    """Centre deflection over time at one distance (the paper's Figures 4 and 5)."""
    chart = Chart("time [ms]", "deflection of the centre [mm]", legend_beside=True)
    for method, count in PRINTED:
        if run := runs(method, count // QUARTERS, distance, *first_seed(method)):
            chart.add(f"{spaced(count)} {'particles' if method == 'particles' else 'cells'}", run.times, run.deflections, dashed=method == "grid")
    if distance == 700:
        chart.add("experiment, peak", [0, float(END.split()[0])], [EXPERIMENT, EXPERIMENT], dashed=True)
    return chart.save(name) if chart.curves else ""


def printed_table(runs):
    """Peaks at the paper's three distances and CPU seconds beside the paper's (Table 4)."""
    rows = []
    for (method, count), seconds in PRINTED.items():
        made = {distance: runs(method, count // QUARTERS, distance, *first_seed(method)) for distance in (400, 700, 1000)}
        if not all(made.values()):
            continue
        run = made[700]
        rows.append([f"{spaced(count)} {'particles' if method == 'particles' else 'cells'}", *(f"{made[d].peak:.1f}" for d in made), *(f"{made[d].impulse:.0f}" for d in made),
                     f"{run.cpu:.1f}", f"{QUARTERS * run.cpu:.0f}", seconds, f"{seconds / (QUARTERS * run.cpu):.0f}"])
    head = ["model", "peak at 400 mm [mm]", "700 mm", "1000 mm", "impulse at 400 mm [N s]", "700 mm", "1000 mm", "CPU, 700 mm, the quarter [s]", "times four", "CPU in the paper [s]", "ratio"]
    return table(head, rows) if rows else ""


# The families of the study of convergence and cost: word, method, counts of the quarter, further settings, name of the folder's end.
FAMILIES = [
    ("particles", "particles", [4_000, 20_000, 50_000, 200_000, 800_000], [], ""),
    ("particles, the paper's gas (b 0.3)", "particles", [4_000, 20_000, 50_000, 200_000, 800_000], ['charge.0.explosive="tnt_paper"'], "_paper"),
    ("particles, short path", "particles", [4_000, 20_000, 50_000, 200_000, 800_000], SHARP, "_sharp"),
    ("particles, short path, from 1-D", "particles", [4_000, 20_000, 50_000, 200_000, 800_000], SHARP + FROM_RADIAL, "_sharp_radial"),
    ("grid", "grid", [30_000, 120_000, 275_000, 1_100_000, 4_000_000], [], ""),
    ("grid, from 1-D", "grid", [30_000, 120_000, 275_000, 1_100_000], ['euler.start="spherical"'], "_radial"),
]


def family(runs, method, counts, more, name):
    """Runs by count: of particles several seeds each, of a grid one; fewer seeds where a run is long."""
    seeds = runs.options.seeds if method == "particles" else 1
    made = []
    for count in counts:
        each = [runs(method, count, 700, [*more, f"gas.seed={seed}"] if method == "particles" else more, f"{name}_{seed}") for seed in range(1, (seeds if count <= 200_000 else 1) + 1)]
        made.append((count, [run for run in each if run]))
    return [(count, each) for count, each in made if each]


def mean(each, value):
    return statistics.mean(value(run) for run in each)


def peak(run):
    return run.peak


def impulse(run):
    """On the whole plate [N s]."""
    return run.impulse


def convergence(runs):
    """Where each family converges to, and what it costs."""
    rows, families = [], []
    for word, method, counts, more, name in FAMILIES:
        made = family(runs, method, counts, more, name)
        families.append((word, method, made))
        rows += [[word, spaced(count), spaced(QUARTERS * count), len(each), spread([peak(run) for run in each], 1), spread([impulse(run) for run in each], 0),
                  f"{mean(each, lambda run: run.steps):.0f}", f"{mean(each, lambda run: run.cpu):.1f}", f"{mean(each, lambda run: run.memory) / 2**20:.0f}"] for count, each in made]
    head = ["gas", "in the quarter", "whole plate", "seeds", "first peak [mm]", "impulse, whole plate [N s]", "steps", "CPU [s]", "memory [MiB]"]
    return (table(head, rows) if rows else ""), families


RINGS = [20, 10, 5, 2.5]  # mm
RING_GAUGES = 20  # along the radius of 500 mm, each in the middle of a ring of 25 mm
RING_CASE = """title = "15 kg TNT over a rigid floor, rings"
end_time = "1.6 ms"
[[charge]]
explosive = "tnt"
shape = "sphere"
mass = "15 kg"
center = [0, 0, "700 mm"]
detonation = [{{ point = [0, 0, "700 mm"], time = 0 }}]
[euler]
symmetry = "axisymmetric"
box = [[0, "1500 mm"], [0, "2000 mm"]]
edges = {{ x = ["rigid", "open"], z = ["rigid", "open"] }}
cell_size = "{size} mm"
fill = "air"
start = "spherical"
[output]
fields_every = 1
"""


def ring_gauge(row, number, size):
    """In the middle of the first (0) or the second (1) cell above the floor."""
    radius = 500 / RING_GAUGES * (number + 0.5)
    return f'[[gauge]]\nname = "{row}_{number}"\nsphere = {{ center = ["{radius} mm", 0, "{size * (row + 0.5)} mm"], radius = "0.5 mm" }}\nevery = "2 us"\n'


def floor_impulse(summary):
    """On the floor's circle of 500 mm [N s]: gas at a rigid wall is not accelerated across it, so the impulse falls off with the square of the
    height, and the first two cells say what it is at none."""
    width, total = 0.5 / RING_GAUGES, 0
    for n in range(RING_GAUGES):
        first, second = (summary["gauges"][f"{row}_{n}"]["impulse_pa_s"] for row in (0, 1))
        total += 2 * math.pi * width * (n + 0.5) * width * (9 * first - second) / 8
    return total


def ring_run(runs, size):
    """Impulse on the floor's circle of 500 mm [N s] and the CPU seconds of a run in rings, or nothing."""
    folder = runs.out / f"rings_radial_{size}"
    if not (folder / "summary.json").exists():
        if runs.options.dry or size < 5 and runs.options.most < 10**9:
            return None
        case = folder.with_suffix(".toml")
        folder.parent.mkdir(parents=True, exist_ok=True)
        case.write_text(RING_CASE.format(size=size) + "".join(ring_gauge(row, n, size) for row in (0, 1) for n in range(RING_GAUGES)))
        runs.make(folder, case, [])
    summary = json.loads((folder / "summary.json").read_text())
    return floor_impulse(summary), summary["cpu_s"]


def wall_table(runs):
    """The impulse on a plate that cannot move: rings of cells on a rigid floor, and the case's plate held rigid, by particles and cells."""
    rows = []
    for size in RINGS:
        if made := ring_run(runs, size):
            rows.append([f"rings of {size:g} mm, from 1-D", "", f"{made[0]:.0f}", f"{made[1]:.1f}"])
    rigid = ['part.0.element="rigid"', 'part.0.fix.0.where="all"', 'end_time="1.6 ms"']
    for word, method, counts, more, name in FAMILIES:
        for count, each in family(runs, method, [c for c in counts if c <= 275_000], [*more, *rigid], name + "_rigid"):
            rows.append([word, spaced(count), spread([impulse(run) for run in each], 0), f"{mean(each, lambda run: run.cpu):.1f}"])
    return table(["gas", "in the quarter", "impulse, whole plate [N s]", "CPU [s]"], rows) if rows else ""


def against_cost(families, value, word, name):
    """Error (root of the mean square over the seeds) against the finest grid over CPU seconds of a run."""
    grids = [made for _, method, made in families if method == "grid" and made]
    if not grids:
        return ""
    finest = max(grids[0], key=lambda one: one[0])[1]
    exact = mean(finest, value)
    chart = Chart("CPU time, the quarter [s]", f"error of {word} against the finest grid [%]", log_x=True, log_y=True, legend_beside=True)
    for label, method, made in families:
        points = [(mean(each, lambda run: run.cpu), 100 * math.sqrt(mean(each, lambda run: (value(run) / exact - 1) ** 2))) for _, each in made if each is not finest]
        if points:
            chart.add(label, *zip(*points), dashed=method == "grid")
    return chart.save(name)


def make(build, out, options):
    """Makes the page's tables and figures."""
    runs = Runs(build / "app/corpuscle", out, options)
    figures = [curves_figure(runs, 700, "paper_700"), curves_figure(runs, 400, "paper_400"), curves_figure(runs, 1000, "paper_1000")]
    write("paper curves", "\n\n".join(f for f in figures if f), PAGE)
    write("paper cost", printed_table(runs), PAGE)
    text, families = convergence(runs)
    write("paper convergence", text, PAGE)
    write("paper wall", wall_table(runs), PAGE)
    errors = [against_cost(families, impulse, "the impulse", "paper_error_impulse"), against_cost(families, peak, "the first peak", "paper_error_peak")]
    write("paper error", "\n\n".join(f for f in errors if f), PAGE)
