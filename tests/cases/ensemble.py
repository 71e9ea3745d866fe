"""Ensembles from start to end: what they leave, what the numbers mean, an interrupt and going on with the same bits."""

import csv
import json
import math
import os
import shutil
import signal
import statistics
import subprocess
import sys
import time

from program import CASE, PROGRAM, contents, execute, run_checks

GAUGES = """
[[gauge]]
name = "plate"
facets = "plate"
every = "20 us"

[[gauge]]
name = "ball"
sphere = { center = [0, 0, "150 mm"], radius = "50 mm" }
every = "20 us"
"""
CASE_OF_FOUR = "ensemble = 4\n" + CASE + GAUGES
STUDENT_OF_3 = 3.182446305284263  # two-sided 95 %, 3 degrees of freedom; any table of Student's t


def summary_of(folder):
    return json.loads((folder / "summary.json").read_text())


def rows_of(folder):
    with open(folder / "history.csv", newline="") as file:
        return list(csv.DictReader(file))


def check_check(folder):
    said = execute(folder, "check", "case.toml", "--threads", "2", check=0)[1]
    assert "an ensemble of 4 such runs, 2 at a time on 1 thread each" in said and "4 times the work" in said, said


def check_run(folder):
    _, out, error = execute(folder, "run", "case.toml", "--out", "a", check=0)
    assert "4 of 4 runs done" in out and "seed 4 done" in error, (out, error)
    assert {path.name for path in (folder / "a").iterdir()} == {"case.resolved.toml", "run.log", "summary.json", "history.csv", "report.html"} | {f"seed_{k}" for k in range(1, 5)}
    for k in range(1, 5):
        assert summary_of(folder / f"a/seed_{k}")["seed"] == k
        assert (folder / f"a/seed_{k}/report.html").stat().st_size > 1000


def check_means(folder):
    """Every number of the summary is what its definition says, from the members' own summaries."""
    whole, members = summary_of(folder / "a"), [summary_of(folder / f"a/seed_{k}") for k in range(1, 5)]
    block = whole["ensemble"]
    assert whole["status"] == "done" and block["members"] == 4 and block["done"] == [1, 2, 3, 4] and block["confidence"] == 0.95
    for path in [("probes", "center", "displacement_z_m", "min"), ("probes", "center", "velocity_z_m_per_s", "time_of_max_s"), ("gauges", "plate", "impulse_pa_s"), ("parts", "plate", "kinetic_energy_j")]:
        values, found, shown = list(members), block["quantities"], whole
        for key in path:
            values, found, shown = [value[key] for value in values], found[key], shown[key]
        mean, deviation = statistics.mean(values), statistics.stdev(values)
        reach = STUDENT_OF_3 * deviation / 2
        for got, wanted in [(found["mean"], mean), (shown, mean), (found["deviation"], deviation), (found["standard_error"], deviation / 2), (found["low"], mean - reach), (found["high"], mean + reach)]:
            assert math.isclose(got, wanted, rel_tol=1e-9, abs_tol=1e-12 * abs(mean)), (path, got, wanted)
    assert whole["steps"] == sum(member["steps"] for member in members)


def check_history(folder):
    """At the times the case asks for; a displacement is its members' mean, interpolated between their samples."""
    rows, column = rows_of(folder / "a"), "center.displacement_z [m]"
    times = [float(row["time [s]"]) for row in rows if row[column]]
    assert len(times) == 21 and all(math.isclose(t, 1e-5 * k, abs_tol=1e-15) for k, t in enumerate(times)), times
    last = [float([row[column] for row in rows_of(folder / f"a/seed_{k}") if row[column]][-1]) for k in range(1, 5)]
    end = [row for row in rows if row[column]][-1]
    assert math.isclose(float(end[column]), statistics.mean(last), rel_tol=1e-9)
    assert math.isclose(float(end["center.displacement_deviation_z [m]"]), statistics.stdev(last), rel_tol=1e-9)
    assert float(end["center.displacement_low_z [m]"]) < float(end[column]) < float(end["center.displacement_high_z [m]"])
    assert not any("_error" in name and not name.startswith("ledger.") for name in rows[0]), list(rows[0])
    assert "band: 95 %" in (folder / "a/report.html").read_text()


def check_member(folder):
    """A member is the run one gets with its seed alone, to the last bit; an ensemble of one is a plain run."""
    execute(folder, "run", "case.toml", "--out", "third", "--quiet", "--set", "ensemble=1", "--set", "gas.seed=3", check=0)
    assert (folder / "third/history.csv").read_bytes() == (folder / "a/seed_3/history.csv").read_bytes()
    assert "ensemble" not in summary_of(folder / "third") and "seed_1" not in contents(folder / "third")


def check_refusal(folder):
    before = contents(folder / "a")
    assert "--force" in execute(folder, "run", "case.toml", "--out", "a", check=2)[2]
    assert contents(folder / "a") == before
    (folder / "b").mkdir()
    shutil.copytree(folder / "a/seed_2", folder / "b/seed_2")
    assert "seed_2" in execute(folder, "run", "case.toml", "--out", "b", check=2)[2]


def interrupted(folder, ask):
    """Starts the ensemble in "cut" and has it stopped when its second member has begun; gives the exit code."""
    shutil.rmtree(folder / "cut/seed_2", ignore_errors=True)  # so that its history is the new one's
    words = [str(PROGRAM), "run", "case.toml", "--out", "cut", "--force", "--threads", "1", "--set", "gas.particles=20_000"]
    with subprocess.Popen(words, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        deadline = time.time() + 120
        while time.time() < deadline and process.poll() is None:
            history = folder / "cut/seed_2/history.csv"
            if history.exists() and len(history.read_text().splitlines()) > 3:
                ask(process.pid)
                break
            time.sleep(0.005)
        process.communicate(timeout=120)
        return process.returncode


def check_going_on(folder):
    """Stopped by a signal, then by a file; what is done is not repeated, and in the end the bits are those of one that was not stopped."""
    assert interrupted(folder, lambda pid: os.kill(pid, signal.SIGTERM)) == 130
    assert summary_of(folder / "cut")["status"] == "interrupted" and summary_of(folder / "cut/seed_1")["status"] == "done"
    assert summary_of(folder / "cut/seed_2")["status"] == "interrupted" and not (folder / "cut/seed_3").exists()
    first = (folder / "cut/seed_1/run.log").read_bytes()
    execute(folder, "resume", "cut", "--quiet", check=0)
    assert (folder / "cut/seed_1/run.log").read_bytes() == first
    assert summary_of(folder / "cut")["status"] == "done" and summary_of(folder / "cut")["ensemble"]["done"] == [1, 2, 3, 4]
    execute(folder, "run", "case.toml", "--out", "whole", "--quiet", "--threads", "2", "--set", "gas.particles=20_000", check=0)
    for name in ["history.csv"] + [f"seed_{k}/history.csv" for k in range(1, 5)]:
        assert (folder / "cut" / name).read_bytes() == (folder / "whole" / name).read_bytes(), name
    assert interrupted(folder, lambda pid: (folder / "cut/stop").touch()) == 130
    assert summary_of(folder / "cut")["ensemble"]["done"] == [1]  # nothing is left of the earlier one


def check_going_further(folder):
    """All members go on to a later end."""
    assert "half way" in execute(folder, "resume", "whole", "--quiet", "--set", "ensemble=5", check=2)[2]
    before = contents(folder / "whole")
    assert "expected a later end_time" in execute(folder, "resume", "whole", "--quiet", "--set", "end_time=0.1 ms", check=2)[2]
    assert contents(folder / "whole") == before
    execute(folder, "resume", "whole", "--quiet", "--set", "end_time=0.22 ms", check=0)
    summary = summary_of(folder / "whole")
    assert summary["status"] == "done" and summary["ensemble"]["done"] == [1, 2, 3, 4]
    assert all(abs(summary_of(folder / f"whole/seed_{k}")["end_time_s"] - 2.2e-4) < 1e-12 for k in range(1, 5))
    assert abs(float(rows_of(folder / "whole")[-1]["time [s]"]) - 2.2e-4) < 1e-12


def check_failure(folder):
    """A member that stops itself is told of; the others' results stay."""
    words = ["--set", "part.0.element.shell.thickness=0.02 mm", "--set", "part.0.material=elastic_steel", "--set", "end_time=1 ms", "--set", "charge.0.mass=5 kg", "--set", "ensemble=2"]
    execute(folder, "run", "case.toml", "--out", "torn", "--quiet", *words, check=3)
    summary = summary_of(folder / "torn")
    assert summary["status"] == "stopped" and "seed 1 ended with code 3" in summary["reason"], summary["reason"]


def main():
    return run_checks(CASE_OF_FOUR, [check_check, check_run, check_means, check_history, check_member, check_refusal, check_going_on, check_going_further, check_failure])


if __name__ == "__main__":
    sys.exit(main())
