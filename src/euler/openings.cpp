#include <algorithm>
#include <cmath>

#include "euler/cut.hpp"

namespace corpuscle {

namespace {

using Spot = std::array<std::size_t, 3>;

/// Finds openings square by square: a square has the middles of four cells that share an edge for corners. Along axis `across` (d) and
/// `along` (t) the wall crosses some of its four sides; between the crossings it is taken for straight, and the square for the section of
/// all that lies beside it.
class Openings {
public:
    explicit Openings(EulerGrid& grid) : grid_(grid), walls_(grid.walls) {}

    void find()
    {
        walls_.corners.clear();
        for (std::size_t n = 0; n < walls_.faces.size(); ++n) {
            const WallFace& face = walls_.faces[n];
            if (face.lower == no_cell || face.upper == no_cell) continue;
            for (int d = 0; d < 3; ++d) {
                if (d != face.near_lower.axis && !axis(d).inert()) visit_squares(static_cast<std::int32_t>(n), d);
            }
        }
    }

private:
    /// A side of a square: the shut face that lies across it, -1 if it is open.
    struct Square {
        int d = 0, t = 0, u = 0;
        Spot base{};                         ///< the cell at its lower corner
        double breadth = 1;                  ///< of the cells along the third axis [m]
        std::array<std::int32_t, 2> rise{};  ///< sides along t: at the lower and the upper d
        std::array<std::int32_t, 2> run{};   ///< sides along d: at the lower and the upper t
    };

    [[nodiscard]] const EulerAxis& axis(int d) const { return grid_.axes[static_cast<std::size_t>(d)]; }
    [[nodiscard]] static Spot moved(Spot place, int d, std::size_t by)
    {
        place[static_cast<std::size_t>(d)] += by;
        return place;
    }
    /// The shut face above a cell along an axis.
    [[nodiscard]] std::int32_t above(const Spot& cell, int d) const
    {
        return walls_.shut[static_cast<std::size_t>(d)][grid_.face_number(d, moved(cell, d, 1))];
    }
    [[nodiscard]] WallFace& wall(std::int32_t number) { return walls_.faces[static_cast<std::size_t>(number)]; }

    /// The squares on both sides, along d, of the line that a shut face cuts. Each square is worked out once: from its first shut side.
    void visit_squares(std::int32_t number, int d)
    {
        const WallFace& face = wall(number);
        const int t = face.near_lower.axis;
        Spot cell = face.place;
        --cell[static_cast<std::size_t>(t)];
        const std::size_t at = cell[static_cast<std::size_t>(d)];
        for (const std::size_t side : {0u, 1u}) {
            if (side == 0 ? at == 0 : at + 1 == axis(d).cells()) {
                open_edge(number, cell, d, side);
                continue;
            }
            const Square square = square_at(side == 0 ? back(cell, d) : cell, std::min(d, t), std::max(d, t));
            if (first_of(square) == number) shape(square);
        }
    }
    [[nodiscard]] static Spot back(Spot place, int d)
    {
        --place[static_cast<std::size_t>(d)];
        return place;
    }
    [[nodiscard]] Square square_at(const Spot& base, int d, int t) const
    {
        const int u = 3 - d - t;
        return {d,
                t,
                u,
                base,
                axis(u).width(base[static_cast<std::size_t>(u)]),
                {above(base, t), above(moved(base, d, 1), t)},
                {above(base, d), above(moved(base, t, 1), d)}};
    }
    [[nodiscard]] static std::int32_t first_of(const Square& square)
    {
        for (const std::int32_t n : {square.rise[0], square.rise[1], square.run[0], square.run[1]}) {
            if (n >= 0) return n;
        }
        return -1;
    }

    /// A length along the line of a shut face as it counts for areas across axis d: in part of what the wall's normal leans to the line
    /// and not to the third axis.
    [[nodiscard]] double blended(const WallFace& face, int d, double length) const
    {
        const int t = face.near_lower.axis, u = 3 - d - t;
        if (axis(u).inert()) return length;
        const double own = face.normal[t] * face.normal[t], other = face.normal[u] * face.normal[u];
        return length * own / (own + other);
    }

    void widen(int d, const Spot& above_face, double area)
    {
        const std::size_t number = grid_.face_number(d, above_face);
        const auto axis_number = static_cast<std::size_t>(d);
        if (walls_.shut[axis_number][number] >= 0) {
            walls_.faces[static_cast<std::size_t>(walls_.shut[axis_number][number])].area[d] += area;
            return;
        }
        double whole = 1;
        for (int e = 0; e < 3; ++e) {
            if (e != d) whole *= axis(e).width(above_face[static_cast<std::size_t>(e)]);
        }
        walls_.open[axis_number][number] += area / whole;
        walls_.widened.push_back({axis_number, number});
    }

    /// At an edge of the grid the edge's own face grows or shrinks: the wall goes on as in a mirror beyond a rigid edge, straight on beyond
    /// an open one.
    void open_edge(std::int32_t number, const Spot& cell, int d, std::size_t side)
    {
        WallFace& face = wall(number);
        const int t = face.near_lower.axis;
        const double breadth = axis(3 - d - t).width(cell[static_cast<std::size_t>(3 - d - t)]), sign = side == 0 ? -1 : 1;
        const double own = breadth * blended(face, d, face.shift);
        double there = own;
        if (grid_.edges[2 * static_cast<std::size_t>(d) + side] == EulerEdge::open)
            there = breadth * blended(face, d, going_on(face, cell, d, sign).shift);
        face.area[d] += sign * (own - there);
        const Spot edge = moved(cell, d, side);
        widen(d, edge, there);
        widen(d, moved(edge, t, 1), -there);
    }

    /// A wall that goes straight on towards the cell's lower (sign -1) or upper end along d: how far from the shut face it comes there, or
    /// to the cells' own middles at most [m], and on what part of the way that is.
    struct GoingOn {
        double shift = 0, part = 1;
    };
    [[nodiscard]] GoingOn going_on(const WallFace& face, const Spot& cell, int d, double sign) const
    {
        const int t = face.near_lower.axis;
        const double half = 0.5 * axis(t).width(cell[static_cast<std::size_t>(t)]);
        const double rise = -0.5 * sign * axis(d).width(cell[static_cast<std::size_t>(d)]) * face.normal[d] / face.normal[t];
        const double end = std::clamp(face.shift + rise, -half, half);
        return {end, end == face.shift + rise ? 1 : std::clamp((end - face.shift) / rise, 0.0, 1.0)};
    }

    void shape(const Square& square)
    {
        const auto shut = [](std::int32_t n) { return n >= 0 ? 1 : 0; };
        const int rises = shut(square.rise[0]) + shut(square.rise[1]), runs = shut(square.run[0]) + shut(square.run[1]);
        if (rises == 2 && runs == 0) return pass_through(square, square.d, square.t, square.rise);
        if (rises == 0 && runs == 2) return pass_through(square, square.t, square.d, square.run);
        if (rises == 1 && runs == 1) return turn_corner(square);
        if (rises == 1 && runs == 0) return end_within(square, square.d, square.t, square.rise);
        if (rises == 0 && runs == 1) return end_within(square, square.t, square.d, square.run);
        for (const std::size_t side : {0u, 1u}) {
            if (square.rise[side] >= 0) end_at(square, square.d, square.rise[side], side);
            if (square.run[side] >= 0) end_at(square, square.t, square.run[side], side);
        }
    }

    /// The wall crosses both sides along t: the faces across d on its two sides are open up to it.
    void pass_through(const Square& square, int d, int t, const std::array<std::int32_t, 2>& sides)
    {
        const double first = square.breadth * blended(wall(sides[0]), d, wall(sides[0]).shift);
        const double second = square.breadth * blended(wall(sides[1]), d, wall(sides[1]).shift);
        const Spot face = moved(square.base, d, 1);
        widen(d, face, 0.5 * (first + second));
        widen(d, moved(face, t, 1), -0.5 * (first + second));
        for (const std::int32_t n : sides) wall(n).area[d] += 0.5 * (first - second);
    }

    /// The wall crosses one side and ends: up to the square's middle it goes straight on and the faces across d are open up to it. What
    /// that leaves of the two cells beyond, which no wall parts, they exchange across d; and if it comes to the cells' middles before, its
    /// own two cells exchange across t what it leaves. So no step stands up at a rim.
    void end_within(const Square& square, int d, int t, const std::array<std::int32_t, 2>& sides)
    {
        const std::size_t side = sides[0] >= 0 ? 0 : 1;
        WallFace& face = wall(sides[side]);
        const Spot own = moved(square.base, d, side), lower = moved(square.base, d, 1 - side), middle = moved(square.base, d, 1);
        const double sign = side == 0 ? 1 : -1;
        const GoingOn on = going_on(face, own, d, sign);
        const double there = square.breadth * blended(face, d, on.shift);
        const double left = 0.5 * square.breadth * blended(face, d, axis(d).width(own[static_cast<std::size_t>(d)])) * (1 - on.part);
        face.area[d] += sign * (square.breadth * blended(face, d, face.shift) - there);
        face.area[t] -= left;
        widen(d, middle, there);
        widen(d, moved(middle, t, 1), -there);
        exchange(lower, moved(lower, t, 1), d, sign * there);
        exchange(own, moved(own, t, 1), t, left);
    }
    void exchange(const Spot& from, const Spot& to, int axis, double size)
    {
        if (size == 0) return;
        Vector3d area;
        area[axis] = size;
        walls_.corners.push_back({grid_.cell(from[0], from[1], from[2]), grid_.cell(to[0], to[1], to[2]), area});
    }

    /// More than one wall is in the square: each line's areas are closed by its own wall.
    void end_at(const Square& square, int d, std::int32_t number, std::size_t side)
    {
        WallFace& face = wall(number);
        face.area[d] += (side == 0 ? 1 : -1) * square.breadth * blended(face, d, face.shift);
    }

    /// The wall cuts off one corner: the two cells beside it touch each other across the line from the square's middle to the wall's.
    void turn_corner(const Square& square)
    {
        const std::size_t ahead = square.rise[0] >= 0 ? 0 : 1, up = square.run[0] >= 0 ? 0 : 1;  // the lone cell's place along d and t
        const double sign_d = ahead == 1 ? 1 : -1, sign_t = up == 1 ? 1 : -1;
        WallFace& rise = wall(square.rise[ahead]);
        WallFace& run = wall(square.run[up]);
        const int d = square.d, t = square.t;
        const double over_d = square.breadth * blended(rise, d, sign_t * rise.shift),
                     over_t = square.breadth * blended(run, t, sign_d * run.shift);
        const double corner_d = 0.5 * square.breadth * blended(rise, d, length_to(rise, up)),
                     corner_t = 0.5 * square.breadth * blended(run, t, length_to(run, ahead));
        rise.area[d] += sign_t * sign_d * (corner_d - over_d);
        rise.area[t] -= corner_t;
        run.area[d] -= corner_d;
        run.area[t] += sign_t * sign_d * (corner_t - over_t);
        Vector3d area;
        area[d] = sign_d * corner_d;
        area[t] = -sign_t * corner_t;
        const Spot beside = moved(moved(square.base, d, 1 - ahead), t, up), below = moved(moved(square.base, d, ahead), t, 1 - up);
        walls_.corners.push_back({grid_.cell(beside[0], beside[1], beside[2]), grid_.cell(below[0], below[1], below[2]), area});
    }
    /// From the middle of the cell that is not cut off to the wall: the lone cell is the upper one where `upper` is 1.
    [[nodiscard]] static double length_to(const WallFace& face, std::size_t upper)
    {
        return upper == 1 ? face.lower_length : face.upper_length;
    }

    EulerGrid& grid_;
    EulerWalls& walls_;
};

}  // namespace

void shape_openings(EulerGrid& grid)
{
    Openings(grid).find();
}

}  // namespace corpuscle
