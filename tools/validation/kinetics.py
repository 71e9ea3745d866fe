"""Kinetics of the particle gas: shock structure, rotational relaxation, viscosity, escape into a vacuum, slow expansion, closed vessels."""
from page import Chart, records, table, write

PARTS = ["relaxation", "shock", "escape", "expansion", "viscosity", "vessel"]
SHOCKS = {2: 0.255, 8: 0.435}


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def of_mean(rows, key):
    """Standard error of the mean of rows that each bring their own."""
    return sum(row[key] ** 2 for row in rows) ** 0.5 / len(rows)


def shock(rows):
    """Thickness table and profiles."""
    lines, chart = [], Chart("distance from the middle [upstream mean free paths]", "density, 0 before, 1 behind")
    for mach, reference in SHOCKS.items():
        own = [row for row in rows if row["mach"] == mach]
        if not own:
            continue
        ratio = mean(row["ratio"] for row in own)
        lines.append([mach, len(own), reference, f"{ratio:.3f} +- {of_mean(own, 'error'):.3f}", f"{100 * (ratio / reference - 1):+.1f} %",
                      f"{mean(row['speed'] for row in own):.3f}", f"{mean(row['behind'] / row['jump'] for row in own):.3f}"])
        places = [place for place, _ in own[0]["profile"]]
        chart.add(f"M {mach}", places, [mean(row["profile"][i][1] for row in own) for i in range(len(places))])
    head = ["Mach number", "seeds", "lambda/Delta, reference", "measured", "difference", "speed over Rankine-Hugoniot", "density behind over it"]
    return "Normal shock, hard spheres of fixed size, gamma 5/3:\n\n" + table(head, lines) + "\n\n" + chart.save("normal_shock")


def relaxation(rows):
    """Rate over the relaxation number."""
    lines = [[f"{row['relaxation']:g}", f"{row['theory']:.4f}", f"{row['rate']:.4f} +- {row['error']:.4f}", f"{row['rate'] / row['theory']:.3f}",
              f"{1 / row['rate']:.2f}"] for row in rows]
    end = next(row for row in rows if row["translational"] > 0)
    return ("Rotational relaxation, gamma 1.4, from 10000 K and 100 K:\n\n"
            + table(["relaxation number", "rate a collision, theory", "measured", "ratio", "collision number Z_rot"], lines)
            + f"\n\nAt the end {end['translational']:.1f} K and {end['internal']:.1f} K (sigma {end['kelvin']:.1f} K) for 6040 K.")


def viscosity(rows):
    """Viscosity over the mean free path, theory beside it."""
    lines, chart = [], Chart("mean free path kappa [local spacings]", "viscosity [sigma spacings]", log_x=True)
    for limit in sorted({row["limit"] for row in rows}, reverse=True):
        own = [row for row in rows if row["limit"] == limit]
        chart.add(f"cells of up to {limit}", [row["kappa"] for row in own], [row["viscosity"] for row in own], points=True)
        chart.add(f"theory, {limit}", [row["kappa"] for row in own if row["kappa"] >= 0.25],
                  [row["spheres"] + row["cells"] for row in own if row["kappa"] >= 0.25], dashed=True)
        for row in own:
            theory = row["spheres"] + row["cells"]
            lines.append([limit, f"{row['kappa']:g}", f"{row['path']:.3f}", f"{row['distance']:.3f}", f"{row['spheres']:.3f}", f"{row['cells']:.3f}",
                          f"{row['viscosity']:.3f} +- {row['error']:.3f}", f"{row['viscosity'] / theory:.3f}"])
    head = ["particles in a cell, most", "kappa", "path counted", "partners' distance squared", "theory: spheres", "cells", "measured", "over theory"]
    return "Viscosity over sigma and the spacing:\n\n" + table(head, lines) + "\n\n" + chart.save("viscosity")


def escape(rows):
    """Escape speed over the co-volume and the gas's length."""
    shares = sorted({row["filled"] for row in rows})
    lines = []
    for length in sorted({row["length"] for row in rows}):
        own = {row["filled"]: row for row in rows if row["length"] == length}
        lines.append([f"{length:g}"] + [f"{own[s]['edge']:.3f} +- {own[s]['error']:.3f}; {own[s]['invariant']:.4f}" for s in shares])
    head = ["length of the gas [spacings]"] + [f"b phi {share:g}" for share in shares]
    return "Escape speed over 2 c0 (1 - phi)/(gamma - 1), from velocities alone; from velocities and heat:\n\n" + table(head, lines)


def expansion(rows):
    """Energy left over that of the isentrope, taken to walls at rest."""
    names = list(dict.fromkeys(row["law"] for row in rows))
    goals = [1.5, 2, 3, 5, 10, 20, 50, 100]
    lines = []
    for name in names:
        own = [row for row in rows if row["law"] == name]
        lines.append([name] + [f"{2 * row['slower'] - row['slow']:.4f}" for row in own] + [f"{own[-1][key]:.4f}" for key in ("slower", "slow", "fast")])
    head = ["law"] + [f"V/V0 {goal:g}" for goal in goals] + ["100, walls at M 0.0125", "100, M 0.025", "100, M 0.05"]
    return "Slow expansion of a closed box, energy over the isentrope's, walls' speed taken to nothing:\n\n" + table(head, lines)


def vessel(rows):
    """Pressure after a charge burnt in a closed vessel."""
    lines = [[row["law"], f"{row['volume']:g}", f"{row['air']:g}" if row["air"] else "-", f"{row['expected_mpa']:.4g}",
              f"{row['pressure']:.4f} +- {row['error']:.4f}", f"{row['share']:.3f}"] for row in rows]
    head = ["law", "vessel over charge volume", "air [kg/m3]", "law's pressure [MPa]", "measured over it", "products' share of energy over equipartition's"]
    return "A charge burnt in a closed vessel:\n\n" + table(head, lines)


def make(build, out, options):
    """Makes the tables and figures."""
    texts = []
    for part in PARTS:
        rows = records([build / "tests/validate_kinetics", part], out / f"{part}.jsonl", options.dry)
        if rows:
            texts.append(globals()[part](rows))
    if texts:
        write("kinetics", "\n\n".join(texts))
