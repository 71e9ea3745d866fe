#include "euler/wall_flux.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle {

CellState cell_state(const EulerGrid& grid, std::size_t cell)
{
    CellState found;
    found.mixture = look(grid, cell);
    for (std::size_t m = 0; m < grid.laws.size(); ++m) {
        const MieGrueneisen& law = grid.laws[m];
        const double share = found.mixture.share[m], density = phase_density(law, grid.now.mass[m][cell], share);
        const double cold = law.cold && share > least_share ? law.cold_terms(density).q : 0;
        found.inverse_gamma += share * law.inverse_gamma(density);
        found.cold += share * cold;
        found.mass[m] = grid.now.mass[m][cell];
        found.energy[m] = share * (law.inverse_gamma(density) * found.mixture.pressure - cold);
        if (!grid.now.unburnt[m].empty()) found.unburnt[m] = grid.now.unburnt[m][cell];
    }
    return found;
}

double wall_pressure(const EulerCell& cell, double speed)
{
    const double c = cell.sound_speed, gamma = cell.density * c * c / cell.pressure;
    if (speed >= 0) {
        const double part = 0.25 * (gamma + 1) * speed;
        return cell.pressure + cell.density * speed * (part + std::sqrt(part * part + c * c));
    }
    const double base = 1 + 0.5 * (gamma - 1) * speed / c;
    return base > 0 ? cell.pressure * std::pow(base, 2 * gamma / (gamma - 1)) : 0.0;
}

void flow_through(const CellState& from, const CellState& to, const Vector3d& area, WallSource& of_from, WallSource& of_to)
{
    const double size = norm(area);
    if (!(size > 0)) return;
    const Vector3d n = area / size;
    const EulerCell &l = from.mixture, &r = to.mixture;
    const double ul = dot(l.velocity, n), ur = dot(r.velocity, n);
    const double slowest = std::min(ul - l.sound_speed, ur - r.sound_speed), fastest = std::max(ul + l.sound_speed, ur + r.sound_speed);
    const double push_l = l.density * (slowest - ul), push_r = r.density * (fastest - ur);
    const double contact = (r.pressure - l.pressure + push_l * ul - push_r * ur) / (push_l - push_r);
    const bool left = contact >= 0;
    const CellState& source = left ? from : to;
    const EulerCell& up = source.mixture;
    const double u = left ? ul : ur, wave = left ? slowest : fastest;
    const bool whole = left ? slowest >= 0 : fastest <= 0;
    const double speed = whole ? u : contact, relative = wave - u, squeeze = relative / (wave - speed);
    const double pressure = up.pressure + up.density * relative * (speed - u), volume = size * squeeze * speed;
    const double total = source.inverse_gamma * up.pressure - source.cold + 0.5 * up.density * dot(up.velocity, up.velocity);
    const double star = squeeze * (total + (speed - u) * (up.density * speed + up.pressure / relative));
    const Vector3d momentum = up.density * volume * (up.velocity + (speed - u) * n) + size * pressure * n;
    const double energy = size * (star + pressure) * speed;
    const auto give = [&](WallSource& given, const CellState& own, double sign) {
        for (std::size_t m = 0; m < most_euler_materials; ++m) {
            given.mass[m] += sign * volume * source.mass[m];
            given.unburnt[m] += sign * volume * source.unburnt[m];
            given.share[m] += sign * volume * (up.share[m] - own.mixture.share[m]);
            given.part[m] += sign * volume * (source.energy[m] + own.mixture.share[m] * own.mixture.pressure);
        }
        given.momentum += sign * momentum;
        given.energy += sign * energy;
    };
    give(of_from, from, -1);
    give(of_to, to, 1);
}

}  // namespace corpuscle
