"""Runs from start to end: what they leave, --force, --set, an interrupt and going on, bits that do not depend on threads."""

import json
import os
import re
import resource
import signal
import subprocess
import sys
import time

from program import CASE, PROGRAM, contents, execute, run_checks


def history_rows(folder):
    return [line for line in (folder / "history.csv").read_text().splitlines()[1:] if line]


def check_run(folder):
    _, out, error = execute(folder, "run", "case.toml", "--out", "a", check=0)
    left = contents(folder / "a")
    for name in ["case.resolved.toml", "run.log", "summary.json", "history.csv", "report.html"]:
        assert left.get(name, 0) > 0, name
    summary = json.loads((folder / "a/summary.json").read_text())
    assert summary["status"] == "done" and summary["steps"] > 10
    assert abs(summary["end_time_s"] - 2e-4) < 1e-12
    assert abs(summary["ledger"]["energy_error"]) < 1e-3 and abs(summary["ledger"]["mass_error"]) < 1e-6
    assert summary["probes"]["center"]["displacement_z_m"]["min"] < -1e-4  # pushed away from the charge
    assert "100 %" in error and "report" in out  # plain lines in a pipe
    assert "\r" not in error


def check_refusal_and_force(folder):
    before = (folder / "a/summary.json").read_bytes()
    assert "--force" in execute(folder, "run", "case.toml", "--out", "a", check=2)[2]
    assert (folder / "a/summary.json").read_bytes() == before
    _, out, error = execute(folder, "run", "case.toml", "--out", "a", "--force", "--quiet", "--set", "end_time=0.05 ms", check=0)
    assert abs(json.loads((folder / "a/summary.json").read_text())["end_time_s"] - 5e-5) < 1e-12
    assert error == "", error


def check_resolved(folder):
    """The resolved case, read again, runs to the same bits."""
    execute(folder, "run", "a/case.resolved.toml", "--out", "again", "--quiet", check=0)
    assert history_rows(folder / "again") == history_rows(folder / "a")


def check_threads(folder):
    for threads in ("1", "2", "3", "4", "7"):
        execute(folder, "run", "case.toml", "--out", "t" + threads, "--quiet", "--threads", threads, check=0)
        assert history_rows(folder / ("t" + threads)) == history_rows(folder / "t1")


def interrupted_run(folder, number, out="cut", words=("--set", "gas.particles=20_000")):
    """Starts a run, sends it a signal when its history has begun; gives the exit code."""
    with subprocess.Popen([str(PROGRAM), "run", "case.toml", "--out", out, "--force", *words], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        deadline = time.time() + 120
        while time.time() < deadline and process.poll() is None:
            history = folder / out / "history.csv"
            if history.exists() and len(history.read_text().splitlines()) > 3:
                os.kill(process.pid, number)
                break
            time.sleep(0.005)
        process.communicate(timeout=120)
        return process.returncode


def same_for_threads(folder):
    """Three threads give what run "a" gave, to the last bit."""
    execute(folder, "run", "case.toml", "--out", "three", "--quiet", "--threads", "3", check=0)
    assert history_rows(folder / "a") == history_rows(folder / "three")


def same_after_interrupt(folder):
    """A run stopped on its way and resumed leaves what one run leaves, to the last bit."""
    words = ["--quiet", "--set", "gas.particles=30_000"]
    assert interrupted_run(folder, signal.SIGTERM, "cut", words) == 130
    execute(folder, "resume", "cut", "--quiet", check=0)
    execute(folder, "run", "case.toml", "--out", "whole", *words, check=0)
    assert history_rows(folder / "cut") == history_rows(folder / "whole")


def check_interrupt(folder):
    assert interrupted_run(folder, signal.SIGTERM) == 130
    assert json.loads((folder / "cut/summary.json").read_text())["status"] == "interrupted"
    assert any((folder / "cut/restart").iterdir())
    execute(folder, "resume", "cut", "--quiet", check=0)
    summary = json.loads((folder / "cut/summary.json").read_text())
    assert summary["status"] == "done" and abs(summary["end_time_s"] - 2e-4) < 1e-12
    execute(folder, "run", "case.toml", "--out", "whole", "--quiet", "--set", "gas.particles=20_000", check=0)
    assert history_rows(folder / "cut") == history_rows(folder / "whole")  # to the last bit


def check_hard_spheres(folder):
    """The other rule of collision: closed books, the same bits for any threads, and after a stop and a resume."""
    words = ["--quiet", "--set", 'gas.collision="hard_spheres"', "--set", 'charge.0.explosive="tnt_paper"']
    for threads in ("1", "3"):
        execute(folder, "run", "case.toml", "--out", "s" + threads, *words, "--threads", threads, check=0)
    assert history_rows(folder / "s1") == history_rows(folder / "s3")
    assert history_rows(folder / "s1") != history_rows(folder / "t1")
    ledger = json.loads((folder / "s1/summary.json").read_text())["ledger"]
    assert abs(ledger["energy_error"]) < 1e-3 and abs(ledger["mass_error"]) < 1e-6 and abs(ledger["momentum_error"]) < 1e-5
    fine = [*words, "--set", "gas.particles=20_000"]
    assert interrupted_run(folder, signal.SIGTERM, "half", fine) == 130
    execute(folder, "resume", "half", "--quiet", check=0)
    execute(folder, "run", "case.toml", "--out", "unbroken", *fine, check=0)
    assert history_rows(folder / "half") == history_rows(folder / "unbroken")  # to the last bit


def check_safety(folder):
    """A plate far too thin for its load: the run stops itself, says where, and keeps a good state."""
    words = ["--set", "part.0.element.shell.thickness=0.02 mm", "--set", "part.0.material=elastic_steel", "--set", "end_time=1 ms", "--set", "charge.0.mass=5 kg"]
    error = execute(folder, "run", "case.toml", "--out", "torn", "--quiet", *words, check=3)[2]
    assert "element" in error and "'plate'" in error and "Segmentation" not in error, error
    assert json.loads((folder / "torn/summary.json").read_text())["status"] == "stopped"
    assert any((folder / "torn/restart").iterdir())


def check_full_disk(folder):
    """Where files can grow no further (a disk that is full behaves the same) a run ends with what happened and a remedy, and no crash."""

    def no_larger():
        resource.setrlimit(resource.RLIMIT_FSIZE, (40_000, 40_000))

    words = [str(PROGRAM), "run", "case.toml", "--out", "full", "--quiet", "--set", "gas.particles=20_000"]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=300, check=False, preexec_fn=no_larger, restore_signals=False)
    assert done.returncode == 2, (done.returncode, done.stderr)
    assert re.search(r"full/.*: File too large; .*disk not full", done.stderr), done.stderr
    assert "errno" not in done.stderr and len(done.stderr.splitlines()) == 1, done.stderr


def check_going_further(folder):
    """A run that is done goes on to a later end; what its state was made with stays as it is, and so does the folder when that is asked for."""
    before, files = history_rows(folder / "t2"), contents(folder / "t2")
    for words, pattern in [("gas.particles=3_000", "'gas.particles' cannot be changed half way"), ("part.0.material=copper", "cannot be changed"), ("end_time=0.1 ms", "expected a later end_time"), ("output.averags=3", "did you mean 'averages'")]:
        assert pattern in execute(folder, "resume", "t2", "--quiet", "--set", words, check=2)[2], words
        assert contents(folder / "t2") == files and history_rows(folder / "t2") == before, words
    execute(folder, "resume", "t2", "--quiet", "--set", "end_time=0.3 ms", "--set", "output.fields_every=50 us", check=0)
    summary = json.loads((folder / "t2/summary.json").read_text())
    assert summary["status"] == "done" and abs(summary["end_time_s"] - 3e-4) < 1e-12
    after = history_rows(folder / "t2")
    assert after[:len(before)] == before and len(after) > len(before) + 5
    assert "0.0003" in (folder / "t2/case.resolved.toml").read_text() or "0.3 ms" in (folder / "t2/case.resolved.toml").read_text()
    execute(folder, "resume", "t2", "--quiet", check=0)


def check_report(folder):
    (folder / "t1/report.html").unlink()
    execute(folder, "report", "t1", check=0)
    assert (folder / "t1/report.html").stat().st_size > 1000


def main():
    return run_checks(CASE, [check_run, check_refusal_and_force, check_resolved, check_threads, check_interrupt, check_hard_spheres, check_safety, check_full_disk, check_going_further, check_report])


if __name__ == "__main__":
    sys.exit(main())
