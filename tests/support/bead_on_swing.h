// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_BEAD_ON_SWING_H_
#define JPRIM_TESTS_SUPPORT_BEAD_ON_SWING_H_

#include <string>

#include "base/format.h"

namespace jprim::testing {

/// A bead on a straight wire that is part of a swinging frame, with products of inertia, initial velocities
/// and every kind of request, written in any units: L, M, T are what 1 m, 1 kg and 1 s are in them.
inline std::string makeBeadOnSwing(const std::string& units, double L, double M, double T) {
    const auto point = [L](double x, double y, double z) {
        return fmt::format("{},{},{}", x * L, y * L, z * L);
    };
    const double I = M * L * L;
    return fmt::format("bead on a swing\n{}\nACCGRAV/JGRAV={}\n", units, -9.81 * L / (T * T)) +
           "PART/1,GROUND\nMARKER/10,QP=" + point(0.3, 1, 0.2) +
           fmt::format("\nPART/2,QG={},MASS={},CM=20,IP={},{},{},{},{},{},WZ={}\n", point(0.3, 1, 0.2), 2 * M,
                       0.2 * I, 0.3 * I, 0.25 * I, 0.01 * I, -0.02 * I, 0.015 * I, 0.7 / T) +
           "MARKER/20,QP=" + point(0.1, -0.4, 0.05) +
           "\nMARKER/21\nMARKER/22,REULER=80D,75D,10D,QP=" + point(0.1, -0.5, 0) +
           fmt::format("\nPART/3,QG={},REULER=80D,75D,10D,MASS={},CM=30,IP={},{},{},VX={}\n",
                       point(0.4, 0.5, 0.2), 0.5 * M, 0.01 * I, 0.02 * I, 0.015 * I, 0.2 * L / T) +
           "MARKER/30\nMARKER/31\nJOINT/1,REVOLUTE,I=21,J=10\nJPRIM/2,INLINE,I=31,J=22\n"
           "JPRIM/3,PARALLEL_AXES,I=31,J=22\nREQUEST/1,DISPLACEMENT,I=30,J=10,RM=22\n"
           "REQUEST/2,VELOCITY,I=30,J=22,RM=22\nREQUEST/3,ACCELERATION,I=30,J=10\n"
           "REQUEST/4,FORCE,I=31,J=22,RM=22\nREQUEST/5,FORCE,I=10,J=21\nEND\n";
}

}  // namespace jprim::testing

#endif
