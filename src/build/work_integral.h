// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_BUILD_WORK_INTEGRAL_H_
#define JPRIM_SRC_BUILD_WORK_INTEGRAL_H_

#include <vector>

#include "SimTKsimbody.h"

namespace jprim {

/// The work of all applied loads, and of constraints that move with time, integrated along with a motion: whatever drives
/// or brakes a system, its kinetic energy changes by this. A force element that puts no load on anything, with one
/// state variable.
class WorkIntegral : public SimTK::Force::Custom::Implementation {
public:
    /// @param constraints  those that may do work
    WorkIntegral(const SimTK::MultibodySystem& system, const SimTK::GeneralForceSubsystem& forces,
                 std::vector<SimTK::Constraint> constraints)
        : m_system(system), m_forces(forces), m_constraints(std::move(constraints)) {}

    /// Keeps the work out of integrators' error control. Requires Stage::Model.
    void setWeight(SimTK::State& state) const;
    /// Since the State was made. Requires Stage::Model.
    SimTK::Real getWork(const SimTK::State& state) const { return m_forces.getZ(state)[m_z]; }

    void calcForce(const SimTK::State&, SimTK::Vector_<SimTK::SpatialVec>&, SimTK::Vector_<SimTK::Vec3>&,
                   SimTK::Vector&) const override {}
    SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }
    void realizeTopology(SimTK::State& state) const override;
    void realizeAcceleration(const SimTK::State& state) const override;

private:
    SimTK::Real calcPower(const SimTK::State& state) const;

    const SimTK::MultibodySystem& m_system;
    const SimTK::GeneralForceSubsystem& m_forces;
    std::vector<SimTK::Constraint> m_constraints;
    mutable SimTK::ZIndex m_z;  // topology cache
};

}  // namespace jprim

#endif
