// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_DETERMINED_H_
#define JPRIM_TESTS_SUPPORT_DETERMINED_H_

#include <string>

#include "jprim/analysis/constraint_report.h"
#include "jprim/simulation/assemble.h"
#include "support/run_dataset.h"

namespace jprim::testing {

/// Without redundant equations, whose loads nothing but the formulation decides; not near a position where some become
/// so, which no integration could follow, nor thrown into one by given velocities that hardly fit.
inline bool isDetermined(const std::string& text) {
    constexpr double Near = 0.1, Violent = 50;  // a scaled singular value; J
    const Mechanism mechanism = buildOrFail(text, {Formulation::Constraints});
    const SimTK::State given = mechanism.makeGivenState();
    mechanism.getSystem().realize(given, SimTK::Stage::Position);
    const ConstraintCount count = countFreedoms(mechanism.getMatter(), given);
    if (count.getNumRedundant() > 0 || count.getDegreesOfFreedom() == 0 || count.smallestKept < Near)
        return false;
    return mechanism.calcKineticEnergy(assemble(mechanism).state) < Violent;
}

}  // namespace jprim::testing

#endif
