#include "euler/relaxation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "euler/grid.hpp"

namespace corpuscle {

namespace {

/// Pressures that differ by less than this share of both count as one.
constexpr double same_pressure = 1e-9;
/// The same between more than two gases, which are brought together two at a time.
constexpr double like_pressure = 1e-6;
/// How near to the root the boundary is moved, in the logarithm of the ratio of the two volumes.
constexpr double near_enough = 1e-8;

/// A gas that is squeezed or let out without heat, from a state on.
class Squeezed {
public:
    explicit Squeezed(const PhasePart& part)
        : law_(*part.law), mass_(part.mass), density_(std::clamp(part.mass / part.share, 1e-30, law_.largest_density))
    {
        const auto cold = law_.cold ? law_.cold_terms(density_) : MieGrueneisen::Cold{0, 0};
        const double x = law_.inverse_gamma(density_);
        pressure_ = (part.energy / part.mass * density_ + cold.q) / x;
        stiffness_ = std::max((cold.z + law_.g * pressure_) / (x * pressure_), 1.0);
        thermal_ = pressure_ - law_.cold_isentrope(density_);
        free_ = x / density_;
    }
    [[nodiscard]] double start() const { return pressure_; }
    /// d log p/d log density at the start.
    [[nodiscard]] double stiffness() const { return stiffness_; }
    /// Pressure when the gas has a share of the cell.
    [[nodiscard]] double pressure(double share) const
    {
        const double density = std::min(mass_ / share, law_.largest_density), gamma = law_.g / (law_.g - 1);
        return thermal_ * std::pow(free_ * density / law_.inverse_gamma(density), gamma) + law_.cold_isentrope(density);
    }

private:
    const MieGrueneisen& law_;
    double mass_, density_, pressure_ = 0, stiffness_ = 1, thermal_ = 0, free_ = 0;
};

/// Logarithm of the ratio of two pressures, of which one may be below nothing: a solid that is drawn.
double imbalance(double p, double q)
{
    const double least = 1e-12 * (std::abs(p) + std::abs(q)) + 1e-300;
    return std::log(std::max(p, least) / std::max(q, least));
}

/// The first gas' share when both are in one pressure, from shares at which the logarithm of the ratio of their pressures is `found`.
/// In the logarithms of volumes and pressures both isentropes are nearly straight: Newton's rule first, then secants, kept within the
/// bounds that the signs set.
double even_share(const Squeezed& a, const Squeezed& b, double share, double rest, double found)
{
    const double whole = share + rest;
    const auto first_share = [&](double x) { return x > 0 ? whole / (1 + std::exp(-x)) : whole * std::exp(x) / (1 + std::exp(x)); };
    double x = std::log(share / rest), low = -60, high = 60;
    double slope = -(a.stiffness() * rest + b.stiffness() * share) / whole;
    for (int iteration = 0; iteration < 60 && std::abs(found) > same_pressure; ++iteration) {
        (found > 0 ? low : high) = x;
        const double next = x - found / slope, inside = next > low && next < high ? next : 0.5 * (low + high);
        share = first_share(inside);
        const double now = imbalance(a.pressure(share), b.pressure(whole - share)), secant = (now - found) / (inside - x);
        const bool done = std::abs(inside - x) < near_enough;
        if (secant < 0) slope = secant;
        x = inside, found = now;
        if (done) break;
    }
    return share;
}

}  // namespace

double relaxed_share(const PhasePart& first, const PhasePart& second)
{
    const Squeezed a(first), b(second);
    return even_share(a, b, first.share, second.share, imbalance(a.start(), b.start()));
}

void relax_shares(std::span<const PhasePart> parts, std::span<double> shares)
{
    constexpr int most_sweeps = 30;
    std::array<std::optional<Squeezed>, most_euler_materials> gases;
    std::size_t most = 0;
    for (std::size_t m = 0; m < parts.size(); ++m) {
        gases[m].emplace(parts[m]);
        shares[m] = parts[m].share;
        if (shares[m] > shares[most]) most = m;
    }
    bool even = false;
    for (int sweep = 0; sweep < most_sweeps && !even; ++sweep) {
        even = true;
        for (std::size_t m = 0; m < parts.size(); ++m) {
            if (m == most) continue;
            const double found = imbalance(gases[m]->pressure(shares[m]), gases[most]->pressure(shares[most]));
            if (std::abs(found) < like_pressure) continue;
            const double whole = shares[m] + shares[most];
            shares[m] = even_share(*gases[m], *gases[most], shares[m], shares[most], found);
            shares[most] = whole - shares[m];
            even = false;
        }
    }
}

}  // namespace corpuscle
