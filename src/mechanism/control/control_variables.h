// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_CONTROL_CONTROL_VARIABLES_H_
#define JPRIM_SRC_MECHANISM_CONTROL_CONTROL_VARIABLES_H_

#include <map>
#include <vector>

#include "jprim/mechanism/mechanism.h"
#include "mechanism/control/implicit_rate.h"

namespace jprim {

/// What control systems keep in a State: a z for each state of DIFF, LSE and TFSISO, and for each SENSOR the value that
/// SENVAL gives. To Simbody it is a force element that puts no load on anything.
class ControlVariables final : public SimTK::Force::Custom::Implementation {
public:
    /// @param initial   the states at the start
    /// @param timeUnit  in which rates are given [s]
    ControlVariables(const SimTK::GeneralForceSubsystem& forces, std::vector<SimTK::Real> initial,
                     int numSensors, SimTK::Real timeUnit)
        : m_forces(forces), m_initial(std::move(initial)), m_numSensors(numSensors), m_timeUnit(timeUnit) {}

    /// The derivatives of all states, before the system is realized.
    void setStates(const std::vector<MechanismState>& states) { m_states = states; }

    /// The solver for the derivative of an implicit state, which the system owns.
    void setImplicitRate(size_t k, ImplicitRate* rate) { m_implicitRates[k] = rate; }
    ImplicitRate* getImplicitRate(size_t k) const { return m_implicitRates.at(k); }

    /// Requires Stage::Model.
    SimTK::Real getState(const SimTK::State& state, size_t k) const {
        return m_forces.getZ(state)[m_z + int(k)];
    }
    void setState(SimTK::State& state, size_t k, SimTK::Real value) const {
        m_forces.updZ(state)[m_z + int(k)] = value;
    }
    /// In the unit of time in which rates are given. Requires Stage::Acceleration.
    SimTK::Real getRate(const SimTK::State& state, size_t k) const {
        return m_timeUnit * m_forces.getZDot(state)[m_z + int(k)];
    }

    SimTK::Real getSensorValue(const SimTK::State& state, size_t k) const {
        return SimTK::Value<SimTK::Vector>::downcast(m_forces.getDiscreteVariable(state, m_sensors))
            .get()[int(k)];
    }
    void setSensorValue(SimTK::State& state, size_t k, SimTK::Real value) const {
        SimTK::Value<SimTK::Vector>::updDowncast(m_forces.updDiscreteVariable(state, m_sensors))
            .upd()[int(k)] = value;
    }

private:
    void calcForce(const SimTK::State&, SimTK::Vector_<SimTK::SpatialVec>&, SimTK::Vector_<SimTK::Vec3>&,
                   SimTK::Vector&) const override {}
    SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }
    void realizeTopology(SimTK::State& state) const override;
    void realizeAcceleration(const SimTK::State& state) const override;

    const SimTK::GeneralForceSubsystem& m_forces;
    std::vector<SimTK::Real> m_initial;
    int m_numSensors;
    SimTK::Real m_timeUnit;
    std::vector<MechanismState> m_states;
    std::map<size_t, ImplicitRate*> m_implicitRates;

    // Topology cache.
    mutable SimTK::ZIndex m_z;
    mutable SimTK::DiscreteVariableIndex m_sensors;
};

}  // namespace jprim

#endif
