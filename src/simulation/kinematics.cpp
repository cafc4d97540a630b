// SPDX-License-Identifier: Apache-2.0
// A step predicts positions from velocities and accelerations and corrects them by projection onto the
// constraints at the new time. Where the correction is large the step is halved, so that the mechanism does
// not jump to another of its configurations.
#include <algorithm>
#include <optional>

#include "base/format.h"
#include "jprim/base/error.h"
#include "simulation/break_watch.h"
#include "simulation/equation_access.h"
#include "simulation/projection.h"
#include "simulation/stepper.h"
#include "simulation/turning.h"

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
        : m_mechanism(mechanism),
          m_state(initial),
          m_tolerance(options.getConstraintTolerance()),
          m_breaks(BreakWatch::ofLoads(mechanism)),
          m_break(m_breaks.findAround(initial.getTime(),
                                      options.end * mechanism.getUnits().time - initial.getTime())) {
        finish(m_state);
    }

    const State& getState() const override { return m_state; }
    int getNumSteps() const override { return m_numSteps; }

    void step(Real time) override {
        const Real end = crossBreaks(time), whole = end - m_state.getTime();
        if (whole <= 0) return;
        Real h = std::min(whole, calcTimeOfARadian(m_mechanism, m_state));
        for (int k = 0; k < MostHalvings; ++k, h /= 2) {
            State next = m_state;
            next.updTime() = h == whole ? end : m_state.getTime() + h;
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
    // Those where the State stands. A kink of a MOTION is no harm: positions, velocities and accelerations are right on both
    // sides of it. Returns where the next step has to end.
    Real crossBreaks(Real time) {
        const auto now = [this] { return m_state.getTime(); };
        std::optional<TimeBreak> next = m_break;
        if (!next || now() < next->before || next->behind <= now()) next = m_breaks.findNext(now(), time);
        while (next && next->before <= now() && now() < time) {
            State there = m_state;
            there.updTime() = std::min(next->behind, time);
            BreakWatch::requireNoJump(m_mechanism, m_state, there.getTime(), KinematicLevel::Position);
            project(there);
            there.autoUpdateDiscreteVariables();
            m_state = there;
            finish(m_state);
            m_break = next;
            next = m_breaks.findNext(std::max(now(), next->behind), time);
        }
        return next ? std::min(time, next->before) : time;
    }

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
    BreakWatch m_breaks;
    std::optional<TimeBreak> m_break;  // the last that was crossed, or where the State stood at first
    int m_numSteps = 0;
};

}  // namespace

std::unique_ptr<Stepper> makeKinematics(const Mechanism& mechanism, const State& initial,
                                        const SimulationOptions& options) {
    return std::make_unique<Kinematics>(mechanism, initial, options);
}

}  // namespace jprim
