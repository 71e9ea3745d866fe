"""A plate read from gmsh, Abaqus and LS-DYNA files of the same mesh, written out or made, gives the same run to the last bit; check tells its quality with the
file's numbers; what a file cannot be read for is refused by its line."""

import re
import sys

from program import execute, run_checks
from runs import history_rows

SIDE, CELLS = 200.0, 8  # [mm], cells along each side
NODES = [(1000 + i + (CELLS + 1) * j, SIDE * i / CELLS, SIDE * j / CELLS) for j in range(CELLS + 1) for i in range(CELLS + 1)]
QUADS = [(i + (CELLS + 1) * j, i + 1 + (CELLS + 1) * j, i + 1 + (CELLS + 1) * (j + 1), i + (CELLS + 1) * (j + 1)) for j in range(CELLS) for i in range(CELLS)]
EDGE = [tag for tag, x, _ in NODES if x == 0]


def gmsh():
    text = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "2", '1 1 "edge"', '2 2 "hull"', "$EndPhysicalNames", "$Nodes", str(len(NODES))]
    text += [f"{tag} {x} {y} 0" for tag, x, y in NODES]
    lines = list(zip(EDGE, EDGE[1:]))
    text += ["$EndNodes", "$Elements", str(len(lines) + len(QUADS))]
    text += [f"{n + 1} 1 2 1 1 {a} {b}" for n, (a, b) in enumerate(lines)]
    text += [f"{n + 501} 3 2 2 1 {' '.join(str(1000 + k) for k in quad)}" for n, quad in enumerate(QUADS)]
    return "\n".join(text + ["$EndElements", ""])


def abaqus():
    text = ["*HEADING", "plate", "*NODE"] + [f"{tag}, {x}, {y}, 0." for tag, x, y in NODES] + ["*ELEMENT, TYPE=S4R, ELSET=hull"]
    text += [f"{n + 501}, {', '.join(str(1000 + k) for k in quad)}" for n, quad in enumerate(QUADS)]
    return "\n".join(text + ["*NSET, NSET=edge", ", ".join(map(str, EDGE)), "*MATERIAL, NAME=STEEL", ""])


def dyna():
    text = ["*KEYWORD", "*NODE"] + [f"{tag:8d}{x:16.6f}{y:16.6f}{0:16.6f}" for tag, x, y in NODES] + ["*ELEMENT_SHELL"]
    text += [f"{n + 501:8d}{1:8d}" + "".join(f"{1000 + k:8d}" for k in quad) for n, quad in enumerate(QUADS)]
    return "\n".join(text + ["*PART", "hull", "1,1,1", "*SET_NODE_LIST_TITLE", "edge", "1", ",".join(map(str, EDGE)), "*END", ""])


def made():
    """The same by copies: rows of nodes of the first, elements of one."""
    rows = [line for j in range(1, CELLS + 1) for line in [f"*NCOPY, CHANGE NUMBER={(CELLS + 1) * j}, OLD SET=row, SHIFT", f"0, {SIDE * j / CELLS}, 0"]]
    text = ["*NODE, NSET=row"] + [f"{tag}, {x}, {y}" for tag, x, y in NODES if y == 0] + rows
    text += ["*ELEMENT, TYPE=S4R", f"501, {', '.join(str(1000 + k) for k in QUADS[0])}"]
    text += ["*ELGEN, ELSET=hull", f"501, {CELLS}, 1, 1, {CELLS}, {CELLS + 1}, {CELLS}"]
    return "\n".join(text + ["*NSET, NSET=edge, GENERATE", f"{EDGE[0]}, {EDGE[-1]}, {CELLS + 1}", ""])


def half():
    """The same in half its size and with other numbers, beside a deck that includes it doubled."""
    text = ["*KEYWORD", "*NODE"] + [f"{tag - 900},{x / 2},{y / 2},0." for tag, x, y in NODES] + ["*ELEMENT_SHELL"]
    text += [f"{n + 1},1,{','.join(str(100 + k) for k in quad)}" for n, quad in enumerate(QUADS)]
    return "\n".join(text + ["*PART", "hull", "1,1,1", "*SET_NODE_LIST_TITLE", "edge", "1", ",".join(str(tag - 900) for tag in EDGE), "*END", ""])


DOUBLED = """*KEYWORD
*PARAMETER
R    size         4.I   shift        900
*PARAMETER_EXPRESSION
R   twice sqrt(&size)
*DEFINE_TRANSFORMATION
1
SCALE,&twice,<4/2>,1.
*INCLUDE_TRANSFORM
half.k
&shift,500,<3*2>


1
*END
"""

CASE = """title = "a plate from a file"
end_time = "0.2 ms"

[[part]]
name = "plate"
mesh = { file = "MESH", unit = "mm", group = "hull" }
element = { shell = { thickness = "6 mm" } }
material = "rha_steel"
fix = [{ where = "edge", dof = "all" }]

[[load]]
conwep = { mass = "20 g", center = ["100 mm", "100 mm", "200 mm"] }
part = "plate"

[[probe]]
name = "corner"
node_at = [0.2, 0.2, 0]
quantities = ["displacement"]
every = "5 us"
"""
FILES = {"plate.msh": gmsh(), "plate.inp": abaqus(), "plate.k": dyna(), "made.inp": made(), "doubled.k": DOUBLED}


def check_same_runs(folder):
    rows = {}
    (folder / "half.k").write_text(half())
    for name, text in FILES.items():
        (folder / name).write_text(text)
        (folder / "case.toml").write_text(CASE.replace("MESH", name))
        execute(folder, "run", "case.toml", "--out", f"run_{name}", "--quiet", check=0)
        rows[name] = history_rows(folder / f"run_{name}")
        assert len(rows[name]) > 20, name
    for name in FILES:
        assert rows[name] == rows["plate.msh"], name


def check_quality(folder):
    """The file's numbers in the table and the log; a small element is pointed out."""
    said = execute(folder, "check", "case.toml", check=0)[1]
    for word in ["worst aspect", "warp", "Jacobian", "the structure's step is set by element 5"]:
        assert word in said, (word, said)
    assert "scaled Jacobian 1 (element 501)" in (folder / "run_plate.k/run.log").read_text()
    squeezed = re.sub(rf"(?m)^(\d+), {SIDE / CELLS}, ", r"\1, 2.0, ", FILES["plate.inp"])  # the first column of elements is 2 mm wide
    (folder / "plate.inp").write_text(squeezed)
    (folder / "case.toml").write_text(CASE.replace("MESH", "plate.inp"))
    said = execute(folder, "check", "case.toml", check=0)[1]
    assert "8 elements are slender: longest over shortest edge above 10 (elements 501, 509, 517, 525, 533, ...)" in said and "element 501 allows a step of" in said, said
    assert "passed over: *MATERIAL" in said, said


def check_refusals(folder):
    mistakes = [("plate.inp", "S4R", "S8R", "S8R are of second order"), ("plate.inp", "*NSET, NSET=edge", "*NMAP", "*NMAP is not read"),
                ("plate.k", "*ELEMENT_SHELL", "*ELEMENT_TSHELL", "*ELEMENT_TSHELL are not computed"), ("plate.k", "     501", "     5O1", "'5O1' is not a whole number"),
                ("plate.msh", "hull", "shell", "the mesh has no group 'hull'"), ("plate.k", "edge", "rim", "no set of nodes 'edge'")]
    for name, old, new, answer in mistakes:
        text = FILES[name].replace(old, new, 1)
        assert text != FILES[name], old
        (folder / name).write_text(text)
        (folder / "case.toml").write_text(CASE.replace("MESH", name))
        said = execute(folder, "run", "case.toml", "--out", "none", check=2)[2]
        assert answer in said, (answer, said)
        assert not (folder / "none").exists()


def main():
    return run_checks(CASE, [check_same_runs, check_quality, check_refusals])


if __name__ == "__main__":
    sys.exit(main())
