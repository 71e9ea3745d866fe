"""How far the errors can be trusted that a run states of itself, and the bands of an ensemble: many seeds of air at rest in a box and in a
long tube, where the pressure is known, and of the plate of examples/01_plate, where the mean of all seeds stands for the truth."""
import csv
import json
import math
import statistics
import subprocess

from page import ROOT, Chart, table, write

PLATE = ROOT / "examples/01_plate/case.toml"
PRESSURE = 101325.0  # Pa, of the air at rest
DENSITY = 1.2  # kg/m3
MEMBERS = 4  # seeds of an ensemble
AIR = """title = "still air"
end_time = "{end} ms"
[gas]
box = [[0, {length}], [0, {width}], [0, {width}]]
edges = {{ x = ["rigid", "rigid"], y = ["rigid", "rigid"], z = ["rigid", "rigid"] }}
particles = {particles}
[[fill]]
gas = "air"
shape = {{ box = [[0, {length}], [0, {width}], [0, {width}]] }}
density = 1.2
pressure = "101325 Pa"
[[gauge]]
name = "west"
face = "x-"
every = "{every} us"
[[gauge]]
name = "east"
face = "x+"
every = "{every} us"
[[gauge]]
name = "ball"
sphere = {{ center = [{middle}, {half}, {half}], radius = {radius} }}
every = "50 us"
"""
BOX = AIR.format(end=1, length=0.2, width=0.1, particles=8000, every=5, middle=0.1, half=0.05, radius=0.03)
TUBE = AIR.format(end=4, length=2.0, width=0.05, particles=16000, every=5, middle=1.0, half=0.025, radius=0.02)
SPANS = [1, 2, 4, 8, 16, 32, 64, 128]  # rows of 5 us
QUIET = ["output.fields_every=1", "output.particles_shown=0", "output.averages=0"]


def ensembles(program, case, out, number, members, settings, dry):
    """Folders of ensembles of one case, each with seeds of its own; what is there is not run again."""
    folders = []
    for k in range(number):
        folder = out / f"{k + 1}"
        summary = folder / "summary.json"
        if not summary.exists() or json.loads(summary.read_text())["status"] != "done":
            if dry:
                continue
            command = [program, "run", case, "--out", folder, "--quiet", "--force", "--set", f"ensemble={members}", "--set", f"gas.seed={1 + k * members}"]
            for setting in [*QUIET, *settings]:
                command += ["--set", setting]
            print(f"{out.name} {k + 1} of {number}", flush=True)
            subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)
        folders.append(folder)
    return folders


def members_of(folders):
    return [member for folder in folders for member in sorted(folder.glob("seed_*"))]


class History:
    """Columns of a history.csv, without their empty cells."""

    def __init__(self, folder):
        with open(folder / "history.csv", newline="") as file:
            rows = list(csv.reader(file))
        self.columns = {name.split(" [")[0]: k for k, name in enumerate(rows[0])}
        self.rows = rows[1:]

    def column(self, name):
        """Its times and values."""
        k = self.columns[name]
        pairs = [(float(row[0]), float(row[k])) for row in self.rows if row[k] != ""]
        return [t for t, _ in pairs], [v for _, v in pairs]


def share_text(held, of, claimed=0.95):
    """"0.944 (0.022)": a share and the standard deviation it would have if the claim were true."""
    return f"{held / of:.3f} ({math.sqrt(claimed * (1 - claimed) / of):.3f})"


def impulse_windows(histories, span, begin):
    """(error of the impulse of a window, its stated variance) for windows of `span` rows on both end walls, from the time `begin` on."""
    found = []
    for history in histories:
        for wall in ("west", "east"):
            times, impulses = history.column(wall + ".impulse")
            errors = history.column(wall + ".impulse_error")[1]
            first = next(k for k, t in enumerate(times) if t >= begin)
            for a in range(first, len(times) - span, span):
                b = a + span
                found.append((impulses[b] - impulses[a] - PRESSURE * (times[b] - times[a]), errors[b]**2 - errors[a]**2, times[b] - times[a]))
    return found


def variance_ratio(windows):
    """Measured over stated variance of the windows' impulses, and the standard error of that ratio."""
    ratio = sum(error**2 for error, _, _ in windows) / sum(stated for _, stated, _ in windows)
    return ratio, ratio * math.sqrt(2 / len(windows))


def window_rows(histories, begin, spans):
    rows = []
    for span in spans:
        windows = impulse_windows(histories, span, begin)
        ratio, error = variance_ratio(windows)
        rows.append((1e6 * statistics.mean(w[2] for w in windows), len(windows), ratio, error))
    return rows


def region_rows(histories):
    """Measured over stated variance of what a ball of gas at rest shows, against what is known; of n particles in a closed box, a share of
    which lies in the ball, the number wavers by (1 - share) of Poisson: 0.94 here."""
    truths = {"density": DENSITY, "velocity_x": 0.0, "kinetic_pressure": None, "temperature": None}
    rows = []
    for name, truth in truths.items():
        error_name = "velocity_error_x" if name == "velocity_x" else name + "_error"
        values, stated = [], []
        for history in histories:
            times, column = history.column("ball." + name)
            errors = history.column("ball." + error_name)[1]
            values += [v for t, v in zip(times, column) if t > 3e-4]
            stated += [e for t, e in zip(times, errors) if t > 3e-4]
        middle = statistics.mean(values) if truth is None else truth
        ratio = sum((v - middle)**2 for v in values) / sum(e**2 for e in stated)
        rows.append([name, str(len(values)), f"{ratio:.3f}"])
    for end in (2e-4, 5e-4, 1e-3):
        z = []
        for history in histories:
            times, impulse = history.column("ball.impulse")
            k = next(k for k, t in enumerate(times) if t >= end * 0.999)
            z.append(impulse[k] / history.column("ball.impulse_error")[1][k])
        rows.append([f"impulse over {1e6 * end:.0f} us", str(len(z)), f"{statistics.mean(x * x for x in z):.3f}"])
    return rows


def band_coverage(folders, column, truth):
    """The share of rows, from the second on, whose band holds the truth, and its standard error over the ensembles (rows of one are not
    independent)."""
    shares = []
    for folder in folders:
        history = History(folder)
        times, low = history.column(column + "_low")
        high = history.column(column + "_high")[1]
        held = [low[k] <= truth(times[k]) <= high[k] for k in range(1, len(times))]
        shares.append(sum(held) / len(held))
    return f"{statistics.mean(shares):.3f} ({statistics.stdev(shares) / math.sqrt(len(shares)):.3f})"


def summary_value(summary, path):
    for key in path:
        summary = summary[key]
    return summary


def plate_rows(folders):
    """Of quantities of the plate: how often the ensembles' intervals hold the mean of all seeds, and what single runs say of their errors."""
    paths = [("probes", "center", "displacement_z_m", "min"), ("probes", "center", "displacement_z_m", "time_of_min_s"), ("gauges", "plate", "impulse_pa_s"),
             ("gauges", "plate", "peak_pressure_pa"), ("parts", "plate", "kinetic_energy_j")]
    members = [json.loads((folder / "summary.json").read_text()) for folder in members_of(folders)]
    blocks = [json.loads((folder / "summary.json").read_text())["ensemble"]["quantities"] for folder in folders]
    rows = []
    for path in paths:
        values = [summary_value(member, path) for member in members]
        truth = statistics.mean(values)
        held = sum(summary_value(block, path)["low"] <= truth <= summary_value(block, path)["high"] for block in blocks)
        rows.append([" ".join(path[1:]), f"{truth:.4g}", f"{statistics.stdev(values) / abs(truth):.2%}", share_text(held, len(blocks))])
    z = [(member["gauges"]["plate"]["impulse_pa_s"] - truth_of(members)) / member["gauges"]["plate"]["impulse_error_pa_s"] for member in members]
    return rows, statistics.mean(x * x for x in z), len(z)


def truth_of(members):
    return statistics.mean(member["gauges"]["plate"]["impulse_pa_s"] for member in members)


def make(build, out, options):
    """Runs what is missing and writes tables and figure."""
    program = build / "app/corpuscle"
    for name, text in (("box", BOX), ("tube", TUBE)):
        (out / f"{name}.toml").write_text(text)
    plate = ensembles(program, PLATE, out / "plate", 48, MEMBERS, ["end_time=1.5 ms", "gas.particles=4000"], options.dry)
    box = ensembles(program, out / "box.toml", out / "box", 48, MEMBERS, [], options.dry)
    tube = ensembles(program, out / "tube.toml", out / "tube", 1, 16, [], options.dry)
    if not (plate and box and tube):
        return
    write("noise", report(plate, [History(m) for m in members_of(box)], box, [History(m) for m in members_of(tube)]))


def report(plate, box_runs, box, tube_runs):
    """The text between the marks."""
    tube = window_rows(tube_runs, 3e-4, SPANS)
    late = window_rows(tube_runs, 2e-3, SPANS)
    closed = window_rows(box_runs, 1e-4, SPANS)
    chart = Chart("interval [us]", "variance of the impulse, measured over stated", log_x=True)
    chart.add("tube, 2 m", [r[0] for r in tube], [r[2] for r in tube])
    chart.add("tube, from 2 ms on", [r[0] for r in late], [r[2] for r in late])
    chart.add("closed box, 0.2 m", [r[0] for r in closed], [r[2] for r in closed])
    chart.add("free particles", [5, 700], [1, 1], dashed=True)
    plane = math.sqrt(1.4) * math.sqrt(2 * math.pi) / 4
    chart.add("plane sound", [5, 700], [plane, plane], dashed=True)
    figure = chart.save("noise")
    lines = [[f"{rows[0][0]:.0f}", *(f"{r[2]:.3f} ({r[3]:.3f})" for r in rows)] for rows in zip(tube, late, closed)]
    first = table(["interval [us]", "end walls of a tube of 2 m", "the same, from 2 ms on", "of a closed box of 0.2 m"], lines)
    second = table(["a ball of 30 mm", "samples", "variance, measured over stated"], region_rows(box_runs))
    held = [["air: " + what, f"{truth(1.0):.4g} {unit}", "-", band_coverage(box, column, truth)] for what, column, unit, truth in [
        ("impulse of the wall, all rows", "west.impulse", "x t Pa s", lambda t: PRESSURE * t), ("pressure of the wall, all rows", "west.pressure", "Pa", lambda t: PRESSURE),
        ("density in the ball, all rows", "ball.density", "kg/m3", lambda t: DENSITY)]]
    rows, z, count = plate_rows(plate)
    third = table(["quantity", "truth", "scatter of a run", "share of bands that hold it"], held + [["plate: " + r[0], *r[1:]] for r in rows])
    return (f"{first}\n\n{figure}\n\n{second}\n\n{third}\n\nImpulse on the plate, single runs: measured over stated variance {z:.2f} ({math.sqrt(2 / count) * z:.2f}), {count} seeds.")
