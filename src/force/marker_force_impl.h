// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FORCE_MARKER_FORCE_IMPL_H_
#define JPRIM_SRC_FORCE_MARKER_FORCE_IMPL_H_

#include <string>

#include "jprim/force/marker_force.h"
#include "marker/tracked_expression.h"

namespace jprim {

/// What is wrong with a value in the expression of a force, or empty.
std::string findForceProblem(KinematicLevel level);

class MarkerForceImpl final : public SimTK::Force::Custom::Implementation {
public:
    MarkerForceImpl(SimTK::GeneralForceSubsystem& forces, const Marker& I, const std::optional<Marker>& J,
                    const ForceLaw& law, const std::string& name);

    const std::string& getName() const { return m_name; }
    std::string getDescription() const;
    bool isDisabled(const SimTK::State& state, SimTK::ForceIndex index) const;
    SimTK::SpatialVec calcLoadOnI(const SimTK::State& state) const;
    SimTK::SpatialVec calcLoadOnJ(const SimTK::State& state) const;
    SimTK::Real calcPotentialRate(const SimTK::State& state) const;

    /// What it takes from the energy that its potential does not tell of, negative. Requires Stage::Velocity.
    SimTK::Real calcPower(const SimTK::State& state) const;
    /// Of force and moment, as TrackedExpression has them.
    void addSwitches(const SimTK::State& state, std::vector<TrackedExpression::Switch>& switches) const;
    std::vector<const MarkerExpression*> getExpressions() const;

    // Those of force, moment and potential, one after the other.
    int getNumAngles() const;
    SimTK::Vector getTurns(const SimTK::State& state) const;
    void setTurns(SimTK::State& state, const SimTK::Vector& turns) const;

private:
    void realizeTopology(SimTK::State& state) const override;
    void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& bodyForces,
                   SimTK::Vector_<SimTK::Vec3>& particleForces, SimTK::Vector& mobilityForces) const override;
    SimTK::Real calcPotentialEnergy(const SimTK::State& state) const override;

    const SimTK::Subsystem::Guts* m_forces;  // the caller's handle of it may go away
    std::string m_name;
    Marker m_I;
    std::optional<Marker> m_J;
    mutable std::optional<TrackedExpression> m_force, m_moment,
        m_potential;  // mutable: their topology caches
};

}  // namespace jprim

#endif
