#include "laws/blast/blast_load.hpp"

namespace corpuscle {

BlastLoad::BlastLoad(const BlastWave& wave, double cosine)
    : arrival_(wave.arrival),
      incident_(fit_friedlander(wave.incident_pressure, wave.duration, wave.incident_impulse)),
      reflected_(fit_friedlander(wave.reflected_pressure, wave.duration, wave.reflected_impulse)),
      incident_share_(cosine < 0 ? 1.0 : 1 + cosine * cosine - 2 * cosine),
      reflected_share_(cosine < 0 ? 0.0 : cosine * cosine)
{
}

double BlastLoad::pressure(double time) const
{
    const double since = time - arrival_;
    return reflected_share_ * reflected_.pressure(since) + incident_share_ * incident_.pressure(since);
}

double BlastLoad::impulse(double start, double end) const
{
    if (end <= arrival_ || start >= this->end()) return 0;
    const auto until = [&](double time) {
        return reflected_share_ * reflected_.impulse(time - arrival_) + incident_share_ * incident_.impulse(time - arrival_);
    };
    return until(end) - until(start);
}

double BlastLoad::end() const
{
    return arrival_ + incident_.duration;
}

double BlastLoad::peak() const
{
    return reflected_share_ * reflected_.peak + incident_share_ * incident_.peak;
}

}  // namespace corpuscle
