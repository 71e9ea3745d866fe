#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "euler/fill.hpp"
#include "euler/grid.hpp"
#include "gas/domain.hpp"
#include "input/case/case_description.hpp"
#include "input/spherical_start.hpp"

namespace corpuscle {

/// A grid ready to be filled: its faces, gases, settings; and what will fill it.
struct EulerPlan {
    EulerSettings settings;
    EulerSpace space = EulerSpace::planar;
    std::array<std::vector<double>, 3> faces;  ///< along the grid's axes; of axes that the symmetry leaves out: none [m]
    std::array<EulerEdge, euler_face_count> edges{};
    std::vector<EulerMaterial> materials;
    std::vector<EulerFill> fills;
    std::vector<Shape> charge_shapes;   ///< the last fills are theirs
    std::vector<double> charge_masses;  ///< within the grid, the whole way round [kg]
    std::optional<FreeBlast> start;     ///< if the gases begin from the blast in one dimension
    Domain domain;                      ///< the box in space, the whole way round

    [[nodiscard]] std::size_t cells() const;
    [[nodiscard]] std::size_t cells_along(std::size_t axis) const { return faces[axis].empty() ? 1 : faces[axis].size() - 1; }
    /// Whether anything flows along an axis.
    [[nodiscard]] bool live(std::size_t axis) const { return cells_along(axis) > 1; }
    /// Widths of the narrowest and of the widest cell along an axis that reach into a range of it [m].
    [[nodiscard]] std::array<double, 2> widths(std::size_t axis, double from, double to) const;
    /// Those of all cells along the axis.
    [[nodiscard]] std::array<double, 2> widths(std::size_t axis) const { return widths(axis, faces[axis].front(), faces[axis].back()); }
};

/// Works out everything but the cells themselves. Errors: InputError at the place of what is wrong: a box or cells that do not fit the
/// symmetry, no charge and no fill, charges outside the box, shapes that the symmetry cannot have, more than four gases.
[[nodiscard]] EulerPlan plan_euler(const CaseDescription& description, std::vector<std::string>& warnings);

/// Fills the grid as planned. Errors: InputError where nothing fills a part of it.
[[nodiscard]] EulerGrid fill_grid(const EulerPlan& plan);

/// The stable step that the grid will have at a time, about [s].
[[nodiscard]] double expected_grid_step(const EulerPlan& plan, double time);

}  // namespace corpuscle
