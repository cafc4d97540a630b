// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_UNDEFINED_FORCE_H_
#define JPRIM_SRC_SIMULATION_UNDEFINED_FORCE_H_

#include <string>

#include "jprim/mechanism/mechanism.h"

namespace jprim {

/// The name of a force whose function is infinite or no number at a State, or within a moment behind it if the motion goes
/// on as it does there, such as SQRT(1 - TIME) from time 1; empty if there is none.
std::string findUndefinedForce(const Mechanism& mechanism, const SimTK::State& state, SimTK::Real moment);

constexpr const char* WhatIsUndefined =
    "its function is infinite or not a number here, as a quotient by zero or a root of a negative number are";

}  // namespace jprim

#endif
