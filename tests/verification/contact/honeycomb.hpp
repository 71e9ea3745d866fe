#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "../../unit/contact/gas_structure_bodies.hpp"
#include "closed_walls.hpp"
#include "gas/fly.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

/// A block of rooms with folded walls that meet in T and cross joints, each room with gas of its own that does not collide, swinging at up
/// to 500 m/s, turning, sheared and stretched; its inner facets may erode one by one. In the block's own coordinates the corners of facets
/// lie on a lattice of unit length whose planes are folded along z, and the motion is one linear map for all, so the room that a particle
/// is in is known exactly, whatever the search finds.
class Honeycomb {
public:
    /// `rooms` a side must divide `cells` a side; `fold` is the tangent of the folds' slope, `speed` the deviation of each component of the
    /// particles' velocities [m/s].
    Honeycomb(int cells, int rooms, double fold, std::size_t particles, double speed) : cells_(cells), rooms_(rooms), fold_(fold)
    {
        for (int c = 0; c <= cells; ++c)
            for (int b = 0; b <= cells; ++b)
                for (int a = 0; a <= cells; ++a) lattice_.push_back(folded(Vector3d(a, b, c) / cells));
        for (int axis = 0; axis < 3; ++axis)
            for (int plane = 0; plane <= rooms; ++plane) add_wall(axis, plane);
        surface_.hidden.assign(surface_.facets.size(), 0);
        structure = bare_structure(surface_, lattice_, 0);
        place_nodes(0);
        structure.nodes.previous = structure.nodes.position;
        joined_.resize(static_cast<std::size_t>(rooms) * rooms * rooms);
        std::iota(joined_.begin(), joined_.end(), 0u);
        gas = empty_gas({{-4, -4, -4}, {4, 4, 4}}, 1e-3);
        fill(particles, speed);
    }

    [[nodiscard]] std::size_t facets() const { return surface_.facets.size(); }
    [[nodiscard]] std::size_t eroded() const { return eroded_; }

    /// Moves the walls and lets the gas fly.
    void step(GasStructureContact& contact, double duration)
    {
        clock.begin_step(duration);
        Nodes& nodes = structure.nodes;
        nodes.previous = nodes.position;
        place_nodes(clock.end());
        for_each(nodes.size(), [&](std::size_t n) { nodes.velocity[n] = (nodes.position[n] - nodes.previous[n]) / duration; });
        contact.follow();
        fly(gas, clock, contact.tree());
        contact.apply(clock);
        clock.end_step();
    }

    /// Takes out facets between rooms at random, which join those.
    void erode(int count)
    {
        while (count > 0) {
            const std::size_t f = erosion_.below(static_cast<std::uint32_t>(facets()));
            if (beside_[f][0] < 0 || beside_[f][1] < 0 || structure.surface.hidden[f]) continue;
            structure.surface.hidden[f] = 1;
            joined_[root(static_cast<std::uint32_t>(beside_[f][0]))] = root(static_cast<std::uint32_t>(beside_[f][1]));
            ++eroded_;
            --count;
        }
    }

    /// Particles that are not in a room joined to the one they began in.
    [[nodiscard]] std::size_t astray() const
    {
        const Map map(clock.time());
        return sum<std::size_t>(gas.particles.size(), [&](std::size_t i) {
            const std::int32_t now = room_of(map.back(Vector3d(gas.particles[i].position)));
            return std::size_t{now < 0 || root(static_cast<std::uint32_t>(now)) != root(home_[i]) ? 1u : 0u};
        });
    }

    Structure structure;
    Gas gas;
    Clock clock;

private:
    /// Where the block's own coordinates lie at a time: stretched, sheared, turned and displaced.
    struct Map {
        explicit Map(double t) : middle(middle_at(t))
        {
            const double stretch = 1 + 0.2 * std::sin(1500 * t), shear = 0.8 * std::sin(1200 * t);
            const std::array<Vector3d, 3> bent{Vector3d{stretch, 0, 0}, Vector3d{shear, 1 / stretch, 0}, Vector3d{0, 0.5 * shear, 1}};
            const Vector3d axis = Vector3d{1, 1, 1} / std::sqrt(3.0);
            const double angle = 400 * t;
            for (int i = 0; i < 3; ++i)
                column[i] =
                    std::cos(angle) * bent[i] + std::sin(angle) * cross(axis, bent[i]) + (1 - std::cos(angle)) * dot(axis, bent[i]) * axis;
            volume = dot(column[0], cross(column[1], column[2]));
        }
        [[nodiscard]] Vector3d place(const Vector3d& own) const
        {
            const Vector3d p = own - Vector3d{0.5, 0.5, 0.5};
            return middle + p.x * column[0] + p.y * column[1] + p.z * column[2];
        }
        [[nodiscard]] Vector3d back(const Vector3d& at) const
        {
            const Vector3d p = at - middle;
            return Vector3d{dot(p, cross(column[1], column[2])), dot(p, cross(column[2], column[0])), dot(p, cross(column[0], column[1]))} /
                       volume +
                   Vector3d{0.5, 0.5, 0.5};
        }
        Vector3d middle;
        std::array<Vector3d, 3> column;
        double volume = 1;
    };

    /// How far the folds carry x at a height z: to and fro from one layer of the lattice to the next.
    [[nodiscard]] double folding(double z) const
    {
        const double layers = z * cells_, layer = std::floor(layers), part = layers - layer;
        return fold_ / cells_ * (static_cast<int>(layer) % 2 == 0 ? part : 1 - part);
    }
    [[nodiscard]] Vector3d folded(const Vector3d& even) const { return {even.x + folding(even.z), even.y, even.z}; }

    /// The room of a place in the block's own coordinates, -1: none.
    [[nodiscard]] std::int32_t room_of(const Vector3d& own) const
    {
        const Vector3d even{own.x - folding(own.z), own.y, own.z};
        std::int32_t room = 0;
        for (int axis = 2; axis >= 0; --axis) {
            if (!(even[axis] > 0 && even[axis] < 1)) return -1;
            room = room * rooms_ + static_cast<std::int32_t>(even[axis] * rooms_);
        }
        return room;
    }

    [[nodiscard]] std::uint32_t root(std::uint32_t room) const
    {
        while (joined_[room] != room) room = joined_[room];
        return room;
    }

    /// All facets in a plane between rooms, or of the hull.
    void add_wall(int axis, int plane)
    {
        const int e = (axis + 1) % 3, f = (axis + 2) % 3, wide = cells_ / rooms_;
        std::array<int, 3> at{};
        at[axis] = plane * wide;
        for (at[e] = 0; at[e] < cells_; ++at[e]) {
            for (at[f] = 0; at[f] < cells_; ++at[f]) {
                const auto corner = [&](int de, int df) {
                    std::array<int, 3> c = at;
                    c[e] += de;
                    c[f] += df;
                    return static_cast<std::uint32_t>((c[2] * (cells_ + 1) + c[1]) * (cells_ + 1) + c[0]);
                };
                const auto room_at = [&](int p) {
                    std::array<int, 3> r{at[0] / wide, at[1] / wide, at[2] / wide};
                    r[axis] = p;
                    return p < 0 || p >= rooms_ ? -1 : (r[2] * rooms_ + r[1]) * rooms_ + r[0];
                };
                surface_.facets.push_back({{corner(0, 0), corner(1, 0), corner(1, 1)}, 0, 0});
                surface_.facets.push_back({{corner(0, 0), corner(1, 1), corner(0, 1)}, 0, 0});
                beside_.insert(beside_.end(), 2, {room_at(plane - 1), room_at(plane)});
            }
        }
    }

    void place_nodes(double time)
    {
        const Map map(time);
        for_each(lattice_.size(), [&](std::size_t n) { structure.nodes.position[n] = map.place(lattice_[n]); });
    }

    /// Particles all over the rooms, those of a room together.
    void fill(std::size_t particles, double speed)
    {
        const Map map(0);
        Random random(12, Purpose::contact, 0, 0);
        std::vector<std::pair<std::int32_t, std::size_t>> order;  // room, number of the particle
        std::vector<Particle> placed;
        while (placed.size() < particles) {
            const Vector3d even{random.uniform_double(), random.uniform_double(), random.uniform_double()};
            const Vector3f at(map.place(folded(even)));
            const double x = random.normal(), y = random.normal(), z = random.normal();
            const std::int32_t room = room_of(map.back(Vector3d(at)));
            if (room < 0) continue;
            order.emplace_back(room, placed.size());
            placed.push_back(particle_at(at, Vector3f(speed * Vector3d{x, y, z})));
        }
        std::sort(order.begin(), order.end());
        for (const auto& [room, particle] : order) {
            home_.push_back(static_cast<std::uint32_t>(room));
            gas.particles.push_back(placed[particle]);
        }
    }

    int cells_, rooms_;
    double fold_;
    std::vector<Vector3d> lattice_;  ///< of the nodes, in the block's own coordinates
    Surface surface_;
    std::vector<std::array<std::int32_t, 2>> beside_;  ///< rooms on both sides of each facet, -1: none
    std::vector<std::uint32_t> joined_;                ///< a room joined to each, itself at the end
    std::vector<std::uint32_t> home_;                  ///< the room in which each particle began
    Random erosion_{13, Purpose::contact, 0, 0};
    std::size_t eroded_ = 0;
};

}  // namespace corpuscle
