#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace corpuscle {

/// Roots of a cubic where it changes sign in (0, 1], in order.
struct CubicRoots {
    int count = 0;
    std::array<double, 3> at{};      ///< the roots
    std::array<double, 3> before{};  ///< sign (-1 or 1) the cubic has just before each
};

/// A cubic on [0, 1] given by its Bernstein coefficients.
class Cubic {
public:
    explicit Cubic(const std::array<double, 4>& b)
        : c_{b[0], 3 * (b[1] - b[0]), 3 * ((b[2] - b[1]) - (b[1] - b[0])), (b[3] - b[2]) - 2 * (b[2] - b[1]) + (b[1] - b[0])}, end_(b[3])
    {
    }

    [[nodiscard]] double operator()(double t) const { return t == 1 ? end_ : c_[0] + t * (c_[1] + t * (c_[2] + t * c_[3])); }
    [[nodiscard]] double slope(double t) const { return c_[1] + t * (2 * c_[2] + t * 3 * c_[3]); }

    /// Where it changes sign in (0, 1].
    [[nodiscard]] CubicRoots roots() const
    {
        return roots_of(*this, [this](double t) { return slope(t); }, turning_points(c_[1], 2 * c_[2], 3 * c_[3]));
    }

    /// As `roots` of the quotient by t: for a cubic that is 0 at 0.
    [[nodiscard]] CubicRoots roots_after_zero() const
    {
        const auto quotient = [this](double t) { return t == 1 ? end_ : c_[1] + t * (c_[2] + t * c_[3]); };
        return roots_of(quotient, [this](double t) { return c_[2] + t * 2 * c_[3]; }, turning_points(c_[2], 2 * c_[3], 0));
    }

private:
    /// Ends of the stretches of [0, 1] on which a function is monotonic, from its slope a + b t + c t2.
    static std::array<double, 4> turning_points(double a, double b, double c)
    {
        std::array<double, 4> ends{0, 1, 1, 1};
        const double discriminant = b * b - 4 * a * c;
        int n = 1;
        if (discriminant >= 0) {
            const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
            double first = c != 0 ? q / c : 2, second = q != 0 ? a / q : 2;
            if (first > second) std::swap(first, second);
            if (first > 0 && first < 1) ends[n++] = first;
            if (second > 0 && second < 1) ends[n++] = second;
        }
        return ends;
    }

    /// Goes through monotonic stretches and finds the root in each that has one.
    template <class Function, class Slope>
    static CubicRoots roots_of(const Function& f, const Slope& slope, const std::array<double, 4>& ends)
    {
        CubicRoots found;
        double left = ends[0], value = f(left);
        for (int i = 1; i < 4; ++i) {
            const double right = ends[i], next = f(right);
            if (right == left) break;
            if (value != 0 && (next == 0 || (value < 0) != (next < 0))) {
                found.before[found.count] = value < 0 ? -1 : 1;
                found.at[found.count++] = next == 0 ? right : root_between(f, slope, left, right, value < 0);
            }
            left = right;
            value = next;
        }
        return found;
    }

    /// The root in (left, right), where the function changes sign: Newton's steps, halving where they leave the bracket or stall.
    template <class Function, class Slope>
    static double root_between(const Function& f, const Slope& slope, double left, double right, bool rising)
    {
        double t = 0.5 * (left + right);
        for (int step = 0; step < 100; ++step) {
            const double value = f(t);
            if (value == 0) return t;
            ((value < 0) == rising ? left : right) = t;
            const double newton = t - value / slope(t);
            const double next = newton > left && newton < right && step % 8 != 7 ? newton : 0.5 * (left + right);
            if (std::abs(next - t) <= 1e-16 || next == left || next == right) return next;
            t = next;
        }
        return t;
    }

    std::array<double, 4> c_;
    double end_;  ///< the exact value at 1
};

}  // namespace corpuscle
