// SPDX-License-Identifier: Apache-2.0
#include "simulation/undefined_force.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;

namespace {

std::string findHere(const Mechanism& mechanism, const State& state) {
    mechanism.getSystem().realize(state, SimTK::Stage::Velocity);
    for (const Element& element : mechanism.getElements()) {
        if (!element.isForce() || element.isDisabled(state)) continue;
        const SimTK::SpatialVec load = element.onI(state);
        if (!load[0].isFinite() || !load[1].isFinite()) return element.getName();
    }
    return "";
}

}  // namespace

std::string findUndefinedForce(const Mechanism& mechanism, const State& state, Real moment) {
    const std::string here = findHere(mechanism, state);
    if (!here.empty()) return here;
    mechanism.getSystem().realize(state, SimTK::Stage::Acceleration);
    State soon = state;
    soon.updTime() += moment;
    soon.updQ() += moment * state.getQDot();
    soon.updU() += moment * state.getUDot();
    return findHere(mechanism, soon);
}

}  // namespace jprim
