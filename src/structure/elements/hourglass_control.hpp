#pragma once

namespace corpuscle {

/// What resists the modes a one-point shell does not see (after Flanagan and Belytschko 1981, Belytschko and Tsay 1983). [1]
struct HourglassControl {
    double membrane = 0.05;  ///< stiffness of the in-plane modes, as a share of 2 E t A S (S the squared gradients)
    double bending = 0.05;   ///< of the rotation modes, as a share of 2 E t^3/12 A S
    double shear = 0.1;      ///< of the modes across the shell, as a share of the full bilinear transverse shear
    double drill = 0.03;     ///< of the corners' mean turning about the normal beyond the plane's spin, as a share of G t A
    double viscosity = 0.0;  ///< of all modes, as a share of density * t * side * wave speed
};

}  // namespace corpuscle
