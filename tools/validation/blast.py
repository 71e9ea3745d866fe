"""TNT in free air: one dimension, particles and the curves of Kingery and Bulmash at eight scaled distances; and where the shock of
15 kg stands after 0.2 ms, by which the particles' errors are told apart. The program is validate_blast (tests/validation/input)."""
import statistics

from page import Chart, records, spread, table, write

RADIAL_CELLS = [25, 50, 100]  # in a radius of the charge
FARTHEST = 3
GROUPS = [(0.2, 0.5), (0.7, 1), (1.5, 3)]  # scaled distances of one cube of air each
LATE_START = "2e-5"  # s, after which the particles begin in the runs laid out from one dimension
USUAL, SHARP = (1, 16, 0.4), (0.25, 8, 0.8)  # mean free path, most in a cell, cfl
SETS = [  # particles of an octant, start [s], settings, what the column is called
    (30_000, "0", USUAL, "30 000 particles"), (240_000, "0", USUAL, "240 000 particles"),
    (1_000_000, "0", SHARP, "1 000 000, short path"), (1_000_000, LATE_START, SHARP, "1 000 000, short path, from one dimension at 0.02 ms")]
FRONT_COUNTS = [30_000, 240_000]


def seeds_of(count, options):
    """Seeds of a row: all, but one where a run is long."""
    return range(1, 2 if count > 100_000 else options.seeds + 1)


def spaced(count):
    return f"{count:,}".replace(",", " ")


def radial_runs(program, out, options):
    """{distance: [measures for each number of cells]}."""
    found = {}
    for cells in RADIAL_CELLS:
        for row in records([program, "radial", cells, FARTHEST], out / f"radial_{cells}.jsonl", options.dry):
            found.setdefault(row["distance"], []).append(row)
    return found


def seen_runs(program, out, options):
    """{distance: measures}: the flow in one dimension, read as the particles are."""
    return {row["distance"]: row for row in records([program, "seen", RADIAL_CELLS[-1], FARTHEST], out / "seen.jsonl", options.dry)}


def particle_runs(program, out, count, start, settings, options):
    """{distance: [measures for each seed]}."""
    found = {}
    for nearest, farthest in GROUPS:
        for seed in seeds_of(count, options):
            words = [str(word) for word in (count, seed, nearest, farthest, start, *settings)]
            for row in records([program, "particles", *words], out / f"particles_{'_'.join(words)}.jsonl", options.dry):
                found.setdefault(row["distance"], []).append(row)
    return found


def limit(runs, key):
    """The value at cells of no width: Aitken's rule for three runs, each of half the width; the last one where they do not close in."""
    if len(runs) < 3:
        return runs[-1][key]
    a, b, c = (run[key] for run in runs[-3:])
    ratio = (c - b) / (b - a) if b != a else 0
    return c + (c - b) * ratio / (1 - ratio) if 0 < ratio < 0.9 else c


def radial_table(radial, key, digits):
    """Each number of cells, the limit, the curves."""
    rows = [[f"{distance:g}", *[f"{run[key]:.{digits}f}" for run in runs], f"{limit(runs, key):.{digits}f}", f"{runs[0]['kb'][key]:.{digits}f}"]
            for distance, runs in sorted(radial.items())]
    return table(["Z [m/kg^(1/3)]", *[f"{cells} cells" for cells in RADIAL_CELLS[:len(next(iter(radial.values())))]], "limit", "Kingery-Bulmash"], rows)


def measure_table(radial, seen, particles, key, digits):
    """One row a distance: the limit, the same as the particles are read, the particles."""
    rows = []
    for distance, runs in sorted(radial.items()):
        row = [f"{distance:g}", f"{limit(runs, key):.{digits}f}", f"**{seen[distance][key]:.{digits}f}**" if distance in seen else "-"]
        for found in particles.values():
            values = [run[key] for run in found.get(distance, []) if run["peak_kpa"] > 0]
            row.append(spread(values, digits) if values else "-")
        rows.append(row)
    return table(["Z [m/kg^(1/3)]", "limit", "read in shells", *particles], rows)


def figure(radial, particles):
    """Peak over distance."""
    chart = Chart("scaled distance [m/kg^(1/3)]", "peak overpressure [kPa]", log_x=True, log_y=True)
    places = sorted(radial)
    chart.add("radial, limit", places, [limit(radial[z], "peak_kpa") for z in places])
    chart.add("Kingery-Bulmash", places, [radial[z][0]["kb"]["peak_kpa"] for z in places], dashed=True)
    for label, found in particles.items():
        at = [z for z in places if z in found]
        chart.add(label, at, [statistics.mean(run["peak_kpa"] for run in found[z]) for z in at], points=True)
    return chart.save("blast_peak")


def front_rows(program, out, options):
    """Rows of the table of 15 kg at 0.2 ms."""
    rows = []

    def add(label, keys, sets):
        late = [row for rows_of_run in sets for row in rows_of_run if row["time_ms"] == 0.2]
        if late:
            rows.append([label] + [spread([row[key] for row in late], digits) for key, digits in keys])

    keys = [("half_rise", 4), ("face", 4), ("products_momentum", 0), ("air_momentum", 0)]
    for speed, label in (("6930", "one dimension, lit at the centre"), ("0", "one dimension, burnt at once")):
        add(label, keys, [records([program, "front_radial", 100, speed], out / f"front_radial_{speed}.jsonl", options.dry)])
    for start, group in (("0", 64), ("0", 16), ("5e-5", 64), ("1e-4", 64)):
        for count in FRONT_COUNTS if start == "0" else FRONT_COUNTS[:1]:
            sets = [records([program, "front_particles", count, seed, start, group], out / f"front_{count}_{start}_{group}_{seed}.jsonl", options.dry)
                    for seed in seeds_of(count, options) if count <= options.most]
            begin = "lit" if start == "0" else f"laid out from one dimension at {1e3 * float(start):g} ms"
            add(f"{spaced(count)} particles, {begin}, groups of {group}", keys, sets)
    return rows


def make(build, out, options):
    """Makes tables and figure."""
    program = build / "tests/validate_blast"
    radial, seen = radial_runs(program, out, options), seen_runs(program, out, options)
    particles = {}
    for count, start, settings, label in (each for each in SETS if each[0] <= options.most):
        found = particle_runs(program, out, count, start, settings, options)
        if found:
            particles[label] = found
    if not radial:
        return
    head = ["15 kg, 0.2 ms, octant", "half of the rise [m]", "products meet air [m]", "momentum of products [N s]", "of air [N s]"]
    parts = []
    for title, key, digits in (("Peak overpressure [kPa]", "peak_kpa", 0), ("Arrival of half the peak [ms]", "arrival_ms", 4),
                               ("Impulse of the positive phase [Pa s]", "impulse_pa_s", 1)):
        parts += [f"{title}, 1 kg, in one dimension:\n", radial_table(radial, key, digits), "\nand by particles:\n",
                  measure_table(radial, seen, particles, key, digits), ""]
    parts += [figure(radial, particles), "", table(head, front_rows(program, out, options))]
    write("blast", "\n".join(parts))
