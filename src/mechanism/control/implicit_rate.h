// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_CONTROL_IMPLICIT_RATE_H_
#define JPRIM_SRC_MECHANISM_CONTROL_IMPLICIT_RATE_H_

#include <optional>
#include <string>

#include "SimTKsimbody.h"
#include "jprim/marker/expression.h"
#include "marker/angle_memory.h"

namespace jprim {

/// The derivative of a state that an equation f = 0 tells, by Newton's method from the same guess at every State. To
/// Simbody it is a force element that puts no load on anything.
class ImplicitRate final : public SimTK::Force::Custom::Implementation {
public:
    ImplicitRate(const SimTK::GeneralForceSubsystem& forces, std::string name, SimTK::Real guess)
        : m_forces(forces), m_name(std::move(name)), m_guess(guess) {}

    /// Before the system is realized.
    /// @param unknown  the scalar input of the equation that is the derivative
    /// @throws Error if the equation does not depend on it
    void setEquation(const Expression& equation, int unknown);

    /// Requires the stage that the equation does. @throws Error if no derivative is found
    SimTK::Real solve(const SimTK::State& state) const;

private:
    void calcForce(const SimTK::State&, SimTK::Vector_<SimTK::SpatialVec>&, SimTK::Vector_<SimTK::Vec3>&,
                   SimTK::Vector&) const override {}
    SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }
    void realizeTopology(SimTK::State& state) const override;

    const SimTK::GeneralForceSubsystem& m_forces;
    std::string m_name;
    SimTK::Real m_guess;
    std::optional<Expression> m_equation;
    AngleMemory m_angles;
    int m_unknown = -1;
    mutable SimTK::CacheEntryIndex m_evaluation;  // topology cache
};

}  // namespace jprim

#endif
