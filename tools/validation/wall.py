"""A layer of hot TNT products against a rigid wall, in one dimension and by particles: what of the settings moves the front, the peak and the
impulse, and what it costs."""
from page import records, spread, table, write

SEEDS = 3
EXACT_CELLS = 400
BASE = (100_000, 5, 1, 16, 0.4, 1, "quiet", "awake")
RUNS = [  # particles, layers across the products, mean free path, most in a cell, cfl, partners, start, air
    BASE, (100_000, 5, 1, 16, 0.4, 1, "random", "awake"), (100_000, 5, 1, 16, 0.4, 1, "quiet", "sleep"),
    (100_000, 5, 1, 16, 0.8, 1, "quiet", "awake"), (100_000, 5, 0.5, 16, 0.8, 1, "quiet", "awake"), (100_000, 5, 0.25, 16, 0.8, 1, "quiet", "awake"),
    (100_000, 5, 0.25, 8, 0.8, 1, "quiet", "awake"), (100_000, 5, 1, 16, 0.8, 4, "quiet", "awake"), (100_000, 5, 0.25, 8, 0.8, 4, "quiet", "awake"),
    (100_000, 5, 0.25, 8, 0.8, 4, "quiet", "sleep"), (100_000, 10, 1, 16, 0.4, 1, "quiet", "awake"), (100_000, 10, 0.25, 8, 0.8, 4, "quiet", "sleep")]
KEYS = [("arrival_ms", 4), ("peak_mpa", 0), ("impulse_kpa_s", 2), ("cpu_s", 1)]


def make(build, out, options):
    """Makes the table."""
    program = build / "tests/validate_wall"
    exact = records([program, "exact", EXACT_CELLS], out / f"exact_{EXACT_CELLS}.jsonl", options.dry)
    rows = [["one dimension", "", "", "", "", "", *(f"{exact[0][key]:.{digits}f}" for key, digits in KEYS)]] if exact else []
    for run in (r for r in RUNS if r[0] <= options.most):
        found = []
        for seed in range(1, min(options.seeds, SEEDS) + 1):
            words = [str(word) for word in (*run, seed)]
            found += records([program, "particles", *words], out / ("_".join(words) + ".jsonl"), options.dry)
        if found:
            count, layers, *settings = run
            path, cell, cfl, partners, start, air = settings
            rows.append([f"{count:,}".replace(",", " "), layers, f"{path:g}", f"{cell}, {cfl:g}", partners, f"{start}, {air}",
                         *(spread([f[key] for f in found], digits) for key, digits in KEYS)])
    if rows:
        head = ["particles", "layers in the products", "mean free path [spacings]", "most in a cell, cfl", "partners", "start, air", "arrival [ms]", "peak [MPa]", "impulse [kPa s]", "CPU [s]"]
        write("wall", table(head, rows))
