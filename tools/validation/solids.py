"""The tables of shells, bricks and tetrahedra: Taylor's bar, plates and a panel under an impulse, the paper's plate under ConWep."""
from page import records, table, write


def taylor_table(found):
    """Final shape of the bar, by element and mesh."""
    head = ["element", "across the radius", "elements", "length [mm]", "foot radius [mm]", "largest plastic strain", "energy error", "hourglass", "CPU [s]"]
    rows = [[r["element"], r["across"], r["elements"], f"{r['length_mm']:.3f}", f"{r['foot_mm']:.3f}", f"{r['plastic_strain']:.2f}",
             f"{r['energy_error']:.0e}", f"{100 * r['hourglass']:.2f} %", f"{r['cpu_s']:.1f}"] for r in found if r["test"] == "taylor"]
    return table(head, rows)


def impulse_table(found):
    """Deflection over thickness of the clamped plate, against the fit of experiments."""
    head = ["speed [m/s]", "phi", "with rate", "without", "twice the size, without", "twice the size, with rate", "0.425 phi + 0.277"]
    rows = [[f"{r['speed']:.0f}", f"{r['phi']:.1f}", f"{r['with_rate']:.2f}", f"{r['without_rate']:.4f}", f"{r['twice_the_size']:.4f}",
             f"{r['twice_the_size_with_rate']:.2f}", f"{r['nurick_martin']:.2f}"] for r in found if r["test"] == "impulse"]
    return table(head, rows)


def panel_table(found):
    """Deflection of the panel's middle."""
    rows = [[r["mesh"], r["shells"], f"{r['largest_in']:.3f}", f"{r['late_in']:.3f}"] for r in found if r["test"] == "panel"]
    return table(["mesh", "shells", "largest [in]", "0.6 to 1 ms [in]"], rows)


def plate_table(found):
    """First peak of the paper's plate by model."""
    head = ["model", "elements", "first peak [mm]", "at [ms]", "largest plastic strain", "hourglass share of strain energy", "CPU [s]"]
    rows = [[r["model"], r["elements"], f"{r['peak_mm']:.2f}", f"{r['time_ms']:.3f}", f"{r['plastic_strain']:.4f}",
             f"{100 * r['hourglass_share']:.2f} %", f"{r['cpu_s']:.1f}"] for r in found if r["test"] == "plate"]
    return table(head, rows)


def make(build, out, options):
    """Makes the four tables."""
    found = records([build / "tests/validate_solids"], out / "solids.jsonl", options.dry)
    if found:
        parts = [("Taylor's bar", taylor_table), ("Clamped plate of mild steel under an impulse", impulse_table),
                 ("120-degree panel under an impulse", panel_table), ("The paper's plate under ConWep, 700 mm", plate_table)]
        write("solids", "\n\n".join(f"{title}:\n\n{make_table(found)}" for title, make_table in parts))
