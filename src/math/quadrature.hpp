#pragma once

#include <vector>

namespace corpuscle {

/// Where a function on [-1, 1] is read and with which weight; the weights add up to 2.
struct QuadraturePoint {
    double position = 0;
    double weight = 0;
};

/// Gauss-Legendre rule of `count` >= 1 points, lowest first: exact for polynomials of degree 2 count - 1.
[[nodiscard]] std::vector<QuadraturePoint> gauss_rule(int count);

/// Gauss-Lobatto rule of `count` >= 2 points, both ends among them: exact for polynomials of degree 2 count - 3.
[[nodiscard]] std::vector<QuadraturePoint> lobatto_rule(int count);

}  // namespace corpuscle
