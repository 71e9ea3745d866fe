"""The table of particles among many moving, folded and eroding facets: how many hits, and how many particles came through."""
from page import records, table, write


def make(build, out, options):
    """Makes the table."""
    found = records([build / "tests/validate_leaks"], out / "leaks.jsonl", options.dry)
    if not found:
        return
    head = ["hits", "steps", "facets", "of them hit", "eroded", "fastest node [m/s]", "particles", "in a room they could not come to", "trapped", "CPU [s]"]
    rows = [[f"{r['hits']:.3g}", r["steps"], r["facets"], r["facets_hit"], r["eroded"], r["fastest_node"], r["particles"], r["astray"], r["trapped"],
             f"{r['cpu_s']:.0f}"] for r in found]
    write("leaks", table(head, rows))
