#pragma once

namespace corpuscle {

/// Probability that Student's t with whole degrees of freedom (1 or more) lies within [-t, t]; the finite sums of Abramowitz and
/// Stegun, Handbook of Mathematical Functions (1964), 26.7.3 and 26.7.4.
[[nodiscard]] double student_within(double t, int degrees);

/// The t within which that probability is `confidence`, 0 < confidence < 1: 12.706 for 0.95 and 1 degree, 1.960 for many.
[[nodiscard]] double student_limit(double confidence, int degrees);

}  // namespace corpuscle
