// SPDX-License-Identifier: Apache-2.0
#include "jprim/simulation/equilibrium.h"
#include "simulation/stepper.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;

namespace {

class Statics final : public Stepper {
public:
    Statics(const Mechanism& mechanism, const State& initial)
        : m_mechanism(mechanism), m_state(findEquilibrium(mechanism, initial)) {}

    const State& getState() const override { return m_state; }
    int getNumSteps() const override { return m_numSteps; }

    void step(Real time) override {
        State next = m_state;
        next.updTime() = time;
        m_state = findEquilibrium(m_mechanism, next);
        ++m_numSteps;
    }

private:
    const Mechanism& m_mechanism;
    State m_state;
    int m_numSteps = 0;
};

}  // namespace

std::unique_ptr<Stepper> makeStatics(const Mechanism& mechanism, const State& initial) {
    return std::make_unique<Statics>(mechanism, initial);
}

}  // namespace jprim
