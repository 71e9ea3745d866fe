#include "structure/elements/tetrahedra.hpp"

#include <algorithm>
#include <cmath>

#include "parallel/loops.hpp"
#include "structure/elements/point_values.hpp"

namespace corpuscle {

namespace {

/// What an element keeps besides what all solids do, by slot.
enum TetrahedronSlot : int {
    slot_loads = 3,  ///< forces on corners 2 to 4; that on the first is opposite to their sum
    slot_point = 12,
};

using Corners = LaneCorners<4>;
using Vector = Vector3<Lanes>;

/// Gradients of the shape functions of corners 2 to 4 times the volume, and the volume.
struct TetGradient {
    explicit TetGradient(const Corners& c)
    {
        const Vector a = c[1] - c[0], b = c[2] - c[0], d = c[3] - c[0];
        const Lanes sixth = 1.0 / 6.0;
        area = {cross(b, d) * sixth, cross(d, a) * sixth, cross(a, b) * sixth};
        volume = dot(a, area[0]);
    }
    [[nodiscard]] Gradient3<Lanes> of(const Corners& u) const
    {
        const Lanes inverse = 1.0 / volume;
        Gradient3<Lanes> g{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
        for (int i = 0; i < 3; ++i) g.add(u[i + 1] - u[0], area[i] * inverse);
        return g;
    }
    std::array<Vector, 3> area;  ///< [m2]
    Lanes volume;                ///< [m3]
};

}  // namespace

Tetrahedra::Tetrahedra(const SolidInput<4>& input, const Material& material, const Nodes& nodes)
    : SolidElements(input, material, slot_point + slots_of_point(material.strength, solid_slots))
{
    connect();
    for (std::size_t b = 0; b < blocks_.block_count(); ++b) {
        const Corners place = gather(nodes.reference, corners_of_block(b));
        const Lanes mass = material_.density * TetGradient(place).volume;
        store_slot(blocks_.block(b), slot_mass, mass);
        std::visit(
            [&](const auto& law) {
                const SolidPoint<Lanes> point;
                store_point(law, point, blocks_.block(b), slot_point);
                blocks_.set_transit(b, allowed_step(place, mass, bulk_at(law, material_.stiffness, point)));
            },
            material_.strength);
    }
    blocks_.review();
}

/// Lists the elements around each node, in their order.
void Tetrahedra::connect()
{
    std::uint32_t last = 0;
    first_node_ = 0xFFFFFFFFu;
    for (const auto& corners : corners_) {
        first_node_ = std::min(first_node_, *std::min_element(corners.begin(), corners.end()));
        last = std::max(last, *std::max_element(corners.begin(), corners.end()));
    }
    const std::size_t count = corners_.empty() ? 0 : last - first_node_ + 1;
    begin_.assign(count + 1, 0);
    for (std::size_t e = 0; e < size(); ++e)
        for (const std::uint32_t node : corners_[e]) ++begin_[node - first_node_];
    exclusive_scan(begin_);
    around_.resize(4 * size());
    std::vector<std::uint32_t> next = begin_;
    for (std::uint32_t e = 0; e < size(); ++e)
        for (const std::uint32_t node : corners_[e]) around_[next[node - first_node_]++] = e;
    node_mean_.resize(count);
    for (std::vector<double>* numbers : {&volume_, &amount_, &viscous_}) numbers->resize(corners_.size());
}

/// Five sweeps: growth of each element, its mean at nodes, stresses, the mean of pressures at nodes, loads.
std::size_t Tetrahedra::resist(const Nodes& nodes, double duration, std::span<CornerLoad> loads)
{
    for_each_dynamic(blocks_.block_count(), blocks_at_a_time, [&](std::size_t b) { measure_growth(nodes, duration, b); });
    average_at_nodes();
    for_each_block([&](const auto& law, std::size_t b) { stretch_block(law, nodes, duration, b); });
    average_at_nodes();
    for_each_block([&](const auto& law, std::size_t b) { load_block(law, nodes, duration, b, loads); });
    return blocks_.review();
}

/// Volume and gain of volume of each element in the middle of the step; nothing of eroded ones.
void Tetrahedra::measure_growth(const Nodes& nodes, double duration, std::size_t b)
{
    const auto* corners = corners_of_block(b);
    const Corners end = gather_left(blocks_, b, nodes.position, nodes.reference, corners);
    const Corners move = gather_way(blocks_, b, nodes.velocity, duration, corners);
    const TetGradient g(halfway(end, move));
    const Lanes volume = g.volume * blocks_.left(b);
    store_lanes(volume, &volume_[b * lane_count]);
    store_lanes(volume * volume_strain(g.of(move).strain()), &amount_[b * lane_count]);
}

/// At each node the mean of `amount_ / volume_` over its elements, by volume.
void Tetrahedra::average_at_nodes()
{
    for_each(node_mean_.size(), [&](std::size_t node) {
        double volume = 0, amount = 0;
        for (std::uint32_t k = begin_[node]; k < begin_[node + 1]; ++k) {
            volume += volume_[around_[k]];
            amount += amount_[around_[k]];
        }
        node_mean_[node] = volume > 0 ? amount / volume : 0.0;
    });
}

/// The mean of an element's corners.
Lanes Tetrahedra::mean_of_corners(std::size_t b) const
{
    return Lanes([&](auto lane) {
        const auto& corners = corners_[b * lane_count + lane];
        double sum = 0;
        for (const std::uint32_t node : corners) sum += node_mean_[node - first_node_];
        return 0.25 * sum;
    });
}

/// New stresses, with the growth of volume that the corners have; leaves volume and pressure at the end of the step to be averaged.
template <class Law>
void Tetrahedra::stretch_block(const Law& law, const Nodes& nodes, double duration, std::size_t b)
{
    if (blocks_.gone(b)) return store_lanes(0.0, &amount_[b * lane_count]);
    const auto* corners = corners_of_block(b);
    Lanes* own = blocks_.block(b);
    const Corners end = gather_left(blocks_, b, nodes.position, nodes.reference, corners);
    const Corners move = gather_way(blocks_, b, nodes.velocity, duration, corners);
    const TetGradient g(halfway(end, move));
    const Gradient3<Lanes> gradient = g.of(move);
    SolidStrain<Lanes> strain = gradient.strain();
    const Lanes growth = mean_of_corners(b) * blocks_.left(b), rest = (growth - volume_strain(strain)) * (1.0 / 3.0);
    strain.xx = strain.xx + rest;
    strain.yy = strain.yy + rest;
    strain.zz = strain.zz + rest;
    const ViscousPressure<Lanes> viscous =
        viscous_pressure(viscosity_, material_, cube_root(g.volume), Lanes(load_slot(own, slot_mass) / g.volume), growth, duration);
    SolidPoint<Lanes> point = load_point<SolidPoint<Lanes>>(law, own, slot_point);
    const Lanes plastic = advance_point(law, material_.stiffness, point, StepRotation<Lanes>(gradient.spin()), strain, duration);
    heat_by_viscosity<Law>(point, viscous.pressure, growth);
    store_point(law, point, own, slot_point);
    store_slot(own, slot_plastic_work, load_slot(own, slot_plastic_work) + g.volume * plastic);
    const Lanes volume = TetGradient(end).volume * blocks_.left(b);
    store_lanes(volume, &volume_[b * lane_count]);
    store_lanes(volume * (mean_stress(point.stress) - viscous.pressure), &amount_[b * lane_count]);
    store_lanes(viscous.step_share, &viscous_[b * lane_count]);
}

/// Loads of the stresses, the corners' mean of pressures in the place of each element's own.
template <class Law>
void Tetrahedra::load_block(const Law& law, const Nodes& nodes, double duration, std::size_t b, std::span<CornerLoad> loads)
{
    if (blocks_.gone(b)) return;
    const auto* corners = corners_of_block(b);
    Lanes* own = blocks_.block(b);
    const Corners end = gather_left(blocks_, b, nodes.position, nodes.reference, corners);
    const Corners move = gather_way(blocks_, b, nodes.velocity, duration, corners);
    const SolidPoint<Lanes> point = load_point<SolidPoint<Lanes>>(law, own, slot_point);
    const SolidStress<Lanes> stress = with_mean_added(point.stress, Lanes(mean_of_corners(b) - mean_stress(point.stress)));
    const TetGradient g(end);
    Corners force;
    for (int i = 0; i < 3; ++i) force[i + 1] = traction(stress, g.area[i]);
    force[0] = -(force[1] + force[2] + force[3]);
    const Vector way[] = {move[1] - move[0], move[2] - move[0], move[3] - move[0]};
    const Lanes work = exchange_work<3>(own, slot_loads, {&force[1], &force[2], &force[3]}, {&way[0], &way[1], &way[2]});
    const Lanes total = load_slot(own, slot_work) + work;
    store_slot(own, slot_work, total);
    write_loads<4>(blocks_, b, force, nullptr, loads.data());
    const Lanes step =
        allowed_step(end, load_slot(own, slot_mass), bulk_at(law, material_.stiffness, point)) * load_lanes(&viscous_[b * lane_count]);
    blocks_.set_transit(b, step + 0.0 * total);  // not above 0 if anything has gone wrong
}

/// 2 / (a bound of the highest frequency): means at nodes can only lower it. [s]
Lanes Tetrahedra::allowed_step(const Corners& place, const Lanes& mass, const Lanes& bulk) const
{
    const TetGradient g(place);
    GradientSquares<Lanes> squares;
    const Lanes inverse = 1.0 / g.volume;
    for (const Vector& area : g.area) squares.add(area * inverse);
    squares.add((g.area[0] + g.area[1] + g.area[2]) * inverse);
    const Lanes step = 2.0 / square_root(frequency_squared<Lanes>(squares, 4.0, g.volume / mass, bulk, material_.stiffness.shear()));
    return select(g.volume > 0.0, step, Lanes(-1.0));
}

SolidPoint<double> Tetrahedra::point(std::size_t element) const
{
    return point_of<SolidPoint<double>>(material_.strength, blocks_, element, slot_point);
}

ElementValues Tetrahedra::values(std::size_t element) const
{
    return values_of_points(1, [&](int) { return point(element); });
}

}  // namespace corpuscle
