"""Runs the program in a folder of its own and looks at what it says and leaves. Shared by the tests beside it."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()

# A small quarter of a plate under a charge: what the tests spoil or run.
CASE = """title = "a small plate"
end_time = "0.2 ms"

[[charge]]
explosive = "tnt"
shape = "sphere"
mass = "1 kg"
center = [0, 0, "300 mm"]

[gas]
box = [[0, "600 mm"], [0, "600 mm"], ["-100 mm", "600 mm"]]
edges = { x = ["rigid", "ambient"], y = ["rigid", "ambient"] }
particles = 2_000
fill = "air"

[[part]]
name = "plate"
mesh = { disk = { radius = "200 mm", element_size = "40 mm", quarter = true } }
element = { shell = { thickness = "5 mm" } }
material = "rha_steel"
fix = [{ where = "rim", dof = "all" }, { where = "x=0", dof = "symmetry" }, { where = "y=0", dof = "symmetry" }]

[[part]]
name = "frame"
mesh = { ring = { inner_radius = "200 mm", outer_radius = "900 mm", element_size = "80 mm", quarter = true } }
element = "rigid"
fix = [{ where = "all", dof = "all" }]

[[probe]]
name = "center"
node_at = [0, 0, 0]
quantities = ["displacement", "velocity"]
every = "10 us"

[output]
fields_every = "100 us"
"""


def replaced(old, new, text=CASE):
    """The text with its one place of `old` replaced."""
    assert text.count(old) == 1, f"{old!r} is there {text.count(old)} times"
    return text.replace(old, new)


def execute(folder, *words, check=None):
    """Runs the program there; gives code, standard output, standard error."""
    environment = {k: v for k, v in os.environ.items() if k != "CORPUSCLE_SHARE"}
    done = subprocess.run([str(PROGRAM), *words], cwd=folder, env=environment, capture_output=True, text=True, timeout=300, check=False)
    if check is not None and done.returncode != check:
        raise AssertionError(f"{words}: exit {done.returncode} in place of {check}\n{done.stdout}\n{done.stderr}")
    return done.returncode, done.stdout, done.stderr


def fresh_folder(files):
    """A new folder with these files (name to text)."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix="corpuscle_case_"))
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


def contents(folder):
    """Every file and folder under it, by relative name, with its size."""
    return {str(path.relative_to(folder)): path.stat().st_size if path.is_file() else None for path in folder.rglob("*")}


def run_checks(case, checks):
    """Runs checks one after the other in one new folder that holds the case as case.toml; says which are as they should be."""
    folder = fresh_folder({"case.toml": case})
    for check in checks:
        check(folder)
        print(f"{check.__name__}: as it should be", flush=True)
    shutil.rmtree(folder)
    return 0
