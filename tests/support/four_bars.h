// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_FOUR_BARS_H_
#define JPRIM_TESTS_SUPPORT_FOUR_BARS_H_

#include <cmath>
#include <string>

#include "base/format.h"

namespace jprim::testing {

/// A row of N four-bars that share their rockers: N + 1 rockers, N couplers, all uniform links of 1 kg and 1 m with
/// hinges at their ends, at the start turned by `angle` from upright and moving at 1 m/s at the top, under gravity of 9.81 m/s^2. The top
/// of the first rocker is MARKER/2002. Source: IFToMM multibody benchmark library, problem A02.
inline std::string writeFourBars(int n, double angle = 0) {
    std::string text = "N four-bars\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\n";
    const double sine = std::sin(angle), cosine = std::cos(angle);
    const auto addLink = [&text](int id, double x, double y, double turned, const std::string& rest) {
        const double I = 1. / 12;
        text += fmt::format(
            "PART/{0},MASS=1,CM={0}0,IP={1},{1},{1},QG={2},{3},0,REULER={4},0,0,VZ=0,WX=0,WY=0,{5}\n"
            "MARKER/{0}0,QP=0.5,0,0\nMARKER/{0}1\nMARKER/{0}2,QP=1,0,0\n",
            id, I, x, y, turned, rest);
    };
    auto addHinge = [&text, id = 0](int i, int j) mutable {
        text += fmt::format("JOINT/{},REVOLUTE,I={},J={}\n", ++id, i, j);
    };
    const int rocker = 200, coupler = 100000;
    for (int k = 0; k <= n; ++k) {
        text += fmt::format("MARKER/{},PART=1,QP={},0,0\n", k + 1, k);
        addLink(rocker + k, k, 0, std::acos(0.) - angle,
                fmt::format("VX={},VY={},WZ=-1", cosine / 2, -sine / 2));
        if (k < n) addLink(coupler + k, k + sine, cosine, 0, fmt::format("VX={},VY={},WZ=0", cosine, -sine));
    }
    for (int k = 0; k <= n; ++k) addHinge(10 * (rocker + k) + 1, k + 1);
    for (int k = 0; k < n; ++k) {
        addHinge(10 * (coupler + k) + 1, 10 * (rocker + k) + 2);
        addHinge(10 * (coupler + k) + 2, 10 * (rocker + k + 1) + 2);
    }
    return text + "END\n";
}

/// The angle of the rockers from upright, where they were at `start`. On the branch that is smooth through singular positions all links together are one
/// pendulum: J d2a/dt2 = G sin a. Integrated by a Runge-Kutta method of fourth order with steps far below need.
inline double calcFourBarsAngle(int n, double time, double start = 0) {
    const double J = (n + 1) / 3. + n, G = 9.81 * ((n + 1) / 2. + n);
    constexpr int Steps = 20000;
    const double h = time / Steps;
    double a = start, w = 1;
    for (int k = 0; k < Steps; ++k) {
        const auto b = [&](double angle) { return G / J * std::sin(angle); };
        const double w2 = w + h / 2 * b(a), w3 = w + h / 2 * b(a + h / 2 * w), w4 = w + h * b(a + h / 2 * w2);
        const double next = a + h / 6 * (w + 2 * w2 + 2 * w3 + w4);
        w += h / 6 * (b(a) + 2 * b(a + h / 2 * w) + 2 * b(a + h / 2 * w2) + b(a + h * w3));
        a = next;
    }
    return a;
}

}  // namespace jprim::testing

#endif
