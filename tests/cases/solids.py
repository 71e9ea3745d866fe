"""A plate of bricks that tears, a cloth and a rigid body that flies, all under gas: closed books, the same bits for any number of
threads, and after a stop and a resume."""

import json
import sys

from program import execute, run_checks
from runs import same_after_interrupt, same_for_threads

CASE = """title = "solids under a charge"
end_time = "0.2 ms"

[[charge]]
explosive = "tnt"
shape = "sphere"
mass = "1 kg"
center = [0, 0, "150 mm"]

[gas]
box = [[0, "500 mm"], [0, "500 mm"], ["-200 mm", "500 mm"]]
edges = { x = ["rigid", "ambient"], y = ["rigid", "ambient"] }
particles = 8_000
fill = "air"

[[part]]
name = "plate"
mesh = { disk = { radius = "200 mm", element_size = "40 mm", quarter = true }, extrude = { height = "8 mm", layers = 2 }, move = [0, 0, "-8 mm"] }
element = "solid"
material = "aluminium_5083_h116"
erosion = { plastic_strain = 0.06 }
fix = [{ where = "rim", dof = "all" }, { where = "x=0", dof = "symmetry" }, { where = "y=0", dof = "symmetry" }]

[[part]]
name = "block"
mesh = { box = { box = [["250 mm", "330 mm"], ["250 mm", "330 mm"], ["50 mm", "130 mm"]], element_size = "40 mm" } }
element = { rigid = { mass = "2 kg" } }
spin = [0, 0, 50]

[[part]]
name = "cloth"
mesh = { rectangle = { origin = ["20 mm", "20 mm", "-120 mm"], edge_1 = [0.2, 0, 0], edge_2 = [0, 0.2, 0], element_size = "40 mm" } }
element = { membrane = { thickness = "2 mm" } }
material = "fabric_nylon"
point_masses = [{ where = "end_1", mass = "100 g" }]
fix = [{ where = "start_1", dof = "all" }]

[[probe]]
name = "corner"
node_at = [0.33, 0.33, 0.13]
quantities = ["displacement", "velocity"]
every = "5 us"

[output]
fields_every = "100 us"
"""


def check_books(folder):
    execute(folder, "run", "case.toml", "--out", "a", "--quiet", "--threads", "1", check=0)
    summary = json.loads((folder / "a/summary.json").read_text())
    ledger = summary["ledger"]
    assert abs(ledger["energy_error"]) < 2e-3 and abs(ledger["mass_error"]) < 1e-6 and abs(ledger["momentum_error"]) < 1e-6, ledger
    eroded = [t for t in ledger["transfers"] if t["to"] == "eroded"]
    assert len(eroded) == 1 and eroded[0]["mass_kg"] > 0.01 and eroded[0]["energy_j"] > 0, eroded
    block = summary["parts"]["block"]
    assert min(block["impulse_n_s"][:2]) > 1 and block["kinetic_energy_j"] > 0.5 * sum(p * p for p in block["impulse_n_s"]) / 2  # blown away, and spinning
    assert summary["parts"]["cloth"]["internal_energy_j"] > 0


def check_survey(folder):
    said = execute(folder, "check", "case.toml", check=0)[1]
    for word in ["brick", "membrane", "rigid"]:
        assert word in said, word


def main():
    return run_checks(CASE, [check_survey, check_books, same_for_threads, same_after_interrupt])


if __name__ == "__main__":
    sys.exit(main())
