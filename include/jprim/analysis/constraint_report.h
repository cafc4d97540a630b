// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_ANALYSIS_CONSTRAINT_REPORT_H_
#define JPRIM_ANALYSIS_CONSTRAINT_REPORT_H_

#include "SimTKsimbody.h"

namespace jprim {

/// How much the constraints of a system leave free.
struct ConstraintReport {
    int mobilities = 0;  ///< generalized speeds
    int equations = 0;   ///< constraint equations in use
    int rank = 0;        ///< independent ones among them, at the state analyzed

    /// Grübler's count: what would be free if all equations were independent. May be negative.
    int getGrueblerCount() const { return mobilities - equations; }
    int getDegreesOfFreedom() const { return mobilities - rank; }
    int getNumRedundant() const { return equations - rank; }
};

/// Counts freedoms by the rank of the constraint Jacobian, scaled so that units do not matter. In a singular
/// position the rank is that of the position. Mobilities with prescribed motion count as free. Requires
/// Stage::Position.
ConstraintReport analyzeConstraints(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::State& state);

}  // namespace jprim

#endif
