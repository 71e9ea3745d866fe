#pragma once

namespace corpuscle {

/// Times at which something is due: 0, every, 2 every, ... Each is computed by a product, so no rounding piles up.
class Interval {
public:
    /// `every` [s]; zero or infinite is never due but at 0.
    explicit Interval(double every);

    /// The next time [s], infinity if there is none.
    [[nodiscard]] double next() const;
    /// Whether the next time has come (up to a millionth of the interval). If so, goes on to the first time after `time` [s].
    [[nodiscard]] bool take(double time);
    /// As if all times up to `time` [s] had been taken.
    void resume(double time);

private:
    double every_;
    double count_ = 0;  ///< times taken, a whole number
};

}  // namespace corpuscle
