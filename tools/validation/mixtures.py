"""Mixtures: Dalton's pressure and the split of energy for every pair of laws, and what particles of unlike mass do."""
from page import Chart, records, table, write


def pairs(rows):
    """Pressure, split and drift of each pair of laws and mass ratio."""
    lines = [[f"{row['first']}, {row['second']}", f"{row['ratio']:g}", row["few"], f"{row['pressure']:.4f} +- {row['pressure_error']:.4f}",
              f"{row['split']:.4f} +- {row['split_error']:.4f}", f"{row['drift']:+.4f} +- {row['drift_error']:.4f}", f"{row['collisions']:.0f}",
              f"{row['energy']:.0e}"] for row in rows]
    head = ["laws", "mass ratio, second to first", "particles of the rarer, of 20 000", "wall pressure over Dalton's", "energy split over equipartition's",
            "drift, second half less first", "collisions a particle", "energy error"]
    return table(head, lines)


def ratios(rows):
    """What a ratio of particle masses does."""
    even = next(row for row in rows if row["ratio"] == 1)
    lines = [[f"{row['ratio']:g}", f"{row['collisions']:.1f}"]
             + [f"{row[key]:.4f} ({row[key] / even[key]:.2f})" for key in ("density", "velocity", "pressure", "mixing")]
             + [f"{row['contact']:+.4f}"] for row in rows]
    chart = Chart("particle mass of the dense half over the thin half's", "over that at equal masses", log_x=True)
    for key in ("density", "velocity", "pressure", "mixing"):
        chart.add(key if key == "mixing" else f"L1 error of {key}", [row["ratio"] for row in rows], [row[key] / even[key] for row in rows])
    head = ["mass ratio", "collisions to 1/e of a temperature difference", "Sod's tube: L1 of density (over that at 1)", "velocity", "pressure",
            "depth of mixing [m]", "contact, out of place [m]"]
    return table(head, lines) + "\n\n" + chart.save("mass_ratio")


def make(build, out, options):
    """Makes both tables."""
    texts = []
    for part, show in {"ratios": ratios, "pairs": pairs}.items():
        rows = records([build / "tests/validate_mixtures", part], out / f"{part}.jsonl", options.dry)
        if rows:
            texts.append(show(rows))
    if texts:
        write("mixtures", "\n\n".join(texts))
