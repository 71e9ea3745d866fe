"""Writes room.stl: the walls, floor and ceiling of a room of 2 m x 2 m x 2 m with a doorway in the wall x = 2 m, as solids "walls" and, for gauges, one
panel of 0.4 m in the middle of the wall y = 0 ("side") and one in a corner of the wall x = 0 ("corner"). Lengths in m.  python3 make_room.py > room.stl"""

CELL, CELLS = 0.2, 10
DOOR_Y, DOOR_Z = range(3, 7), range(0, 8)  # cells of the doorway: 0.8 m wide, 1.6 m high


def square(axis, side, i, j):
    """Corners of a cell of the wall across an axis at one of its sides, seen from within the room counterclockwise."""
    u, v = (axis + 1) % 3, (axis + 2) % 3
    corners = []
    for a, b in [(0, 0), (1, 0), (1, 1), (0, 1)]:
        point = [0.0, 0.0, 0.0]
        point[axis], point[u], point[v] = side * CELL * CELLS, (i + a) * CELL, (j + b) * CELL
        corners.append(tuple(round(x, 6) for x in point))
    return corners if side == 0 else corners[::-1]


def name_of(axis, side, i, j):
    """The solid that a cell belongs to; none in the doorway. For axis 0 i counts along y and j along z, for axis 1 along z and x."""
    if (axis, side) == (0, 1) and i in DOOR_Y and j in DOOR_Z:
        return None
    if (axis, side) == (1, 0) and i in (4, 5) and j in (4, 5):
        return "side"
    return "corner" if (axis, side) == (0, 0) and i < 2 and j < 2 else "walls"


def main():
    solids = {"walls": [], "side": [], "corner": []}
    for axis in range(3):
        for side in range(2):
            for i in range(CELLS):
                for j in range(CELLS):
                    if (name := name_of(axis, side, i, j)) is not None:
                        solids[name].append(square(axis, side, i, j))
    for name, squares in solids.items():
        print(f"solid {name}")
        for a, b, c, d in squares:
            for triangle in [(a, b, c), (a, c, d)]:
                print("facet normal 0 0 0\nouter loop")
                for x, y, z in triangle:
                    print(f"vertex {x:g} {y:g} {z:g}")
                print("endloop\nendfacet")
        print(f"endsolid {name}")


if __name__ == "__main__":
    main()
