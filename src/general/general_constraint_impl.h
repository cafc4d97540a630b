// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_GENERAL_GENERAL_CONSTRAINT_IMPL_H_
#define JPRIM_SRC_GENERAL_GENERAL_CONSTRAINT_IMPL_H_

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jprim/base/units.h"
#include "jprim/marker/expression.h"
#include "marker/angle_memory.h"
#include "marker/constrained_marker.h"

namespace jprim {

/// Adams' words for what is not a joint.
constexpr const char *Gcon = "GCON", *DrivenCoordinate = "MOTION";

/// What messages call an element: its name, after which a joint tells its type; or the type alone.
std::string describeGeneral(const char* adamsType, const std::string& name);

/// One equation scale (q^(d) - g) = 0. q is the expression, of positions or linear in velocities; g a
/// function of time, zero for a GCON; d the derivative of q that g prescribes.
///
/// With q' the rate of q that is linear in velocities - dq/dt of positions, q itself of velocities -
///
///     q'  = sum over bodies of direction . V + q'_0,      load on a body: lambda direction
///     q'' = sum over bodies of direction . A + bias
///
/// directions and q'_0 are computed once per position, the bias once per velocity.
///
/// What whole turns of an angle in q change may be known to be whole periods of the error. Such turns need no
/// memory: the error is what is left of its periods.
class GeneralConstraintImpl final : public SimTK::Constraint::Custom::Implementation {
public:
    /// @param adamsType  a literal: Gcon, DrivenCoordinate or that of a joint
    /// @param function   null if the equation is q = 0
    GeneralConstraintImpl(const char* adamsType, const Expression& coordinate, const Expression* function,
                          KinematicLevel level, SimTK::Real period, const std::string& name);
    Implementation* clone() const override { return new GeneralConstraintImpl(*this); }

    const std::string& getName() const { return m_name; }
    const char* getAdamsType() const { return m_adamsType; }
    std::string getDescription() const { return describeGeneral(m_adamsType, m_name); }
    const Marker& getMarker(int key) const;
    bool isHolonomic() const { return m_equationLevel == KinematicLevel::Position; }
    /// A length if the expression depends on where markers are, and not only on how they are turned.
    Dimension getDimension() const;
    void setScale(SimTK::Real scale) {
        invalidateTopologyCache();
        m_scale = scale;
    }
    /// A factor besides the default one; with 0 the equation is 0 = 0.
    SimTK::Real getStateScale(const SimTK::State& state) const;
    void setStateScale(SimTK::State& state, SimTK::Real scale) const;
    SimTK::Real calcEquationError(const SimTK::State& state) const;
    std::string findProblem(const SimTK::State& state) const;
    SimTK::Vector getTurns(const SimTK::State& state) const;
    void setTurns(SimTK::State& state, const SimTK::Vector& turns) const;
    const MarkerExpression& getCoordinate() const { return *m_coordinate; }
    const MarkerExpression* getFunction() const { return m_function.get(); }  ///< null if there is none
    int getNumAngles() const { return m_coordinate->program.getNumAngles(); }
    /// [moment, force] in Ground on a marker at its origin.
    SimTK::SpatialVec calcLoadOn(const SimTK::State& state, int markerId) const;

private:
    using Poses = SimTK::Array_<SimTK::Transform, SimTK::ConstrainedBodyIndex>;
    using Motions = SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>;
    using Reals = SimTK::Array_<SimTK::Real>;
    template <class Index>
    using Coordinates = SimTK::Array_<SimTK::Real, Index>;

    /// What is kept in the State.
    struct PositionCache {
        std::vector<SimTK::SpatialVec> directions;  // by body, about its origin
        std::vector<SimTK::Real> modalDirections;   // by modal coordinate
        SimTK::Real value = 0;                      // of the expression, at rest
        SimTK::Real rateAtRest = 0;                 // q'_0
        std::vector<MarkerMotion> motions;          // poses, and room for the rest
        std::optional<Evaluation> coordinate, function;
    };

    void realizeTopology(SimTK::State& state) const override;
    void realizePosition(const SimTK::State& state) const override;
    void realizeVelocity(const SimTK::State& state) const override;
    void calcPositionErrors(const SimTK::State& state, const Poses& X_AB,
                            const Coordinates<SimTK::ConstrainedQIndex>& q, Reals& e) const override;
    void calcPositionDotErrors(const SimTK::State& state, const Motions& V_AB,
                               const Coordinates<SimTK::ConstrainedQIndex>& qDot, Reals& e) const override;
    void calcPositionDotDotErrors(const SimTK::State& state, const Motions& A_AB,
                                  const Coordinates<SimTK::ConstrainedQIndex>& qDotDot,
                                  Reals& e) const override;
    void addInPositionConstraintForces(const SimTK::State& state, const Reals& lambda, Motions& forces_A,
                                       Coordinates<SimTK::ConstrainedQIndex>& qForces) const override;
    void calcVelocityErrors(const SimTK::State& state, const Motions& V_AB,
                            const Coordinates<SimTK::ConstrainedUIndex>& u, Reals& e) const override;
    void calcVelocityDotErrors(const SimTK::State& state, const Motions& A_AB,
                               const Coordinates<SimTK::ConstrainedUIndex>& uDot, Reals& e) const override;
    void addInVelocityConstraintForces(const SimTK::State& state, const Reals& lambda, Motions& forces_A,
                                       Coordinates<SimTK::ConstrainedUIndex>& uForces) const override;
    void calcAccelerationErrors(const SimTK::State& state, const Motions& A_AB,
                                const Coordinates<SimTK::ConstrainedUIndex>& uDot, Reals& e) const override;
    void addInAccelerationConstraintForces(const SimTK::State& state, const Reals& lambda, Motions& forces_A,
                                           Coordinates<SimTK::ConstrainedUIndex>& uForces) const override;

    void addMarkers();
    std::string findVanished(const PositionCache& cache, SimTK::Real distance) const;
    std::string findImpossible(const SimTK::State& state, const PositionCache& cache) const;
    PositionCache& updPositionCache(const SimTK::State& state) const;
    const PositionCache& getPositionCache(const SimTK::State& state) const;
    void placeMarkers(const SimTK::State& state, PositionCache& cache) const;  // at rest
    void calcPositionCache(const SimTK::State& state, PositionCache& cache) const;
    SimTK::Real getBias(const SimTK::State& state) const;
    SimTK::Real calcBias(const SimTK::State& state) const;
    bool impliesTurns() const;
    SimTK::Real reduce(SimTK::Real error) const;  // by whole periods
    SimTK::Real getScale(const SimTK::State& state) const { return getStateScale(state) * m_scale; }
    Taylor<SimTK::Real> calcFunction(const SimTK::State& state) const;
    template <class Index>
    SimTK::Real multiply(const SimTK::State& state, const Motions& motions,
                         const Coordinates<Index>& coordinates) const;
    template <class Index>
    void addForces(const SimTK::State& state, const Reals& lambda, Motions& forces_A,
                   Coordinates<Index>& modalForces) const;

    const char* m_adamsType;
    std::string m_name;
    std::shared_ptr<const MarkerExpression> m_coordinate;
    std::shared_ptr<const MarkerExpression> m_function;  // may be null
    KinematicLevel m_equationLevel;
    SimTK::Real m_period;
    AngleMemory m_angles;  // empty if the equation itself says in which turn its angle is
    SimTK::Real m_scale = 1;
    std::vector<ConstrainedMarker> m_markers;  // as in m_coordinate
    int m_numBodies = 0;
    int m_numCoordinates = 0;

    // Topology cache.
    mutable SimTK::SubsystemIndex m_subsystem;
    mutable SimTK::CacheEntryIndex m_positionCache;
    mutable SimTK::CacheEntryIndex m_bias;
    mutable SimTK::DiscreteVariableIndex m_stateScale;
};

}  // namespace jprim

#endif
