"""Gravity, pressure from a file of points, a force on a set of nodes and a driven end, with gas above: closed books that name each, the
same bits for any number of threads, and after a stop and a resume."""

import json
import sys

from program import execute, run_checks
from runs import history_rows, same_after_interrupt, same_for_threads

CASE = """title = "loads of every kind"
end_time = "0.2 ms"
gravity = [0, 0, -9810]

[[charge]]
explosive = "tnt"
shape = "sphere"
mass = "5 g"
center = [0.1, 0.05, 0.2]

[gas]
box = [[-0.1, 0.4], [-0.1, 0.3], [-0.1, 0.3]]
particles = 4_000
fill = "air"

[[part]]
name = "strip"
mesh = { rectangle = { edge_1 = [0.2, 0, 0], edge_2 = [0, 0.1, 0], element_size = "20 mm" } }
element = { shell = { thickness = "4 mm" } }
material = "rha_steel"
fix = [{ where = "start_1", dof = "y" }]
drive = [{ where = "start_1", dof = "z", displacement = [[0, 0], ["0.1 ms", "0.2 mm"], ["0.2 ms", 0]] }]
start = [{ where = "x=0.2", velocity = [0, 0, 3] }]

[[part]]
name = "piston"
mesh = { box = { box = [[0.3, 0.35], [0, 0.1], [0, 0.1]], element_size = "50 mm" } }
element = { rigid = { mass = "1 kg" } }
drive = [{ where = "all", dof = "x", acceleration = { file = "push.csv", time_unit = "us", unit = "km/s2", scale = -1 } }]

[[load]]
part = "strip"
pressure = { file = "pulse.csv", time_unit = "ms", unit = "bar" }
where = "all"

[[load]]
part = "strip"
force = [[0, 0], ["0.1 ms", "1 kN"]]
direction = [0, 0, 2]
where = "x=0.2"

[[probe]]
name = "end"
node_at = [0.2, 0, 0]
quantities = ["displacement", "velocity"]
every = "5 us"

[[probe]]
name = "driven"
node_at = [0, 0, 0]
quantities = ["displacement"]
every = "5 us"
"""


def write_curves(folder):
    (folder / "pulse.csv").write_text("# a blast\ntime, pressure\n0, 0\n0.01; 20\n0.08 0\n")
    (folder / "push.csv").write_text("0,40\n")


def check_books(folder):
    write_curves(folder)
    execute(folder, "run", "case.toml", "--out", "a", "--quiet", "--threads", "1", check=0)
    summary = json.loads((folder / "a/summary.json").read_text())
    ledger, strip = summary["ledger"], summary["parts"]["strip"]
    assert abs(ledger["energy_error"]) < 2e-3 and abs(ledger["momentum_error"]) < 1e-6, ledger
    given = {t["from"]: t["momentum_n_s"] for t in ledger["transfers"] if t["to"] == "structure"}
    mass = 0.2 * 0.1 * 0.004 * 7850  # of the strip, rha_steel
    assert abs(given["gravity"][2] / (-9810 * 0.2e-3) - (mass + 1)) < 0.02, given
    assert abs(given["pressure"][2] / -(0.02 * 20e5 * 0.5 * (0.08e-3)) - 1) < 0.01, given  # on an area that hardly changes
    assert abs(given["force"][2] - (0.5 * 0.1e-3 + 0.1e-3) * 1e3) < 1e-9, given
    for axis in range(3):  # what the part took up: gas, pressure and force; the piston has gas alone
        assert abs(strip["impulse_n_s"][axis] - strip["gas_impulse_n_s"][axis] - given["pressure"][axis] - given["force"][axis]) < 1e-9, strip
    assert given["prescribed motion"][0] < -7.5, given  # 1 kg to -8 m/s
    column = header(folder).index("driven.displacement_z [m]")
    ways = [float(word) for word in (row.split(",")[column] for row in history_rows(folder / "a")) if word]
    assert max(ways) > 0.19e-3 and abs(ways[-1]) < 1e-9, ways  # there and back


def header(folder):
    return (folder / "a/history.csv").read_text().splitlines()[0].split(",")


def check_parts_after_stop(folder):
    """Sums of parts over a stop are those of the whole run."""
    assert json.loads((folder / "cut/summary.json").read_text())["parts"] == json.loads((folder / "whole/summary.json").read_text())["parts"]


def main():
    return run_checks(CASE, [check_books, same_for_threads, same_after_interrupt, check_parts_after_stop])


if __name__ == "__main__":
    sys.exit(main())
