// SPDX-License-Identifier: Apache-2.0
// A step predicts positions from velocities and accelerations and corrects them by projection onto the
// constraints at the new time. Where the correction is large the step is halved, so that the mechanism does
// not jump to another of its configurations.
#include <algorithm>

#include "base/format.h"
#include "jprim/base/error.h"
#include "simulation/equation_access.h"
#include "simulation/projection.h"
#include "simulation/stepper.h"

namespace jprim {

using SimTK::Real;
using SimTK::Stage;
using SimTK::State;
using SimTK::Vector;

namespace {

constexpr Real LargestCorrection = 0.05;  // of a coordinate: length units, radians
constexpr int MostHalvings = 20;

class Kinematics final : public Stepper {
public:
    Kinematics(const Mechanism& mechanism, const State& initial, const SimulationOptions& options)
        : m_mechanism(mechanism), m_state(initial), m_tolerance(options.getConstraintTolerance()) {
        finish(m_state);
    }

    const State& getState() const override { return m_state; }
    int getNumSteps() const override { return m_numSteps; }

    void step(Real time) override {
        const Real whole = time - m_state.getTime();
        Real h = std::min(whole, calcTimeOfARadian(m_mechanism, m_state));
        for (int k = 0; k < MostHalvings; ++k, h /= 2) {
            State next = m_state;
            next.updTime() = h == whole ? time : m_state.getTime() + h;
            if (!tryStep(h, next)) continue;
            next.autoUpdateDiscreteVariables();
            m_state = next;
            finish(m_state);
            ++m_numSteps;
            return;
        }
        throw std::runtime_error(
            "the positions at the next time cannot be found; the mechanism may lock there, or a MOTION "
            "jump");
    }

private:
    bool tryStep(Real h, State& next) const {
        Vector qDot;
        m_mechanism.getMatter().multiplyByN(m_state, false,
                                            Vector(m_state.getU() + h / 2 * m_state.getUDot()), qDot);
        next.updQ() += h * qDot;
        next.updU() += h * m_state.getUDot();
        const Vector predicted = next.getQ();
        try {
            project(next);
        } catch (const Error&) {
            throw;
        } catch (const std::exception&) {
            return false;
        }
        return predicted.size() == 0 || Vector(next.getQ() - predicted).normInf() <= LargestCorrection;
    }

    // One step more than the tolerance needs: Newton's method then is at rounding.
    void project(State& state) const {
        const SimTK::MultibodySystem& system = m_mechanism.getSystem();
        SimTK::ProjectResults results;
        Vector noErrors;
        system.realize(state, Stage::Position);
        system.projectQ(state, noErrors, SimTK::ProjectOptions(m_tolerance), results);
        projectAtLeastOnce(system, state, m_tolerance);
    }

    void finish(State& state) const {
        m_mechanism.getSystem().realize(state, Stage::Position);
        setEquationScalesHere(m_mechanism, state);
        m_mechanism.getSystem().realize(state, Stage::Acceleration);
    }

    const Mechanism& m_mechanism;
    State m_state;
    Real m_tolerance;
    int m_numSteps = 0;
};

}  // namespace

std::unique_ptr<Stepper> makeKinematics(const Mechanism& mechanism, const State& initial,
                                        const SimulationOptions& options) {
    return std::make_unique<Kinematics>(mechanism, initial, options);
}

}  // namespace jprim
