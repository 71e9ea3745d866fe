"""Every mistake a case can have ends with exit code 2, a place, what was expected, and nothing written."""

import re
import shutil
import sys

from program import CASE, SOURCE, contents, execute, fresh_folder, replaced

# A square of two triangles that stand apart (a hole all round), text STL.
OPEN_STL = """solid open
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid open
"""


def mesh_file(nodes, elements):
    """A gmsh 2.2 file of quadrilaterals."""
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(nodes))]
    lines += [f"{i + 1} {x} {y} {z}" for i, (x, y, z) in enumerate(nodes)]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{i + 1} 3 2 1 1 {' '.join(str(n) for n in element)}" for i, element in enumerate(elements)]
    return "\n".join(lines + ["$EndElements", ""])


TANGLED = mesh_file([(0, 0, 0), (0.1, 0, 0), (0.02, 0.02, 0), (0, 0.1, 0)], [(1, 2, 3, 4)])
FLAT = mesh_file([(0, 0, 0), (0.1, 0, 0), (0.2, 0, 0), (0.3, 0, 0)], [(1, 2, 3, 4)])
GOOD = mesh_file([(0, 0, 0), (0.1, 0, 0), (0.1, 0.1, 0), (0, 0.1, 0)], [(1, 2, 3, 4)])
DISK = "mesh = { disk = { radius = \"200 mm\", element_size = \"40 mm\", quarter = true } }"
FIX = "fix = [{ where = \"rim\", dof = \"all\" }, { where = \"x=0\", dof = \"symmetry\" }, { where = \"y=0\", dof = \"symmetry\" }]"


def with_mesh(mesh):
    return replaced(FIX, "", replaced(DISK, mesh))


def with_load(words):
    return CASE + f"\n[[load]]\npart = \"plate\"\n{words}\n"


SPHERES = replaced("fill = \"air\"", "fill = \"air\"\ncollision = \"hard_spheres\"")
CROWDED = (SOURCE / "share/explosives/tnt_paper.toml").read_text().replace("co_volume = 0.3", "co_volume = 0.9")

CHARGE = CASE[CASE.index("[[charge]]"):CASE.index("[gas]")]
# The same charge in a grid of gases, without the plate.
GRID = CASE[:CASE.index("[gas]")] + """[euler]
box = [[0, 0.6], [0, 0.6], [0, 0.6]]
edges = { x = ["rigid", "open"], y = ["rigid", "open"] }
cell_size = "50 mm"
fill = "air"
"""

# name, case, what standard error must match, further files, further words of the command line
MISTAKES = [
    ("unknown key", replaced("mass = \"1 kg\"", "mas = \"1 kg\""), r"case\.toml:7:1: unknown key 'mas' in 'charge'; did you mean 'mass'"),
    ("a curve whose times do not rise", with_load("pressure = [[0, 1], [0, 2]]"), r"case\.toml:\d+:\d+: the times of 'pressure' do not rise"),
    ("a curve of one number too few", with_load("pressure = [[0]]"), r"case\.toml:\d+:\d+: 'pressure' has a list of 1 here"),
    ("a curve of lengths", with_load("pressure = [[0, \"1 m\"]]"), r"case\.toml:\d+:\d+: pressure: \"1 m\" is a length; expected a pressure"),
    ("a curve without a file", with_load("pressure = { file = \"none.csv\" }"), r"case\.toml:\d+:\d+: there is no curve file '.*none\.csv'"),
    ("a curve file of words", with_load("pressure = { file = \"bad.csv\" }"), r"bad\.csv:3:1: '1, two' is not a time and a value", {"bad.csv": "time, p\n0, 1\n1, two\n"}),
    ("a curve file in lengths", with_load("pressure = { file = \"good.csv\", unit = \"mm\" }"), r"case\.toml:\d+:\d+: \"1 mm\" is a length; expected a pressure", {"good.csv": "0, 1\n1, 2\n"}),
    ("a force without a direction", with_load("force = 3"), r"case\.toml:\d+:1: a force has no direction; expected direction"),
    ("a pressure in a direction", with_load("pressure = 3\ndirection = [0, 0, 1]"), r"case\.toml:\d+:\d+: only a force has a direction"),
    ("a pressure nowhere", with_load("pressure = 3\nwhere = \"rom\""), r"case\.toml:\d+:\d+: the mesh has no set of nodes 'rom'"),
    ("a pressure on an edge", with_load("pressure = 3\nwhere = \"rim\""), r"case\.toml:\d+:1: pressure on rim of plate: no facet of the part has all its nodes there"),
    ("two loads in one", with_load("pressure = 3\nforce = 3"), r"case\.toml:\d+:\d+: .*'pressure'.*'force'|case\.toml:\d+:\d+: .*one of"),
    ("driven and held", replaced(FIX, FIX + "\ndrive = [{ where = \"rim\", dof = \"z\", velocity = 1 }]"), r"case\.toml:\d+:1: part 'plate': the node at .* is driven along z, where it is held"),
    ("a jump at the start", replaced(FIX, FIX + "\ndrive = [{ where = \"all\", dof = \"z\", displacement = 1 }]"), r"case\.toml:\d+:\d+: the displacement is 1 m at time 0"),
    ("a motion of no kind", replaced(FIX, FIX + "\ndrive = [{ where = \"all\", dof = \"z\" }]"), r"case\.toml:\d+:\d+: 'drive' has none of displacement, velocity, acceleration"),
    ("a key of an inner table", replaced("mass = \"1 kg\"", "semi_axes = [1, 1, 1]"), r"case\.toml:7:1: unknown key 'semi_axes' in 'charge'; did you mean shape = { ellipsoid = { semi_axes = \.\.\. } }\?"),
    ("a box without its size", replaced("\"sphere\"", "\"box\""), r"case\.toml:6:9: shape = \"box\" is not enough; expected a table, such as shape = { box = \[\["),
    ("a form nobody knows", replaced("\"sphere\"", "\"spere\""), r"case\.toml:6:9: shape = \"spere\" is not known; did you mean 'sphere'\? expected one of sphere, hemisphere, cylinder"),
    ("a charge of mass and radius", replaced("mass = \"1 kg\"", "mass = \"1 kg\"\nradius = \"5 cm\""), r"case\.toml:8:10: the charge has both a mass and a radius; leave one out"),
    ("a gauge at a point outside", CASE + "\n[[gauge]]\nname = \"g\"\npoint = [5, 5, 5]\n", r"case\.toml:\d+:1: gauge 'g' lies outside the gas box; expected"),
    ("a fill of too much", CASE + "\n[[fill]]\ngas = \"nitrogen\"\nshape = { box = [[0.4, 0.5], [0.4, 0.5], [0.4, 0.5]] }\npressure = \"2 bar\"\ndensity = 3\ntemperature = \"20 degC\"\n", r"case\.toml:\d+:1: the fill has 3 of density.*; expected two of"),
    ("a fill of too little", CASE + "\n[[fill]]\ngas = \"nitrogen\"\nshape = { box = [[0.4, 0.5], [0.4, 0.5], [0.4, 0.5]] }\npressure = \"2 bar\"\n", r"case\.toml:\d+:1: the fill has 1 of density.*; expected two of"),
    ("unknown table", CASE + "\n[gass]\nx = 1\n", r"case\.toml:\d+:\d+: unknown key 'gass'.*did you mean 'gas'"),
    ("two unknown keys at once", replaced("particles =", "particels =", replaced("title =", "titel =")), r"(?s)1:1: unknown key 'titel'.*'particels'.*did you mean 'particles'"),
    ("wrong type", replaced("mass = \"1 kg\"", "mass = [1]"), r"case\.toml:7:8: 'mass' is a list; expected number > 0 in kg"),
    ("wrong type of an integer", replaced("2_000", "\"many\""), r"case\.toml:13:13: 'total' is a text; expected integer"),
    ("a date", replaced("end_time = \"0.2 ms\"", "end_time = 2020-01-01"), r"case\.toml:2:12: 'end_time' is a date or time; expected number > 0 in s"),
    ("wrong unit", replaced("\"1 kg\"", "\"1 mm\""), r"case\.toml:7:8: mass: \"1 mm\" is a length; expected a mass.*\"15 kg\""),
    ("unknown unit", replaced("\"1 kg\"", "\"1 kgg\""), r"case\.toml:7:8: mass: unknown unit 'kgg'.*did you mean 'kg'"),
    ("no unit", replaced("\"1 kg\"", "\"1\""), r"case\.toml:7:8: mass: \"1\" has no unit; expected a mass"),
    ("out of range", replaced("\"1 kg\"", "\"-1 kg\""), r"case\.toml:7:8: mass = \"-1 kg\" is out of range; expected a number > 0 kg"),
    ("not a number", replaced("\"1 kg\"", "nan"), r"case\.toml:7:8: mass = nan is out of range"),
    ("end time 0", replaced("\"0.2 ms\"", "0"), r"case\.toml:2:12: end_time = 0 is out of range; expected a number > 0 s"),
    ("no end time", replaced("end_time = \"0.2 ms\"", ""), r"case\.toml:1:1: the case has no 'end_time'; expected number > 0 in s"),
    ("zero particles", replaced("2_000", "0"), r"case\.toml:13:13: total = 0 is out of range; expected a number 1 to"),
    ("too few particles", replaced("2_000", "1"), r"case\.toml:13:13: the gas '\w+' .* gets no particles; expected more"),
    ("more memory than there is", replaced("2_000", "4_000_000_000"), r"case\.toml:13:13: \d+ particles .* need about .*, this machine has .*; expected at most"),
    ("an ensemble of none", "ensemble = 0\n" + CASE, r"case\.toml:1:12: ensemble = 0 is out of range; expected a number 1 to 10000"),
    ("an ensemble of less than none", "ensemble = -3\n" + CASE, r"case\.toml:1:12: ensemble = -3 is out of range; expected a number 1 to 10000"),
    ("half a run more", "ensemble = 1.5\n" + CASE, r"case\.toml:1:12: 'ensemble' is a number; expected integer 1 to 10000"),
    ("an endless ensemble", "ensemble = 1_000_000\n" + CASE, r"case\.toml:1:12: ensemble = 1000000 is out of range; expected a number 1 to 10000"),
    ("an ensemble in words", "ensemble = \"many\"\n" + CASE, r"case\.toml:1:12: 'ensemble' is a text; expected integer"),
    ("an ensemble without seeds", replaced("fill = \"air\"", "fill = \"air\"\nseed = 9_000_000_000_000_000", "ensemble = 2\n" + CASE), r"case\.toml:1:12: the ensemble runs out of seeds; expected a smaller gas\.seed"),
    ("an ensemble without chance", "ensemble = 2\n" + CASE[:CASE.index("[[charge]]")] + CASE[CASE.index("[[part]]"):], r"case\.toml:1:12: an ensemble without gas .*; expected \[gas\]"),
    ("an ensemble whose gauge is nowhere", "ensemble = 2\n" + CASE + "\n[[gauge]]\nname = \"g\"\nsphere = { center = [5, 5, 5], radius = 0.1 }\nevery = \"1 us\"\n", r"case\.toml:\d+:1: gauge 'g' lies outside the gas box; expected"),
    ("a spherical start of a cylinder", replaced("fill = \"air\"", "fill = \"air\"\nstart = \"spherical\"", replaced("\"sphere\"", "\"cylinder\"")), r"case\.toml:6:9: start = \"spherical\" with a charge that is no sphere; expected shape"),
    ("a spherical start of two charges", replaced("fill = \"air\"", "fill = \"air\"\nstart = \"spherical\"", replaced("[gas]", CHARGE.replace("300 mm", "500 mm") + "[gas]")), r"case\.toml:\d+:9: start = \"spherical\" with 2 charges; expected one"),
    ("a spherical start too near the plate", replaced("fill = \"air\"", "fill = \"air\"\nstart = \"spherical\"", replaced("300 mm", "70 mm")), r"case\.toml:\d+:9: start = .* something the blast will meet is 0\.07 m from .*; expected"),
    ("a start nobody knows", replaced("fill = \"air\"", "fill = \"air\"\nstart = \"conical\""), r"case\.toml:15:9: .*conical.*spherical"),
    ("missing charge", replaced(CHARGE, ""), r"case\.toml:\d+:\d+: there is gas but no \[\[charge\]\].*expected a \[\[charge\]\]"),
    ("charge without gas", CASE[:CASE.index("[gas]")] + CASE[CASE.index("[[part]]"):], r"case\.toml:4:\d+: there is a \[\[charge\]\] but no \[gas\].*; expected"),
    ("charge without mass", replaced("mass = \"1 kg\"\n", ""), r"case\.toml:4:\d+: the charge has a form but neither mass nor radius; expected center and mass or radius"),
    ("charge overlapping the plate", replaced("center = [0, 0, \"300 mm\"]", "center = [0, 0, \"20 mm\"]"), r"case\.toml:8:10: the charge overlaps part 'plate' near .*; move"),
    ("charge outside the box", replaced("center = [0, 0, \"300 mm\"]", "center = [0, 0, \"3000 mm\"]"), r"case\.toml:8:10: the charge, .*, lies outside the gas box; expected"),
    ("charge cut by an edge", replaced("center = [0, 0, \"300 mm\"]", "center = [0, 0, \"590 mm\"]"), r"case\.toml:8:10: the charge sticks .* out of the gas box at z\+; expected"),
    ("unknown explosive", replaced("\"tnt\"", "\"tmt\""), r"case\.toml:5:13: unknown explosive 'tmt'; did you mean 'tnt'.*c4"),
    ("unknown gas", replaced("\"air\"", "\"aire\""), r"case\.toml:14:8: unknown gas 'aire'; did you mean 'air'"),
    ("unknown rule of collision", replaced("fill = \"air\"", "fill = \"air\"\ncollision = \"spheres\""), r"case\.toml:15:13: collision = \"spheres\" is not known; .*hard_spheres"),
    ("hard spheres with a cold pressure", SPHERES, r"case\.toml:5:13: hard spheres have no cold pressure, so 'tnt' .*; expected .*tnt_paper.*displaced"),
    ("hard spheres that fill all space", replaced("\"tnt\"", "\"crowded\"", SPHERES), r"case\.toml:5:13: hard spheres for the co-volume 0\.9 of '\w+' .*; expected a co-volume of at most 0\.748", {"share/explosives/crowded.toml": CROWDED}),
    ("packing beyond what is proved", replaced("fill = \"air\"", "fill = \"air\"\npacking = 0.2"), r"case\.toml:15:11: packing = 0\.2 is out of range; expected a number 0\.0001 to 0\.1"),
    ("unknown material", replaced("\"rha_steel\"", "\"rha_stele\""), r"case\.toml:20:12: unknown material 'rha_stele'; did you mean 'rha_steel'"),
    ("part with no mass", replaced("material = \"rha_steel\"", ""), r"case\.toml:16:\d+: part 'plate' has no material, so it has no mass; expected material"),
    ("no thickness", replaced("\"5 mm\"", "0"), r"case\.toml:19:\d+: thickness = 0 is out of range; expected a number > 0 m"),
    ("mesh with a hole", with_mesh("mesh = { file = \"m.msh\", closed = true }"), r"case\.toml:18:\d+: .*m?plate.*hole|case\.toml:18:\d+: .*open", {"m.msh": GOOD}),
    ("charge of a surface with a hole", replaced("shape = \"sphere\"\nmass = \"1 kg\"\ncenter = [0, 0, \"300 mm\"]", "shape = { surface = \"open.stl\" }"), r"case\.toml:6:\d+: .*(hole|open)", {"open.stl": OPEN_STL}),
    ("tangled element", with_mesh("mesh = { file = \"m.msh\" }"), r"case\.toml:18:\d+: .*tangled", {"m.msh": TANGLED}),
    ("element without area", with_mesh("mesh = { file = \"m.msh\" }"), r"case\.toml:18:\d+: .*(flat|area|collapsed)", {"m.msh": FLAT}),
    ("no such mesh file", with_mesh("mesh = { file = \"none.msh\" }"), r"case\.toml:18:\d+: there is no mesh file .*none\.msh.*; expected"),
    ("no mesh in the file", with_mesh("mesh = { file = \"m.msh\" }"), r"m\.msh.*", {"m.msh": "nothing\n"}),
    ("unknown node set", replaced("where = \"rim\"", "where = \"rmi\""), r"case\.toml:21:\d+: .*rmi.*did you mean 'rim'|case\.toml:21:\d+: .*'rmi'.*rim"),
    ("symmetry without a plane", replaced("where = \"rim\", dof = \"all\"", "where = \"rim\", dof = \"symmetry\""), r"case\.toml:21:\d+: dof = \"symmetry\" needs a plane.*; expected"),
    ("rigid part that is not held", replaced("fix = [{ where = \"all\", dof = \"all\" }]", ""), r"case\.toml:\d+:\d+: .*frame.*; "),
    ("solids of a surface", replaced("element = { shell = { thickness = \"5 mm\" } }", "element = \"solid\""), r"case\.toml:16:\d+: part 'plate': element 1 near .* is a surface element, and the part is solid; mesh the volume"),
    ("shells of solids", replaced("quarter = true } }\nelement = { shell", "quarter = true }, extrude = { height = \"5 mm\", layers = 2 } }\nelement = { shell"), r"case\.toml:16:\d+: part 'plate': element 1 near .* is a solid; shells are made of surface elements"),
    ("no layers", replaced("quarter = true } }\nelement = { shell", "quarter = true }, extrude = { height = \"5 mm\", layers = 0 } }\nelement = { shell"), r"case\.toml:18:\d+: layers = 0 is out of range; expected"),
    ("cloth that bends", replaced("\"rha_steel\"", "\"fabric_nylon\""), r"case\.toml:16:\d+: part 'plate': material 'fabric_nylon' is a fabric, which does not bend; make the part a membrane"),
    ("a curve that falls", replaced("material = \"rha_steel\"", "material = { density = 7850, young_modulus = 2e11, poisson_ratio = 0.3, strength = { curve = { curves = [{ plastic_strain = [0, 0.1], stress = [4e8, 3e8] }] } } }"), r"case\.toml:20:\d+: part 'plate': material .* a stress of a curve is 3.*; give a value not below"),
    ("a curve with half of Cowper and Symonds", replaced("material = \"rha_steel\"", "material = { density = 7850, young_modulus = 2e11, poisson_ratio = 0.3, strength = { curve = { rate_c = 40, curves = [{ plastic_strain = [0], stress = [4e8] }] } } }"), r"case\.toml:20:\d+: material 'unnamed' has rate_c but rate_p = 0; expected rate_p >= 1"),
    ("a curve without all its stresses", replaced("material = \"rha_steel\"", "material = { density = 7850, young_modulus = 2e11, poisson_ratio = 0.3, strength = { curve = { curves = [{ plastic_strain = [0, 0.1], stress = [4e8] }] } } }"), r"case\.toml:20:\d+: .* a curve has 2 plastic strains and 1 stresses; expected one stress"),
    ("erosion at once", replaced("material = \"rha_steel\"", "material = \"rha_steel\"\nerosion = { plastic_strain = 0 }"), r"case\.toml:21:\d+: plastic_strain = 0 is out of range; expected a number > 0"),
    ("a rigid body held by its rim", replaced("element = { shell = { thickness = \"5 mm\" } }", "element = { rigid = { mass = 3 } }"), r"case\.toml:16:\d+: part 'plate': a rigid part that moves has \d+ of its \d+ nodes held along x; hold all"),
    ("two parts of one name", replaced("name = \"frame\"", "name = \"plate\""), r"case\.toml:24:8: a second part is called 'plate'; expected"),
    ("load on no part", CASE + "\n[[load]]\nconwep = { mass = 1, center = [0, 0, 0.3] }\npart = \"plat\"\n", r"case\.toml:\d+:8: there is no part 'plat'; did you mean 'plate'"),
    ("gauge on an open face", CASE + "\n[[gauge]]\nname = \"g\"\nface = \"z+\"\nevery = \"1 us\"\n", r"case\.toml:\d+:8: gauge 'g' is on a face .* not rigid; expected"),
    ("box upside down", replaced("[\"-100 mm\", \"600 mm\"]", "[\"600 mm\", \"-100 mm\"]"), r"case\.toml:11:7: the gas box runs from .* along z; expected the lower end first"),
    ("two values for one key", replaced("title = \"a small plate\"", "title = \"a\"\ntitle = \"b\""), r"case\.toml:2:\d+: .*redefine.*'title'"),
    ("no TOML", replaced("mass = \"1 kg\"", "mass = 1 kg"), r"case\.toml:7:\d+: .*; expected TOML"),
    ("an LS-DYNA deck", "*KEYWORD\n*END\n", r"case\.toml:1:1: this is an LS-DYNA keyword deck.*; expected a case in TOML"),
    ("an empty case", "", r"the case has no 'end_time'"),
    ("wrong --set", CASE, r"--set charge\.0\.mas: unknown key 'mas' in 'charge'; did you mean 'mass'", {}, ["--set", "charge.0.mas=2 kg"]),
    ("--set out of range", CASE, r"--set end_time: end_time = -1 is out of range; expected a number > 0 s", {}, ["--set", "end_time=-1"]),
    ("--set without a value", CASE, r"--set end_time has no key and value; expected key=value", {}, ["--set", "end_time"]),
    ("particles in a grid", GRID + "particles = 2_000\n", r"case\.toml:\d+:1: unknown key 'particles' in 'euler'; known: symmetry, box"),
    ("a grid beside particles", CASE + GRID[GRID.index("[euler]"):], r"case\.toml:\d+:1: there are both \[gas\] and \[euler\].*; expected one of them"),
    ("a part in a grid of rings", replaced("[euler]", "[euler]\nsymmetry = \"axisymmetric\"", GRID) + CASE[CASE.index("[[part]]"):],
     r"case\.toml:\d+:1: part 'plate' stands beside \[euler\] with a symmetry.*; expected \[euler\] without symmetry"),
    ("a grid's box without z", replaced("[[0, 0.6], [0, 0.6], [0, 0.6]]", "[[0, 0.6], [0, 0.6]]", GRID), r"case\.toml:11:7: the box of \[euler\] has 2 ranges, its symmetry leaves 3; expected \[\[x_min"),
    ("a grid of too few cells", replaced("\"50 mm\"", "\"200 mm\"", GRID), r"case\.toml:13:13: 3 cells along x: too few.*; expected 4 or more"),
    ("a grid of too many cells", replaced("\"50 mm\"", "\"0.2 mm\"", GRID), r"case\.toml:13:13: .* cells and 0 elements need about .*expected|more than 4e9 cells"),
    ("a fine part without the edges' cells", replaced("cell_size", "fine_box = [[0, 0.3], [0, 0.3], [0, 0.3]]\ncell_size", GRID), r"case\.toml:\d+:12: fine_box, cell_size and edge_cell_size go together; expected all three"),
    ("a fine part out of the box", replaced("cell_size", "fine_box = [[0, 0.3], [0, 0.3], [0, 0.9]]\nedge_cell_size = 0.1\ncell_size", GRID), r"case\.toml:\d+:12: fine_box runs from 0 m to 0\.9 m along z, out of the box; expected it within 0 m and 0\.6 m"),
    ("cells and their size", replaced("cell_size", "cells = [9, 9, 9]\ncell_size", GRID), r"case\.toml:10:1: 'euler' has cell_size and cells at once; expected exactly one"),
    ("a grid with an ensemble", "ensemble = 2\n" + GRID, r"case\.toml:1:12: an ensemble without gas of particles.*; expected \[gas\]"),
    ("a charge off the axis", replaced("[[0, 0.6], [0, 0.6], [0, 0.6]]", "[[0, 0.6], [0, 0.6]]", replaced("box =", "symmetry = \"axisymmetric\"\nbox =", replaced(", y = [\"rigid\", \"open\"]", "", replaced("[0, 0, \"300 mm\"]", "[0.1, 0, 0.3]", GRID)))), r"case\.toml:8:10: the charge is not symmetric about the z axis.*; expected a sphere"),
    ("an unknown symmetry", replaced("box =", "symmetry = \"round\"\nbox =", GRID), r"case\.toml:\d+:12: .*symmetry.*expected"),
    ("a gauge on the grid's open face", GRID + "[[gauge]]\nname = \"g\"\nface = \"x+\"\nevery = \"1 us\"\n", r"case\.toml:\d+:8: gauge 'g' is on a face .* not rigid; expected"),
    ("a grid with a hole", GRID.replace("fill = \"air\"\n", "") + "[[fill]]\ngas = \"air\"\nshape = { sphere = { center = [0, 0, 0.3], radius = 0.3 } }\ndensity = 1.2\npressure = 1e5\n", r"case\.toml:10:1: nothing fills the Euler grid near .*fill the whole grid"),
    ("unknown option", CASE, r"--fast", {}, ["--fast"]),
]


def try_mistake(name, case, pattern, files=None, words=()):
    """Runs the case; gives what is not as it must be."""
    folder = fresh_folder({"case.toml": case, **(files or {})})
    before = contents(folder)
    code, out, error = execute(folder, "run", "case.toml", "--out", "results/bad", *words)
    wrong = []
    if code != 2:
        wrong.append(f"exit code {code}")
    if not re.search(pattern, error):
        wrong.append(f"standard error does not match {pattern}")
    if re.match(r"case\.toml:\d+:\d+:", error) and not re.search(r"\n +\S.*\n +\^\n", error) and case:
        wrong.append("no line of the file with a mark")
    if contents(folder) != before:
        wrong.append(f"left behind {sorted(contents(folder).keys() - before.keys())}")
    shutil.rmtree(folder)
    return [f"{name}: {what}\n    {error.strip()}\n    {out.strip()}" for what in wrong]


def try_folders():
    """Results that exist are not touched, and folders that cannot be made are refused before anything runs."""
    wrong = []
    folder = fresh_folder({"case.toml": CASE, "old/history.csv": "time [s]\n", "old/summary.json": "{}\n", "file": "x"})
    before = contents(folder)
    for out, pattern in [("old", r"old.*--force"), ("file/results", r"file/results|file"), ("/proc/corpuscle", r"/proc/corpuscle")]:
        code, _, error = execute(folder, "run", "case.toml", "--out", out)
        if code != 2 or not re.search(pattern, error):
            wrong.append(f"--out {out}: exit code {code}: {error}")
    if contents(folder) != before:
        wrong.append("old results were changed")
    for words, pattern in [(["run", "none.toml"], r"none\.toml.*cannot be read"), (["run", "."], r"is a folder"), (["resume", "old"], r"holds no run"), (["report", "none"], r"none"), (["run"], r"case")]:
        code, _, error = execute(folder, *words)
        if code != 2 or not re.search(pattern, error):
            wrong.append(f"{words}: exit code {code}: {error}")
    shutil.rmtree(folder)
    return wrong


def main():
    wrong = [what for mistake in MISTAKES for what in try_mistake(*mistake)] + try_folders()
    for what in wrong:
        print(what)
    print(f"{len(MISTAKES)} mistakes tried, {len(wrong)} answered badly")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
