// SPDX-License-Identifier: Apache-2.0
#include "analysis/equation_loads.h"

namespace jprim {

using SimTK::Constraint;
using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;

namespace {

int countEquations(const Constraint& constraint, const State& state) {
    int positions = 0, velocities = 0, accelerations = 0;
    constraint.getNumConstraintEquationsInUse(state, positions, velocities, accelerations);
    return positions + velocities + accelerations;
}

// The speed of the system that each speed of a constraint is, in the constraint's order.
std::vector<int> findSpeeds(const Constraint& constraint, const State& state) {
    std::vector<int> speeds(size_t(constraint.getNumConstrainedU(state)));
    for (SimTK::ConstrainedMobilizerIndex m(0); m < constraint.getNumConstrainedMobilizers(); ++m) {
        const SimTK::MobilizedBody& body = constraint.getMobilizedBodyFromConstrainedMobilizer(m);
        for (int k = 0; k < constraint.getNumConstrainedU(state, m); ++k)
            speeds[size_t(constraint.getConstrainedUIndex(state, m, SimTK::MobilizerUIndex(k)))] =
                int(body.getFirstUIndex(state)) + k;
    }
    return speeds;
}

}  // namespace

std::vector<EquationLoads> calcEquationLoads(const SimTK::SimbodyMatterSubsystem& matter, const State& state,
                                             const std::vector<ConstraintEquation>& equations) {
    std::vector<EquationLoads> all;
    SimTK::Vector_<SpatialVec> onBodiesInA;
    SimTK::Vector onSpeeds;
    for (const ConstraintEquation& equation : equations) {
        const Constraint& constraint = matter.getConstraint(equation.constraint);
        SimTK::Vector multipliers(countEquations(constraint, state), Real(0));
        multipliers[equation.number] = 1;
        constraint.calcConstraintForcesFromMultipliers(state, multipliers, onBodiesInA, onSpeeds);
        EquationLoads loads;
        const SimTK::Rotation R_GA = constraint.getNumConstrainedBodies() > 0
                                         ? constraint.getAncestorMobilizedBody().getBodyRotation(state)
                                         : SimTK::Rotation();
        for (SimTK::ConstrainedBodyIndex b(0); b < constraint.getNumConstrainedBodies(); ++b) {
            const SpatialVec& F = onBodiesInA[int(b)];
            if (F[0] == Vec3(0) && F[1] == Vec3(0)) continue;
            loads.onBodies.emplace_back(
                constraint.getMobilizedBodyFromConstrainedBody(b).getMobilizedBodyIndex(), R_GA * F);
        }
        const std::vector<int> speeds = findSpeeds(constraint, state);
        for (int k = 0; k < onSpeeds.size(); ++k)
            if (onSpeeds[k] != 0) loads.onSpeeds.emplace_back(speeds[size_t(k)], onSpeeds[k]);
        all.push_back(std::move(loads));
    }
    return all;
}

}  // namespace jprim
