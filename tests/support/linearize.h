// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_LINEARIZE_H_
#define JPRIM_TESTS_SUPPORT_LINEARIZE_H_

#include <Simbody.h>

#include <vector>

namespace jprim::testing {

/// A system to put flexible bodies into.
struct FlexibleSystem {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    SimTK::GeneralForceSubsystem forces{system};
};

/// Circular frequencies of small vibrations about a state at rest without load, ascending, from differences
/// of Simbody's accelerations; motions without resistance and those that constraints forbid are left out.
std::vector<double> calcFrequencies(const FlexibleSystem& system, const SimTK::State& state);

/// The generalized speeds of the vibration with the lowest frequency, of length 1.
SimTK::Vector calcFirstMode(const FlexibleSystem& system, const SimTK::State& state);

/// Changes positions until nothing accelerates from rest, by Newton's method on the same differences.
void findEquilibrium(const FlexibleSystem& system, SimTK::State& state);

/// Expects one of the frequencies within a relative tolerance of the expected one.
void expectFrequency(const std::vector<double>& frequencies, double expected, double tolerance);

/// Integrates to a time in at least 500 steps; calls `observe` with each step's state.
template <class Observe>
SimTK::State integrate(const FlexibleSystem& system, const SimTK::State& initial, double end, double accuracy,
                       Observe observe) {
    SimTK::RungeKuttaMersonIntegrator integrator(system.system);
    integrator.setAccuracy(accuracy);
    integrator.setConstraintTolerance(accuracy / 10);
    integrator.setReturnEveryInternalStep(true);
    integrator.setMaximumStepSize(end / 500);
    integrator.setAllowInterpolation(false);
    integrator.initialize(initial);
    while (integrator.getTime() < end) {
        integrator.stepTo(end, end);
        system.system.realize(integrator.getState(), SimTK::Stage::Acceleration);
        observe(integrator.getState());
    }
    SimTK::State last = integrator.getState();  // a copy knows only its variables
    system.system.realize(last, SimTK::Stage::Acceleration);
    return last;
}

}  // namespace jprim::testing

#endif
