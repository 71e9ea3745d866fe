#include "structure/elements/triangle_shells.hpp"

#include <cmath>

#include "structure/elements/solids.hpp"

namespace corpuscle {

namespace {

/// What an element keeps besides what all shells do, by slot.
enum TriangleSlot : int {
    slot_circulation = 6,  ///< elastic force against the shear round the edges [N]
    slot_drill = 7,        ///< elastic moment against the corners' mean turning about the normal [N m]
    slot_edge = 8,         ///< as meshed: 1 over the first edge's length, then the third corner's place along it and 1 over its height
    slot_loads = 11,       ///< forces on corners 2 and 3, moments on all, global axes
    slot_points = 26,
};

using Vector = Vector3<Lanes>;

}  // namespace

/// Axes of a triangle and its shape in them: edges e[0] from corner 1 to 2, e[1] from 2 to 3, e[2] from 3 to 1; gradients of the shape
/// functions of its corners.
struct TriangleShells::Frame {
    Vector first, second, normal;
    Lanes ex[3], ey[3];  ///< [m]
    Lanes bx[3], by[3];  ///< [1/m]
    Lanes area;          ///< [m2]

    [[nodiscard]] Vector to_local(const Vector& v) const { return {dot(v, first), dot(v, second), dot(v, normal)}; }
    [[nodiscard]] Vector to_global(const Vector& v) const { return first * v.x + second * v.y + normal * v.z; }

    /// Share of an edge's shear that the shear at the middle takes: edges 1 and 3 less a third of what runs round.
    struct Shear {
        Lanes zx, yz, circulation;
    };
    /// Transverse shear of local motion and rotation of the corners.
    [[nodiscard]] Shear shear_of(const Corners& move, const Corners& turn) const
    {
        Lanes g[3];
        for (int k = 0; k < 3; ++k) {
            const Vector &a = turn[k], &b = turn[(k + 1) % 3];
            g[k] = move[(k + 1) % 3].z - move[k].z + 0.5 * ((a.y + b.y) * ex[k] - (a.x + b.x) * ey[k]);
        }
        const Lanes round = g[0] + g[1] + g[2], third = round * (1.0 / 3.0);
        const Lanes along = g[0] - third, back = third - g[2];
        return {bx[1] * along + bx[2] * back, by[1] * along + by[2] * back, round};
    }
    /// Corners' mean turning about the normal beyond the plane's spin, of local motion and rotation. [rad]
    [[nodiscard]] Lanes drill_of(const Corners& move, const Corners& turn) const
    {
        Lanes sum = (turn[0].z + turn[1].z + turn[2].z) * (1.0 / 3.0);
        for (int i = 0; i < 3; ++i) sum = sum - 0.5 * (bx[i] * move[i].y - by[i] * move[i].x);
        return sum;
    }
    /// Sum of the squares of the middle's shear by each rotation. [1]
    [[nodiscard]] Lanes turn_squares() const
    {
        Lanes sum = 0.0;
        for (int corner = 0; corner < 3; ++corner) {
            for (int axis = 0; axis < 2; ++axis) {
                Corners still, turn;
                for (Vector& v : still) v = {0.0, 0.0, 0.0};
                turn = still;
                turn[corner][axis] = 1.0;
                const Shear s = shear_of(still, turn);
                sum = sum + s.zx * s.zx + s.yz * s.yz;
            }
        }
        return sum;
    }
    [[nodiscard]] GradientSum<Lanes> gradients() const
    {
        GradientSum<Lanes> g{0.0, 0.0, 0.0};
        for (int i = 0; i < 3; ++i) {
            g.xx = g.xx + bx[i] * bx[i];
            g.yy = g.yy + by[i] * by[i];
            g.xy = g.xy + bx[i] * by[i];
        }
        return g;
    }
    /// Squares of what the shear round the edges gets from each rotation. [m2]
    [[nodiscard]] Lanes circulation_squares() const
    {
        Lanes sum = 0.0;
        for (int k = 0; k < 3; ++k) {
            const Lanes x = ex[k] + ex[(k + 2) % 3], y = ey[k] + ey[(k + 2) % 3];
            sum = sum + 0.25 * (x * x + y * y);
        }
        return sum;
    }
};

TriangleShells::TriangleShells(ShellInput<3> input, const Material& material, const Nodes& nodes)
    : ShellElements(input, material, slot_points)
{
    fill_blocks(input.thickness);
    for (std::size_t b = 0; b < blocks_.block_count(); ++b) {
        Lanes* own = blocks_.block(b);
        const Corners place = gather(nodes.reference, corners_of_block(b));
        const Vector edge = place[1] - place[0], other = place[2] - place[0], across = cross(edge, other);
        const Lanes length = square_root(dot(edge, edge)), twice_area = square_root(dot(across, across));
        store_slot(own, slot_edge, 1.0 / length);
        store_slot(own, slot_edge + 1, dot(edge, other) / length);
        store_slot(own, slot_edge + 2, length / twice_area);
        const Lanes thickness = load_lanes(&input.thickness[b * lane_count]);
        store_slot(own, slot_thickness, thickness);
        const Frame f = frame_of(place, own);
        store_slot(own, slot_mass, section_.density * f.area * thickness);
        store_slot(own, slot_gyration, gyration(f, thickness));
        blocks_.set_transit(b, allowed_step(f, own));
    }
    blocks_.review();
}

/// The axes: first edge and normal, turned in the plane so that the deformation since meshing is free of rotation in them.
TriangleShells::Frame TriangleShells::frame_of(const Corners& place, const Lanes* own) const
{
    Frame f;
    const Vector edge = place[1] - place[0], other = place[2] - place[0], across = cross(edge, other);
    const Lanes length = square_root(dot(edge, edge)), twice_area = square_root(dot(across, across));
    f.normal = across * (1.0 / twice_area);
    f.area = 0.5 * twice_area;
    const Vector along = edge * (1.0 / length), aside = cross(f.normal, along);
    const Lanes meshed = load_slot(own, slot_edge), shift = load_slot(own, slot_edge + 1), height = load_slot(own, slot_edge + 2);
    const Lanes xx = length * meshed, yy = twice_area / length * height, xy = (dot(other, along) - xx * shift) * height;
    const Lanes scale = 1.0 / square_root((xx + yy) * (xx + yy) + xy * xy), cosine = (xx + yy) * scale, sine = -xy * scale;
    f.first = along * cosine + aside * sine;
    f.second = cross(f.normal, f.first);
    for (int k = 0; k < 3; ++k) {
        const Vector e = place[(k + 1) % 3] - place[k];
        f.ex[k] = dot(e, f.first);
        f.ey[k] = dot(e, f.second);
    }
    const Lanes inverse = 1.0 / twice_area;
    for (int i = 0; i < 3; ++i) {
        f.bx[i] = -f.ey[(i + 1) % 3] * inverse;
        f.by[i] = f.ex[(i + 1) % 3] * inverse;
    }
    return f;
}

std::size_t TriangleShells::resist(const Nodes& nodes, double duration, std::span<CornerLoad> loads)
{
    for_each_block([&](const auto& law, std::size_t b) { resist_block(law, nodes, duration, b, loads); });
    return blocks_.review();
}

/// The step of one block: motion to strain in the axes of the middle of the step, strain to stress, stress to loads in the axes of its end.
template <class Law>
void TriangleShells::resist_block(const Law& law, const Nodes& nodes, double duration, std::size_t b, std::span<CornerLoad> loads)
{
    if (blocks_.gone(b)) return;
    const auto* corners = corners_of_block(b);
    Lanes* own = blocks_.block(b);
    const Corners end = gather_left(blocks_, b, nodes.position, nodes.reference, corners);
    const Corners move = gather_way(blocks_, b, nodes.velocity, duration, corners);
    const Corners turn = gather_way(blocks_, b, nodes.angular_velocity, duration, corners);
    const Frame middle = frame_of(halfway(end, move), own);
    Corners u, r;
    for (int i = 0; i < 3; ++i) {
        u[i] = middle.to_local(move[i]);
        r[i] = middle.to_local(turn[i]);
    }
    ShellStrain<Lanes> e{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    for (int i = 0; i < 3; ++i) {
        const Lanes &bx = middle.bx[i], &by = middle.by[i];
        e.xx = e.xx + bx * u[i].x;
        e.yy = e.yy + by * u[i].y;
        e.xy = e.xy + by * u[i].x + bx * u[i].y;
        e.bend_xx = e.bend_xx + bx * r[i].y;
        e.bend_yy = e.bend_yy - by * r[i].x;
        e.bend_xy = e.bend_xy + by * r[i].y - bx * r[i].x;
    }
    const auto shear = middle.shear_of(u, r);
    e.zx = shear.zx;
    e.yz = shear.yz;
    const ShellResultant<Lanes> n = section_.stretch(law, e, middle.area, duration, own);
    const Lanes round = resist_unseen(circulation_stiffness(own), shear.circulation, slot_circulation, own);
    const Lanes drill = resist_unseen(drill_stiffness(middle, own), middle.drill_of(u, r), slot_drill, own);

    const Frame f = frame_of(end, own);
    Corners force, moment;
    for (int i = 0; i < 3; ++i) {
        const Lanes bx = f.bx[i] * f.area, by = f.by[i] * f.area;
        force[i] = {bx * n.xx + by * n.xy + 0.5 * drill * f.by[i], by * n.yy + bx * n.xy - 0.5 * drill * f.bx[i], 0.0};
        moment[i] = {-by * n.bend_yy - bx * n.bend_xy, bx * n.bend_xx + by * n.bend_xy, drill * (1.0 / 3.0)};
    }
    // loads on the three edges' shear: the transpose of Frame::shear_of
    const Lanes along = (n.zx * f.bx[1] + n.yz * f.by[1]) * f.area, back = (n.zx * f.bx[2] + n.yz * f.by[2]) * f.area;
    const Lanes common = round + (back - along) * (1.0 / 3.0);
    const Lanes edges[3] = {along + common, common, common - back};
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        force[next].z = force[next].z + edges[k];
        force[k].z = force[k].z - edges[k];
        const Vector half{-0.5 * edges[k] * f.ey[k], 0.5 * edges[k] * f.ex[k], 0.0};
        moment[k] += half;
        moment[next] += half;
    }
    for (int i = 0; i < 3; ++i) {
        force[i] = f.to_global(force[i]);
        moment[i] = f.to_global(moment[i]);
    }
    const Vector way[] = {move[1] - move[0], move[2] - move[0]};
    const Lanes total =
        load_slot(own, slot_work) + exchange_work<5>(own, slot_loads, {&force[1], &force[2], &moment[0], &moment[1], &moment[2]},
                                                     {&way[0], &way[1], &turn[0], &turn[1], &turn[2]});
    store_slot(own, slot_work, total);
    write_loads<3>(blocks_, b, force, &moment, loads.data());
    blocks_.set_transit(b, allowed_step(f, own) + 0.0 * total);  // not a number if either is not
}

/// Of the force against the shear that runs round the edges. [N/m]
Lanes TriangleShells::circulation_stiffness(const Lanes* own) const
{
    return hourglass_.shear * section_.shear_factor * section_.stiffness.shear() * (1.0 / 3.0) * load_slot(own, slot_thickness);
}

/// Of the moment against the corners' mean turning about the normal; membranes have none. [N m]
Lanes TriangleShells::drill_stiffness(const Frame& f, const Lanes* own) const
{
    if (is_membrane()) return 0.0;
    return hourglass_.drill * section_.stiffness.shear() * f.area * load_slot(own, slot_thickness);
}

/// Elastic load that remembers, in `slot`, against a change that the strain does not see; counts its work.
Lanes TriangleShells::resist_unseen(const Lanes& stiffness, const Lanes& change, int slot, Lanes* own) const
{
    const Lanes before = load_slot(own, slot), rise = stiffness * change;
    store_slot(own, slot, before + rise);
    store_slot(own, slot_hourglass_work, load_slot(own, slot_hourglass_work) + (before + 0.5 * rise) * change);
    return before + rise;
}

/// Smallest rotary inertia over mass with which transverse shear is no faster than plate waves. [m2]
Lanes TriangleShells::gyration(const Frame& f, const Lanes& thickness) const
{
    const Lanes plain = thickness * thickness * (1.0 / 12.0);
    if (is_membrane()) return plain;
    const GradientSum<Lanes> g = f.gradients();
    const double ratio = section_.stiffness.plane() / (section_.shear_factor * section_.stiffness.shear());
    const Lanes room = ratio * membrane_eigenvalue(g, section_.stiffness.poisson()) - largest_gradient(g);
    const Lanes turns = f.turn_squares() + hourglass_.shear * (1.0 / 3.0) * f.circulation_squares() / f.area;
    return larger(plain, turns / room);
}

/// 2 / (a bound of the highest frequency): of plate waves, of bending where the thickness has grown, of transverse shear. [s]
Lanes TriangleShells::allowed_step(const Frame& f, const Lanes* own) const
{
    const Lanes thickness = load_slot(own, slot_thickness), gyration_now = load_slot(own, slot_gyration);
    const GradientSum<Lanes> g = f.gradients();
    const Lanes bending = larger(thickness * thickness / (12.0 * gyration_now), Lanes(1.0));
    const Lanes plate = 3.0 * section_.stiffness.plane() * membrane_eigenvalue(g, section_.stiffness.poisson()) * bending;
    const Lanes turns = f.turn_squares() + hourglass_.shear * (1.0 / 3.0) * f.circulation_squares() / f.area;
    const Lanes shear = 3.0 * section_.shear_factor * section_.stiffness.shear() * (largest_gradient(g) + turns / gyration_now);
    return 2.0 * square_root(load_slot(own, slot_mass) / (f.area * thickness * larger(plate, shear)));
}

}  // namespace corpuscle
