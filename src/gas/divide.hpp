#pragma once

#include <memory>
#include <vector>

#include "gas/cells.hpp"
#include "gas/particle.hpp"

namespace corpuscle {

/// Most particles that a piece of each kind holds.
struct DivisionLimits {
    std::uint32_t cell = 16;
    std::uint32_t group = 64;
    std::uint32_t bucket = 1024;
};

/// The pieces of a box of the curve, each kind in the order of the curve.
struct Division {
    std::vector<Cell> cells;      ///< boxes with something in them
    std::vector<Cell> groups;     ///< the same, larger
    std::vector<Bucket> buckets;  ///< all boxes
};

/// Sorts particles of one box of the curve by halving it until no cell holds more than it may. Particles of one cell keep their order.
class Divider {
public:
    Divider(const CellCurve& curve, const DivisionLimits& limits) : curve_(curve), limits_(limits) {}

    /// Takes a particle in. The next `divide` sorts all that were taken since the last.
    void take(const Particle& particle)
    {
        if (taken_ == particles_.size()) particles_.resize(2 * taken_ + 64);
        particles_[taken_++] = particle;
    }

    /// Takes those of `count` particles that have not gone.
    void take_remaining(const Particle* first, std::size_t count);

    /// Writes the particles taken, all within the box of `start_key` and `depth`, sorted to `target`, which is the place of particle number
    /// `first`, and adds the box's pieces to `division`.
    void divide(std::uint64_t start_key, int depth, Particle* target, std::uint32_t first, Division& division);

private:
    /// A box among those that the present one is cut into, and what of it is still to be named.
    struct Node {
        std::uint32_t begin = 0, end = 0;  ///< bins
        std::uint32_t depth = 0;
        bool bucket = true, group = true;  ///< whether no box that holds it has been called one
    };

    void place(Particle* target);
    void cut(const Node& node, Division& division);
    void cut_finer(const Node& node, Division& division);
    [[nodiscard]] std::uint64_t key_of_bin(std::uint32_t bin) const;

    const CellCurve& curve_;
    DivisionLimits limits_;
    std::vector<Particle> particles_;  ///< taken: the first `taken_`
    std::size_t taken_ = 0;
    std::vector<std::uint16_t> bin_;        ///< of each
    std::vector<std::uint32_t> bin_start_;  ///< first particle of each, and the end
    CurveBranch branch_;
    std::unique_ptr<Divider> finer_;  ///< for a bin that is still too full

    std::uint64_t start_key_ = 0;
    int bin_depth_ = 0;
    Particle* target_ = nullptr;
    std::uint32_t first_ = 0;
    Node whole_;
};

}  // namespace corpuscle
