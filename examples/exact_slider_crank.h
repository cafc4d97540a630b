// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_EXAMPLES_EXACT_SLIDER_CRANK_H_
#define JPRIM_EXAMPLES_EXACT_SLIDER_CRANK_H_

#include <cmath>

/// The slider-crank of the examples and its exact motion, as functions of the crank angle phi.
///
///            A                 O (0, 0)                        bearing of the crank, turning about z
///          /   ` .             A  r (cos phi, sin phi)         crank pin
///      r /    l    ` .         P  (x, 0)                       wrist pin, in the middle of the slider
///      O ------------- P --    theta                           angle of the rod below the x axis at A
///             x                gravity acts along -y
///
/// The rod is a dumb-bell: half its mass at A, half at P. So one half turns with the crank, the other slides
/// with the slider, and for any crank angle
///
///     x          = r cos phi + sqrt(l^2 - r^2 sin^2 phi)
///     kinetic    = (J + m x'^2) phi_dot^2 / 2         J: crank and half rod about O, m: slider and half rod
///     potential  = w sin phi                          w: weight moment of crank and half rod about O
///
/// Energy conservation gives phi_dot, its derivative phi_ddot, and x_ddot = x' phi_ddot + x'' phi_dot^2.
/// m then moves under the force S of the rod along A-P and the force N of the guide along y:
///
///     m x_ddot = S cos theta,  0 = N - S sin theta - m g    =>    N = m (g + x_ddot tan theta)
struct ExactSliderCrank {
    double g = 9.80665;                  // m/s^2
    double r = 0.1;                      // m, O-A
    double l = 0.17;                     // m, A-P
    double crankMass = 2;                // kg, centre half way between O and A
    double crankInertia = 0.007;         // kg m^2, about O; 0.002 about its centre
    double rodMass = 1.2;                // kg, half at either end
    double sliderMass = 0.8;             // kg
    double phi0 = std::atan2(0.8, 0.6);  // rad: A at (0.06, 0.08) m and P at (0.21, 0) m at the start
    double phiDot0 = 0;                  // rad/s

    double J = crankInertia + rodMass / 2 * r * r;     // kg m^2
    double m = sliderMass + rodMass / 2;               // kg
    double w = g * (crankMass / 2 + rodMass / 2) * r;  // N m

    double getTanTheta(double phi) const {
        const double s = r * std::sin(phi);
        return s / std::sqrt(l * l - s * s);
    }
    double getX(double phi) const {
        const double s = r * std::sin(phi);
        return r * std::cos(phi) + std::sqrt(l * l - s * s);
    }
    /// x' = dx/dphi
    double getX1(double phi) const { return -r * (std::sin(phi) + std::cos(phi) * getTanTheta(phi)); }
    /// x'' = d2x/dphi2, with d(tan theta)/dphi = tan theta (1 + tan^2 theta) / tan phi
    double getX2(double phi) const {
        const double s = r * std::sin(phi), c = r * std::cos(phi), t = getTanTheta(phi);
        return -c + s * t - c * c / std::sqrt(l * l - s * s) * (1 + t * t);
    }
    double getInertia(double phi) const { return J + m * getX1(phi) * getX1(phi); }
    /// |phi_dot|
    double getSpeed(double phi) const {
        const double twiceKinetic =
            getInertia(phi0) * phiDot0 * phiDot0 + 2 * w * (std::sin(phi0) - std::sin(phi));
        return std::sqrt(twiceKinetic / getInertia(phi));
    }
    double getGuideForce(double phi) const {
        const double phiDot2 = getSpeed(phi) * getSpeed(phi), x1 = getX1(phi), x2 = getX2(phi);
        const double phiDDot = -(w * std::cos(phi) + m * x1 * x2 * phiDot2) / getInertia(phi);
        return m * (g + (x1 * phiDDot + x2 * phiDot2) * getTanTheta(phi));
    }
};

#endif
