#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace corpuscle {

/// A full square matrix, row by row.
struct SquareMatrix {
    explicit SquareMatrix(std::size_t n) : size(n), value(n * n) {}
    double& at(std::size_t i, std::size_t j) { return value[i * size + j]; }
    [[nodiscard]] double at(std::size_t i, std::size_t j) const { return value[i * size + j]; }
    std::size_t size;
    std::vector<double> value;
};

/// Eigenvalues of a symmetric matrix, ascending, by Jacobi's rotations.
inline std::vector<double> eigenvalues(SquareMatrix a)
{
    for (int sweep = 0; sweep < 60; ++sweep) {
        for (std::size_t p = 0; p < a.size; ++p) {
            for (std::size_t q = p + 1; q < a.size; ++q) {
                if (a.at(p, q) == 0) continue;
                const double theta = 0.5 * (a.at(q, q) - a.at(p, p)) / a.at(p, q);
                const double t = (theta < 0 ? -1.0 : 1.0) / (std::abs(theta) + std::sqrt(1.0 + theta * theta));
                const double c = 1.0 / std::sqrt(1.0 + t * t), s = t * c;
                for (std::size_t k = 0; k < a.size; ++k) {
                    const double x = a.at(k, p), y = a.at(k, q);
                    a.at(k, p) = c * x - s * y;
                    a.at(k, q) = s * x + c * y;
                }
                for (std::size_t k = 0; k < a.size; ++k) {
                    const double x = a.at(p, k), y = a.at(q, k);
                    a.at(p, k) = c * x - s * y;
                    a.at(q, k) = s * x + c * y;
                }
            }
        }
    }
    std::vector<double> values(a.size);
    for (std::size_t i = 0; i < a.size; ++i) values[i] = a.at(i, i);
    std::sort(values.begin(), values.end());
    return values;
}

}  // namespace corpuscle
