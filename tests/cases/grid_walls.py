"""A plate in the flow of gases on a grid: what a run leaves, its books, and bits that depend neither on threads nor on an interrupt."""

import json
import re
import sys

from grid_runs import history_rows, interrupted_run
from program import CASE, execute, replaced, run_checks

GAS = CASE[CASE.index("[gas]"):CASE.index("[[part]]")]
GRID = replaced('end_time = "0.2 ms"', 'end_time = "0.3 ms"', replaced(GAS, """[euler]
box = [[0, "600 mm"], [0, "600 mm"], ["-100 mm", "600 mm"]]
edges = { x = ["rigid", "open"], y = ["rigid", "open"] }
cell_size = "40 mm"
fill = "air"

[[gauge]]
name = "plate"
facets = "plate"
every = "5 us"

"""))


def check_run(folder):
    execute(folder, "check", "case.toml", check=0)
    execute(folder, "run", "case.toml", "--out", "a", "--quiet", "--threads", "1", check=0)
    summary = json.loads((folder / "a/summary.json").read_text())
    assert summary["status"] == "done" and summary["work"]["squeezed_cells"] == 0
    assert abs(summary["ledger"]["mass_error"]) < 1e-12 and abs(summary["ledger"]["momentum_error"]) < 1e-12, summary["ledger"]
    given = [t for t in summary["ledger"]["transfers"] if (t["from"], t["to"]) == ("gas", "structure")][0]
    burnt = [t for t in summary["ledger"]["transfers"] if t["from"] == "explosive"][0]
    # The exchange is exact; what is missing is central difference's own, some per cent of the work on a plate that a few elements span.
    assert abs(summary["ledger"]["energy_error"]) < 0.03 * given["energy_j"] / burnt["energy_j"], summary["ledger"]
    of_parts = [summary["parts"][name]["impulse_n_s"] for name in ("plate", "frame")]
    for axis in range(3):
        assert abs(given["momentum_n_s"][axis] - sum(part[axis] for part in of_parts)) < 1e-9 * abs(given["momentum_n_s"][2])
    assert of_parts[0][2] < -10 and given["energy_j"] > 1
    assert summary["gauges"]["plate"]["peak_pressure_pa"] > 1e6
    assert summary["probes"]["center"]["displacement_z_m"]["min"] < -1e-4


def check_bits(folder):
    """Two threads, and a run taken up again from its middle, give the same numbers to the last bit."""
    execute(folder, "run", "case.toml", "--out", "b", "--quiet", "--threads", "2", check=0)
    assert history_rows(folder / "b") == history_rows(folder / "a")
    assert interrupted_run(folder, "case.toml", "cut") == 130
    execute(folder, "resume", "cut", "--quiet", check=0)
    assert history_rows(folder / "cut") == history_rows(folder / "a")


SOLID = GRID[:GRID.index("[[part]]")].replace("[euler]", '[euler]\nstart = "spherical"').replace('facets = "plate"', 'facets = "block"') + """[[part]]
name = "block"
mesh = { disk = { radius = "200 mm", element_size = "50 mm", quarter = true }, extrude = { height = "60 mm", layers = 1 }, move = [0, 0, "-60 mm"] }
element = "solid"
material = "rha_steel"
fix = [{ where = "x=0", dof = "symmetry" }, { where = "y=0", dof = "symmetry" }]
"""


FINE = replaced('cell_size = "40 mm"', 'cell_size = "6.3 mm"', replaced('end_time = "0.3 ms"', 'end_time = "1 us"', replaced('"100 us"', '"0.2 us"', GRID)))


def check_memory(folder):
    """What `check` says that a run of a million cells needs, with a plate or without, is what it takes, pictures and saved states included."""
    for name, text in [("fine", FINE), ("bare", FINE[:FINE.index("[[gauge]]")])]:
        (folder / f"{name}.toml").write_text(text)
        said = re.search(r"memory about ([\d.]+) MB", execute(folder, "check", f"{name}.toml", check=0)[1])
        execute(folder, "run", f"{name}.toml", "--out", name, "--quiet", "--threads", "1", check=0)
        summary = json.loads((folder / name / "summary.json").read_text())
        assert summary["counts"]["cells"] > 1_000_000
        assert abs(1e6 * float(said.group(1)) / summary["peak_memory_bytes"] - 1) < 0.15, (said.group(0), summary["peak_memory_bytes"])


def check_solid(folder):
    """A free block of solids, from the blast in one dimension on: closed books, gas outside it alone."""
    (folder / "solid.toml").write_text(SOLID)
    execute(folder, "run", "solid.toml", "--out", "solid", "--quiet", check=0)
    summary = json.loads((folder / "solid/summary.json").read_text())
    assert summary["status"] == "done"
    assert abs(summary["ledger"]["mass_error"]) < 1e-12 and abs(summary["ledger"]["momentum_error"]) < 1e-12, summary["ledger"]
    assert summary["parts"]["block"]["impulse_n_s"][2] < -10, summary["parts"]


TWO_CHARGES = """title = "two charges over a plate between two supports"
end_time = "0.45 ms"

[[charge]]
explosive = "tnt"
shape = "sphere"
mass = "0.2 kg"
center = [0, 0, 0.2]

[[charge]]
explosive = "hmx"
shape = "cylinder"
mass = "0.1 kg"
center = [0.3, 0, 0.2]

[euler]
box = [[-0.5, 0.8], [-0.5, 0.5], [-0.2, 0.6]]
cell_size = "50 mm"
fill = "air"

[[part]]
name = "plate"
mesh = { rectangle = { origin = [-0.3, -0.3, 0], edge_1 = [0.9, 0, 0], edge_2 = [0, 0.6, 0], element_size = "30 mm" } }
element = { shell = { thickness = "3 mm" } }
material = "mild_steel"
fix = [{ where = "start_1", dof = "all" }, { where = "end_1", dof = "all" }]
"""


def check_two_charges(folder):
    """The products of two charges and air, all three in cells beside a wall."""
    (folder / "two.toml").write_text(TWO_CHARGES)
    execute(folder, "run", "two.toml", "--out", "two", "--quiet", check=0)
    summary = json.loads((folder / "two/summary.json").read_text())
    ledger = summary["ledger"]
    assert summary["status"] == "done" and abs(ledger["mass_error"]) < 1e-12 and abs(ledger["energy_error"]) < 1e-3, ledger
    given = [t for t in ledger["transfers"] if (t["from"], t["to"]) == ("gas", "structure")][0]
    assert given["momentum_n_s"][2] < -50, given


TORN = GRID.replace("thickness = \"5 mm\"", "thickness = \"2 mm\"").replace("fix = [{ where = \"rim", "erosion = { plastic_strain = 0.002 }\nfix = [{ where = \"rim")
BROKEN = SOLID.replace("layers = 1", "layers = 2").replace("rha_steel", "aluminium_5083_h116") + "erosion = { principal_stress = \"20 MPa\" }\n"


def check_eroding(folder):
    """A plate of shells that tears and a block of bricks that breaks up: closed books, no gas squeezed, the same bits on two threads and after an interrupt."""
    for name, text in [("torn", TORN), ("broken", BROKEN)]:
        (folder / f"{name}.toml").write_text(text)
        execute(folder, "run", f"{name}.toml", "--out", name, "--quiet", "--threads", "1", check=0)
        summary = json.loads((folder / name / "summary.json").read_text())
        ledger, work = summary["ledger"], summary["work"]
        assert summary["status"] == "done" and work["squeezed_cells"] == 0, work
        assert abs(ledger["mass_error"]) < 1e-12 and abs(ledger["momentum_error"]) < 1e-12, ledger
        eroded = [t for t in ledger["transfers"] if t["to"] == "eroded"]
        assert len(eroded) == 1 and eroded[0]["mass_kg"] > 0.01, ledger
        execute(folder, "run", f"{name}.toml", "--out", f"{name}_2", "--quiet", "--threads", "2", check=0)
        assert history_rows(folder / name) == history_rows(folder / f"{name}_2")
        assert interrupted_run(folder, f"{name}.toml", f"{name}_cut") == 130
        execute(folder, "resume", f"{name}_cut", "--quiet", check=0)
        assert history_rows(folder / name) == history_rows(folder / f"{name}_cut")


if __name__ == "__main__":
    sys.exit(run_checks(GRID, [check_run, check_bits, check_solid, check_two_charges, check_eroding, check_memory]))
