#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "contact/contact.hpp"
#include "euler/grid.hpp"
#include "structure/structure.hpp"

namespace corpuscle {

/// Structure in the flow of gases on a grid: its facets cut the grid as walls, thin, with gas on both sides. The gas of each side presses
/// on them with the pressure that brings it to rest on the moving wall; what it gives the facets' nodes it loses, impulse and work alike.
class GridWalls : public Contact {
public:
    /// Both bodies must outlive the contact; the structure's surface must be complete.
    GridWalls(EulerGrid& grid, Structure& structure);

    [[nodiscard]] std::string name() const override { return "grid_walls"; }

    /// Whether there are both a grid and a surface.
    [[nodiscard]] bool any() const;

    /// Cuts the grid where the surface is now: before the first step, and after a restart.
    void begin();

    /// Moves the walls through the step's motion of the nodes, and exchanges impulse and work: after the structure's accelerate, before the
    /// grid's flow. Returns what "gas" gave to "structure".
    std::vector<Transfer> apply(const Clock& clock) override;

    /// Impulse each facet has got since the start, from both sides together [N s].
    [[nodiscard]] const std::vector<Vector3d>& facet_impulse() const override { return facet_impulse_; }

    /// The longest step in which no node crosses more than part of a cell [s].
    [[nodiscard]] double stable_step() const;

    FieldSet state() override;

private:
    /// A push on a facet by the gas of one cell.
    struct Push {
        std::size_t cell = 0;
        const WallCrossing* crossing = nullptr;
        Vector3d impulse;   ///< [N s]
        Vector3d velocity;  ///< of the wall before [m/s]
        double swept = 0;   ///< volume that the wall takes from the cell, per time [m3/s]
        double work = 0;    ///< [J]
    };

    void follow();
    void find_pushes(double duration);
    void find_push(Push& push, const WallFace& face, bool lower, double duration) const;
    [[nodiscard]] Vector3d wall_velocity(const WallCrossing& crossing) const;
    void give_sources(double duration);

    EulerGrid& grid_;
    Structure& structure_;
    std::vector<std::uint8_t> free_;    ///< edges of the facets that only one has
    std::vector<std::uint8_t> hidden_;  ///< facets that were hidden when these were found
    std::vector<Push> pushes_;
    std::vector<Vector3d> facet_impulse_;  ///< [N s]
};

}  // namespace corpuscle
