#pragma once

#include <cstdint>

namespace corpuscle {

/// The simulation's time: where the present step begins and how long it is. SI seconds.
class Clock {
public:
    /// Starts a step of `duration` [s] at the present time.
    void begin_step(double duration)
    {
        previous_duration_ = duration_;
        duration_ = duration;
    }
    /// Ends the step: its end becomes the present time.
    void end_step()
    {
        time_ += duration_;
        ++step_;
    }

    [[nodiscard]] double time() const { return time_; }                            ///< start of the step [s]
    [[nodiscard]] double end() const { return time_ + duration_; }                 ///< end of the step [s]
    [[nodiscard]] double duration() const { return duration_; }                    ///< of the step [s]
    [[nodiscard]] double previous_duration() const { return previous_duration_; }  ///< of the step before [s], 0 at the first
    [[nodiscard]] std::uint64_t step() const { return step_; }                     ///< steps done

    /// Takes up a saved state.
    void restore(double time, double duration, double previous_duration, std::uint64_t step)
    {
        time_ = time;
        duration_ = duration;
        previous_duration_ = previous_duration;
        step_ = step;
    }

private:
    double time_ = 0;
    double duration_ = 0;
    double previous_duration_ = 0;
    std::uint64_t step_ = 0;
};

}  // namespace corpuscle
