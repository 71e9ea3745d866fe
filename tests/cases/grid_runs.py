"""Gases on a grid from start to end: what a run leaves, bits that depend neither on threads nor on an interrupt, every symmetry."""

import json
import os
import signal
import subprocess
import sys
import time

from program import PROGRAM, contents, execute, replaced, run_checks

# An eighth of a ball of TNT on a corner of a box, its faces through the corner planes of symmetry.
GRID = """title = "a charge in a grid"
end_time = "0.1 ms"

[[charge]]
explosive = "tnt"
shape = "sphere"
mass = "1 kg"
center = [0, 0, 0]

[euler]
box = [[0, "400 mm"], [0, "400 mm"], [0, "400 mm"]]
edges = { x = ["rigid", "open"], y = ["rigid", "open"], z = ["rigid", "open"] }
cell_size = "20 mm"
fill = "air"

[[gauge]]
name = "ball"
sphere = { center = [0.2, 0.1, 0.1], radius = "10 mm" }
every = "5 us"

[[gauge]]
name = "floor"
face = "z-"
every = "5 us"

[output]
fields_every = "50 us"
"""
BOX = GRID[GRID.index("box = "):GRID.index("fill = ")]
RINGS = replaced(BOX, 'symmetry = "axisymmetric"\nbox = [[0, 0.4], [0, 0.4]]\nedges = { x = ["rigid", "open"], z = ["rigid", "open"] }\ncell_size = "10 mm"\n', GRID)
SHELLS = replaced(BOX, 'symmetry = "spherical"\nbox = [[0, 0.4]]\ncell_size = "2 mm"\n', GRID[:GRID.index('[[gauge]]\nname = "floor"')])


def history_rows(folder):
    return [line for line in (folder / "history.csv").read_text().splitlines()[1:] if line]


def summary_of(folder):
    return json.loads((folder / "summary.json").read_text())


def check_run(folder):
    _, out, error = execute(folder, "run", "case.toml", "--out", "a", check=0)
    left = contents(folder / "a")
    for name in ["case.resolved.toml", "run.log", "summary.json", "history.csv", "report.html", "fields/cells.hdf.series"]:
        assert left.get(name, 0) > 0, name
    summary = summary_of(folder / "a")
    assert summary["status"] == "done" and summary["counts"]["cells"] == 8000
    assert 0 < summary["work"]["cell_steps"] <= 8000 * summary["steps"]
    for error_of in ("mass_error", "momentum_error", "energy_error"):
        assert abs(summary["ledger"][error_of]) < 1e-11, summary["ledger"]
    burnt = [t for t in summary["ledger"]["transfers"] if t["from"] == "explosive"]
    assert len(burnt) == 1 and abs(burnt[0]["mass_kg"] - 0.125) < 1e-9
    assert abs(burnt[0]["energy_j"] - 0.125 / 1630 * 7e9) < 1
    assert summary["gauges"]["ball"]["peak_pressure_pa"] > 1e6 and summary["gauges"]["ball"]["arrival_s"] > 1e-5
    assert "(euler)" in error and "a cell and step" in out
    assert "8,000 cells" in (folder / "a/report.html").read_text()


def check_resolved_and_threads(folder):
    """The resolved case, read again, runs to the same bits; so does any number of threads."""
    execute(folder, "run", "a/case.resolved.toml", "--out", "again", "--quiet", check=0)
    assert history_rows(folder / "again") == history_rows(folder / "a")
    for threads in ("1", "2", "3"):
        execute(folder, "run", "case.toml", "--out", "t" + threads, "--quiet", "--threads", threads, check=0)
        assert history_rows(folder / ("t" + threads)) == history_rows(folder / "a")
    execute(folder, "run", "case.toml", "--out", "awake", "--quiet", "--set", "euler.sleep=false", check=0)
    awake = [row.rsplit(",", 1)[0] for row in history_rows(folder / "awake")]
    gauges = [[row.split(",")[:8] for row in rows] for rows in (awake, history_rows(folder / "a"))]
    assert gauges[0] == gauges[1]


def interrupted_run(folder, case, out):
    """Starts a run, sends it a signal when its history has begun; gives the exit code."""
    with subprocess.Popen([str(PROGRAM), "run", case, "--out", out, "--force"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        deadline = time.time() + 120
        while time.time() < deadline and process.poll() is None:
            history = folder / out / "history.csv"
            if history.exists() and len(history.read_text().splitlines()) > 6:
                os.kill(process.pid, signal.SIGTERM)
                break
            time.sleep(0.002)
        process.communicate(timeout=120)
        return process.returncode


def check_interrupt(folder):
    """An interrupted run, gone on with, is the uninterrupted one to the last bit, while explosive waits and after."""
    assert interrupted_run(folder, "case.toml", "cut") == 130
    execute(folder, "resume", "cut", "--quiet", check=0)
    assert history_rows(folder / "cut") == history_rows(folder / "a")
    execute(folder, "resume", "cut", "--quiet", "--set", "end_time=0.12 ms", check=0)
    assert summary_of(folder / "cut")["end_time_s"] > 1.19e-4
    assert "cannot be changed" in execute(folder, "resume", "cut", "--quiet", "--set", "euler.cfl=0.5", check=2)[2]


def check_symmetries(folder):
    """Rings and shells of finer cells see what the box sees, as far as its cells of 20 mm can tell: its detonation is spread over 2.5 of them (7 km/s), its shock over 2 (more than 4 km/s), and samples are 5 us apart."""
    spread = 2.5 * 0.02 / 6930 + 2 * 0.02 / 4000 + 5e-6
    for name, case in (("rings", RINGS), ("shells", SHELLS)):
        (folder / (name + ".toml")).write_text(case)
        execute(folder, "run", name + ".toml", "--out", name, "--quiet", check=0)
        ledger = summary_of(folder / name)["ledger"]
        assert max(abs(ledger[e]) for e in ("mass_error", "momentum_error", "energy_error")) < 1e-11, ledger
        arrival, wanted = (summary_of(folder / run)["gauges"]["ball"]["arrival_s"] for run in (name, "a"))
        assert abs(arrival - wanted) < spread, (name, arrival, wanted)


def check_start(folder):
    """From the blast in one dimension, on rings, against the wall of the box: the run begins later, and goes on after an interrupt to the same bits."""
    words = ["--quiet", "--set", "euler.start=spherical", "--set", 'euler.edges.x=["rigid", "rigid"]', "--set", "end_time=0.2 ms"]
    execute(folder, "run", "rings.toml", "--out", "begun", *words, check=0)
    begin = float(history_rows(folder / "begun")[0].split(",")[0])
    assert 5e-5 < begin < 1.5e-4, begin  # 0.38 m at 3 to 7 km/s
    assert "the run starts at" in execute(folder, "check", "rings.toml", *words[1:], check=0)[1]
    (folder / "begun.toml").write_text((folder / "begun/case.resolved.toml").read_text())
    assert interrupted_run(folder, "begun.toml", "half") == 130
    execute(folder, "resume", "half", "--quiet", check=0)
    assert history_rows(folder / "half") == history_rows(folder / "begun")


def check_check(folder):
    said = execute(folder, "check", "case.toml", check=0)[1]
    for word in ["tnt (charge 1)", "0.125", "8000 cells: 20 x 20 x 20, each 20 x 20 x 20 mm", "memory about", "steps about", "warning: charge 1 is only", "the case is good"]:
        assert word in said, word
    assert "1600 cells: 40 x 40" in execute(folder, "check", "rings.toml", check=0)[1]


def main():
    return run_checks(GRID, [check_run, check_resolved_and_threads, check_interrupt, check_symmetries, check_start, check_check])


if __name__ == "__main__":
    sys.exit(main())
