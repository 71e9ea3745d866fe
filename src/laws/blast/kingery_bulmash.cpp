#include "laws/blast/kingery_bulmash.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "base/error.hpp"
#include "laws/blast/kingery_bulmash_tables.hpp"

namespace corpuscle {

namespace {

std::span<const KingeryBulmashPiece> pieces_of(Burst burst)
{
    if (burst == Burst::spherical) return spherical_burst;
    return hemispherical_burst;
}

/// Value of one piece, a power of ten of a polynomial in log Z.
double value_on(const KingeryBulmashPiece& piece, double z)
{
    const double u = piece.k0 + piece.k1 * std::log10(z);
    double exponent = 0;
    for (auto c = piece.coefficient.rbegin(); c != piece.coefficient.rend(); ++c) exponent = exponent * u + *c;
    return std::pow(10.0, exponent);
}

/// Value of a curve; before its first piece the piece's first value.
double curve(Burst burst, BlastQuantity quantity, double z)
{
    const KingeryBulmashPiece* last = nullptr;
    for (const KingeryBulmashPiece& piece : pieces_of(burst)) {
        if (piece.quantity != quantity) continue;
        last = &piece;
        if (z <= piece.farthest) break;
    }
    return value_on(*last, std::max(z, last->nearest));
}

const char* name_of(Burst burst)
{
    return burst == Burst::spherical ? "spherical" : "hemispherical";
}

}  // namespace

ScaledDistanceRange scaled_distance_range(Burst burst)
{
    const KingeryBulmashPiece& first = pieces_of(burst).front();
    return {first.nearest, first.farthest};
}

double scaled_distance(double mass, double distance)
{
    return distance / std::cbrt(mass);
}

BlastWave kingery_bulmash(Burst burst, double mass, double distance)
{
    if (!(mass > 0))
        throw InputError(fmt::format("Kingery-Bulmash: a mass of {:g} kg is no charge", mass), "give the mass of TNT, more than nothing");
    const double z = scaled_distance(mass, distance);
    const auto [nearest, farthest] = scaled_distance_range(burst);
    if (!(z >= nearest && z <= farthest)) {
        throw InputError(
            fmt::format(
                "Kingery-Bulmash: scaled distance Z = {:.4g} m/kg^(1/3) ({:g} m from {:g} kg of TNT) is outside {:g}..{:g} of a {} burst",
                z, distance, mass, nearest, farthest, name_of(burst)),
            z < nearest ? "move the charge away from the surface, or use gas particles" : "leave the far surface out of the load");
    }
    constexpr double kilo = 1e3, milli = 1e-3;
    const double root = std::cbrt(mass);
    BlastWave wave;
    wave.arrival = milli * root * curve(burst, BlastQuantity::arrival, z);
    wave.duration = milli * root * curve(burst, BlastQuantity::duration, z);
    wave.incident_pressure = kilo * curve(burst, BlastQuantity::incident_pressure, z);
    wave.incident_impulse = kilo * milli * root * curve(burst, BlastQuantity::incident_impulse, z);
    wave.reflected_pressure = kilo * curve(burst, BlastQuantity::reflected_pressure, z);
    wave.reflected_impulse = kilo * milli * root * curve(burst, BlastQuantity::reflected_impulse, z);
    return wave;
}

}  // namespace corpuscle
