// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_WORK_INTEGRAL_H_
#define JPRIM_SRC_MECHANISM_WORK_INTEGRAL_H_

#include <functional>

#include "SimTKsimbody.h"

namespace jprim {

/// Integrates a power along with the motion: a force element that puts no load on anything, with one state variable.
/// That is so small that it changes no integrator's estimate of errors; CPodes alone has one variable more to average
/// errors over.
class WorkIntegral final : public SimTK::Force::Custom::Implementation {
public:
    using Power = std::function<SimTK::Real(const SimTK::State&)>;

    /// @param power  may require the stage in which accelerations and multipliers are known
    WorkIntegral(const SimTK::GeneralForceSubsystem& forces, const Power& power)
        : m_forces(forces), m_power(power) {}

    /// Since the State was made. Requires Stage::Model.
    SimTK::Real getWork(const SimTK::State& state) const { return m_forces.getZ(state)[m_z] / Small; }

    void calcForce(const SimTK::State&, SimTK::Vector_<SimTK::SpatialVec>&, SimTK::Vector_<SimTK::Vec3>&,
                   SimTK::Vector&) const override {}
    SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }
    void realizeTopology(SimTK::State& state) const override {
        m_z = m_forces.allocateZ(state, SimTK::Vector(1, SimTK::Real(0)));
    }
    void realizeAcceleration(const SimTK::State& state) const override {
        m_forces.updZDot(state)[m_z] = Small * m_power(state);
    }

private:
    static constexpr SimTK::Real Small = 0x1p-200;  // a power of 2 costs no digit

    const SimTK::GeneralForceSubsystem& m_forces;
    Power m_power;
    mutable SimTK::ZIndex m_z;  // topology cache
};

}  // namespace jprim

#endif
