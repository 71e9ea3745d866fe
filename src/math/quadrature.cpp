#include "math/quadrature.hpp"

#include <cmath>
#include <numbers>

namespace corpuscle {

namespace {

struct Legendre {
    double value;  ///< P_n(x)
    double slope;  ///< P_n'(x)
};

/// Legendre polynomial of degree n >= 1 and its slope at |x| < 1, by the three-term recurrence.
Legendre legendre(int n, double x)
{
    double before = 1.0, value = x;
    for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
    }
    return {value, n * (before - x * value) / (1.0 - x * x)};
}

/// Newton's method from a near start; the roots of P_n and P_n' are simple.
template <class Step>
double root(double x, const Step& step)
{
    for (int i = 0; i < 100; ++i) {
        const double change = step(x);
        x -= change;
        if (std::abs(change) < 1e-15) break;
    }
    return x;
}

}  // namespace

std::vector<QuadraturePoint> gauss_rule(int count)
{
    std::vector<QuadraturePoint> rule;
    for (int i = count; i >= 1; --i) {
        const double x = root(std::cos(std::numbers::pi * (i - 0.25) / (count + 0.5)), [count](double at) {
            const Legendre p = legendre(count, at);
            return p.value / p.slope;
        });
        const double slope = legendre(count, x).slope;
        rule.push_back({x, 2.0 / ((1.0 - x * x) * slope * slope)});
    }
    return rule;
}

std::vector<QuadraturePoint> lobatto_rule(int count)
{
    const int n = count - 1;
    const double end_weight = 2.0 / (count * n);
    std::vector<QuadraturePoint> rule{{-1.0, end_weight}};
    for (int i = n - 1; i >= 1; --i) {
        const double x = root(std::cos(std::numbers::pi * i / n), [n](double at) {
            const Legendre p = legendre(n, at);
            const double curvature = (2.0 * at * p.slope - n * (n + 1) * p.value) / (1.0 - at * at);
            return p.slope / curvature;
        });
        const double value = legendre(n, x).value;
        rule.push_back({x, end_weight / (value * value)});
    }
    rule.push_back({1.0, end_weight});
    return rule;
}

}  // namespace corpuscle
