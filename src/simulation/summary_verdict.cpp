#include "simulation/summary_verdict.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace corpuscle {

Verdict mass_verdict(double relative_error)
{
    return {"mass", std::abs(relative_error), 1e-9, "mass lost or made, over all mass"};
}

Verdict momentum_verdict(double relative_error)
{
    return {"momentum", std::abs(relative_error), 1e-3, "momentum the ledger misses, over all that was exchanged"};
}

Verdict energy_verdict(double relative_error)
{
    return {"energy", std::abs(relative_error), 1e-2, "energy the ledger misses, over all energy"};
}

Verdict noise_verdict(double hits)
{
    const double noise = hits > 0 ? std::sqrt(4 / (std::numbers::pi * hits)) : std::numeric_limits<double>::infinity();
    return {"noise", noise, 0.05, "scatter of the load by the finite number of particle hits"};
}

Verdict resolution_verdict(double spacing, double length)
{
    return {"resolution", spacing / length, 0.1, "spacing of the particles that load the structure, over the charge's distance"};
}

}  // namespace corpuscle
