"""The command radial, and a run that begins from the blast in one dimension."""

import csv
import json
import sys

from program import CASE, contents, execute, run_checks, replaced

SPHERICAL = replaced("fill = \"air\"", "fill = \"air\"\nstart = \"spherical\"")
TWO = replaced("[gas]", CASE[CASE.index("[[charge]]"):CASE.index("[gas]")] + "[gas]")


def check_command(folder):
    """Peaks beside the curves of Kingery and Bulmash, history and profile in a folder."""
    said = execute(folder, "radial", "case.toml", "--at", "0.3,0.2", "--cells", "20", "--set", "end_time=0.4 ms", "--out", "blast", check=0)[1]
    row = next(line.split() for line in said.splitlines() if line.split()[:1] == ["0.3"])
    peak, empirical = float(row[3]), float(row[6])
    assert 0.8 < peak / empirical < 1.2, said  # the curves' own scatter is no less
    with open(folder / "blast/history.csv", newline="") as file:
        rows = list(csv.reader(file))
    assert rows[0][:3] == ["time [s]", "at 0.2 m.pressure [Pa]", "at 0.2 m.density [kg/m3]"], rows[0]
    assert 0.85 * 1e3 * peak < max(float(r[4]) for r in rows[1:]) <= 1.05 * (1e3 * peak + 101325), (peak, rows[0])
    with open(folder / "blast/profile.csv", newline="") as file:
        profile = list(csv.DictReader(file))
    assert {cell["gas"] for cell in profile} == {"1", "2"}
    assert execute(folder, "radial", "case.toml", "--at", "0.3", "--cells", "20", "--out", "blast", check=2)[2].count("--force") == 1


def check_refusals(folder):
    """What it cannot solve: exit code 2, why, and nothing written."""
    (folder / "two.toml").write_text(TWO)
    (folder / "bare.toml").write_text(CASE[:CASE.index("[[charge]]")] + CASE[CASE.index("[[part]]"):])
    before = contents(folder)
    for words, pattern in [(["case.toml"], "--at"), (["case.toml", "--at", "0.3,x"], "no list of distances"), (["case.toml", "--at", "-1"], "--at"),
                           (["two.toml", "--at", "0.3"], "2 charges"), (["bare.toml", "--at", "0.3"], "[gas]"), (["case.toml", "--at", "0.3", "--cells", "1"], "--cells")]:
        error = execute(folder, "radial", *words, "--out", "bad", check=2)[2]
        assert pattern in error, (words, error)
    assert contents(folder) == before


def check_run(folder):
    """A run from a spherical start: clock and history begin there, and nothing is lost."""
    (folder / "spherical.toml").write_text(SPHERICAL)
    assert "the run starts at 0." in execute(folder, "check", "spherical.toml", check=0)[1]
    execute(folder, "run", "spherical.toml", "--quiet", "--out", "run", check=0)
    summary = json.loads((folder / "run/summary.json").read_text())
    assert summary["status"] == "done" and summary["ledger"]["energy_error"] < 1e-4, summary["ledger"]
    assert "explosive" not in {transfer["from"] for transfer in summary["ledger"].get("transfers", [])}
    with open(folder / "run/history.csv", newline="") as file:
        times = [float(row[0]) for row in list(csv.reader(file))[1:]]
    assert 1e-5 < times[0] < 1e-4 < times[-1], (times[0], times[-1])


def main():
    return run_checks(CASE, [check_command, check_refusals, check_run])


if __name__ == "__main__":
    sys.exit(main())
