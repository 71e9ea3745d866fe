"""The particle gas in shock tubes and in a point blast against exact gas dynamics (validate_tubes)."""
import math

from page import Chart, records, table, write

NAMES = ["density", "velocity", "pressure"]
PROFILES = [("Sod", "tube_sod", "density"), ("pressure ratio 1e5", "tube_strong", "density"),
            ("Noble-Abel, gamma 1.40, filled 0.6", "tube_noble_abel", "pressure"), ("into vacuum", "tube_vacuum", "density"),
            ("TNT against air", "tube_tnt", "pressure")]


def share(found, exact, sigma):
    """How far a star value is off, in per cent of the exact one, with one sigma."""
    return f"{100 * (found / exact - 1):+.1f} ({100 * sigma / abs(exact):.1f})"


def rest(record):
    """Errors less what of them is noise at most."""
    return [error - noise for error, noise in zip(record["l1"], record["noise"])]


def short(values, digits=3):
    """Numbers of three digits, a slash between them."""
    return " / ".join(f"{value:.{digits}g}" for value in values)


def grouped(states):
    """The records of each tube, coarse to fine; a new tube begins where the spacing falls back."""
    groups = []
    for record in states:
        if not groups or record["tube"] != groups[-1][-1]["tube"] or record["inverse_spacing"] <= groups[-1][-1]["inverse_spacing"]:
            groups.append([])
        groups[-1].append(record)
    return groups


def label(group, seen):
    """A tube's name; the second of a name is the Noble-Abel one."""
    name = group[0]["tube"]
    seen.append(name)
    return name + (", Noble-Abel filled 0.6" if name == "into vacuum" and seen.count(name) == 2 else "")


def star_table(states):
    """Star states at the finest spacing."""
    rows = []
    for group in grouped(states):
        last = group[-1]
        if "left" not in last or abs(last["left_exact"][1]) < 1e-9:
            continue
        cells = [share(last[side][q], last[side + "_exact"][q], last[side + "_sigma"][q])
                 for side, q in [("left", 2), ("right", 2), ("left", 1), ("right", 1), ("left", 0), ("right", 0)]]
        rows.append([last["tube"], f"1/{last['inverse_spacing']:g}", short([last["left_exact"][2]], 4), short([last["left_exact"][1]], 4), *cells])
    return table(["tube", "spacing [m]", "exact p*", "exact u*", "p* left", "p* right", "u* left", "u* right", "density left", "density right"], rows)


def error_table(states):
    """Errors at all spacings and the order over them."""
    rows, seen = [], []
    for group in grouped(states):
        ends = rest(group[0]), rest(group[-1])
        halvings = math.log2(group[-1]["inverse_spacing"] / group[0]["inverse_spacing"])
        orders = [math.log2(a / b) / halvings for a, b in zip(*ends)]
        spacings = ", ".join(f"1/{r['inverse_spacing']:g}" for r in group)
        rows.append([label(group, seen), spacings, *[short([rest(r)[q] for r in group]) for q in range(3)], short(orders, 2)])
    return table(["tube", "spacings [m]", *[f"L1 of {name}" for name in NAMES], "orders"], rows)


def path_table(path):
    """What the error of Sod's tube depends on."""
    words = {"spacing": "spacing alone (kappa 1)", "kappa": "kappa alone (spacing 1/128)", "metres": "both, path 1/64 m"}
    rows = [[words[r["kind"]], f"1/{r['inverse_spacing']:g}", f"{r['kappa']:g}", f"{r['kappa'] / r['inverse_spacing']:.4f}", *[f"{e:.4f}" for e in rest(r)]]
            for r in path]
    return table(["varied", "spacing [m]", "kappa", "mean free path [m]", *NAMES], rows)


CELL_SIDE = 2.9 ** (1 / 3)  # of cells with at most 4 particles, in spacings: 2 to 4 in each, evenly in the logarithm


def stream_table(runs):
    """Errors of a shock alone, and their order in the mean free path with what the cells add to it."""
    rows, before = [], None
    for r in runs:
        path = (r["kappa"] + 16 / (45 * math.pi) * CELL_SIDE ** 2 / r["kappa"]) / r["inverse_spacing"]
        orders = [math.log(a / b) / math.log(before[0] / path) for a, b in zip(before[1], rest(r))] if before else []
        rows.append([f"{r['kappa']:g}", f"{r['kappa'] / r['inverse_spacing']:.5f}", f"{path:.5f}", *[f"{e:.4f}" for e in rest(r)], short(orders, 2) if orders else ""])
        before = path, rest(r)
    return table(["kappa", "mean free path [m]", "with the cells' part [m]", *NAMES, "orders"], rows)


def noise_table(noise):
    """Scatter between seeds."""
    rows = []
    for before, r in zip([None] + noise, noise):
        order = [math.log(a / b) / math.log(r["particles"] / before["particles"]) for a, b in zip(before["scatter"], r["scatter"])] if before else []
        rows.append([f"{r['particles']:,}".replace(",", " "), short(r["scatter"]), short(r["theory"]), short(order, 2)])
    return table(["particles", "scatter of density / velocity / pressure", "theory", "order"], rows)


def smear_table(smear):
    """Errors and CPU over settings."""
    rows = [[r["tube"], r["cell_limit"], r["group_limit"], f"{r['kappa']:g}", f"{r['cfl']:g}", *[f"{e:.3g}" for e in rest(r)], r["steps"], f"{r['cpu_s']:.1f}"]
            for r in smear]
    return table(["tube", "cell limit", "group limit", "kappa", "cfl", *NAMES, "steps", "CPU [s]"], rows)


def blast_table(blasts):
    """The point blast after a second."""
    rows = [[f"{r['particles']:,}".replace(",", " "), r["cell_limit"], f"{r['kappa']:g}", f"{r['cfl']:g}", f"{r['half_rise']:.3f}", f"{r['by_momentum']:.3f}",
             f"{r['peak']:.2f}", f"{r['l1_density']:.3f}", r["steps"], f"{r['cpu_s']:.1f}"] for r in blasts if r["time"] == 1]
    return table(["particles", "cell limit", "kappa", "cfl", "half rise [m]", "front by momentum [m]", "peak density", "L1 of density", "steps", "CPU [s]"], rows)


def front_table(blasts):
    """The front over time, default and sharp settings with a million particles."""
    chosen = [r for r in blasts if r["particles"] == 1_000_000]
    rows = [[r["time"], f"{r['front']:.4f}", f"{r['kappa']:g}", f"{r['half_rise']:.4f}", f"{r['by_momentum']:.4f}", f"{r['peak']:.2f}"] for r in chosen]
    return table(["time [s]", "exact front [m]", "kappa", "half rise [m]", "front by momentum [m]", "peak density (exact 6)"], rows)


def tube_figures(lines):
    """A profile of some tubes."""
    pictures, drawn = [], set()
    for tube, name, what in PROFILES:
        for r in lines:
            if r["kind"] == "profile" and r["tube"] == tube and tube not in drawn:
                drawn.add(tube)
                units = {"density": "density", "pressure": "pressure"}[what]
                chart = Chart("x [m]", f"{units}: {tube}", log_y=tube.startswith("TNT"))
                chart.add("exact", r["x"], r["exact_" + what])
                chart.add(f"particles, spacing 1/{r['inverse_spacing']:g}", r["x"], r[what], points=True)
                pictures.append(chart.save(name))
    return pictures


def blast_figure(lines):
    """Density over radius of the point blast."""
    chart = Chart("radius [m]", "density [kg/m3]")
    for r in lines:
        if r["kind"] != "blast profile":
            continue
        if not chart.curves:
            chart.add("exact", r["r"], r["exact_density"])
        chart.add(f"{r['particles']:g} particles, kappa {r['kappa']:g}", r["r"], r["density"], points=True)
    return chart.save("point_blast")


def make(build, out, options):
    """Makes the tables and figures."""
    program = build / "tests/validate_tubes"
    lines = {what: records([program, what], out / f"{what}.jsonl", options.dry) for what in ["states", "path", "stream", "noise", "smear", "blast"]}
    if not all(lines.values()):
        return
    states = [r for r in lines["states"] if r["kind"] == "states"]
    blasts = [r for r in lines["blast"] if r["kind"] == "blast"]
    tubes = [star_table(states), error_table(states), *tube_figures(lines["states"])]
    write("tubes", "\n\n".join(["Star states at the finest spacing: measured over exact, less one, in per cent (one sigma).", tubes[0],
                                "L1 errors less their noise at three spacings, with the order between the first and the last.", *tubes[1:]]))
    write("tube orders", "\n\n".join([path_table(lines["path"]), stream_table(lines["stream"]), noise_table(lines["noise"])]))
    write("smear", smear_table(lines["smear"]))
    write("point blast", "\n\n".join([front_table(blasts), blast_table(blasts), blast_figure(lines["blast"])]))
