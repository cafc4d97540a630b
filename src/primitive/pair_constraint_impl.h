// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_PRIMITIVE_PAIR_CONSTRAINT_IMPL_H_
#define JPRIM_SRC_PRIMITIVE_PAIR_CONSTRAINT_IMPL_H_

#include <array>
#include <string>
#include <vector>

#include "jprim/base/units.h"
#include "jprim/marker/marker.h"
#include "jprim/marker/marker_pair.h"
#include "marker/constrained_marker.h"
#include "primitive/pair_equations.h"

namespace jprim {

/// Everything about a primitive or a joint but its equations: markers, caching, and the three error levels Simbody
/// asks for. The equations of all parts stand one after the other; unused places are left alone.
///
/// The rows of the constraint Jacobian are computed once per position and their bias once per velocity:
/// Simbody asks every constraint once for each multiplier of the whole system.
class PairConstraintImpl final : public SimTK::Constraint::Custom::Implementation {
public:
    static constexpr int MaxEquations = 2 * PairEquations::MaxEquations;
    using Errors = std::array<SimTK::Real, MaxEquations>;
    using Directions = std::array<SimTK::SpatialVec, MaxEquations>;
    using Parts = std::vector<const PairEquations*>;

    PairConstraintImpl(const char* adamsType, const Parts& parts, const Marker& I, const Marker& J,
                       const std::string& name);
    Implementation* clone() const override { return new PairConstraintImpl(*this); }

    /// What the constraint is made of: one primitive's equations, or a translational primitive's and a
    /// rotational one's.
    const Parts& getParts() const { return m_parts; }
    /// e at a position of the markers.
    void calcErrors(const MarkerPair& pair, Errors& e) const;

    /// What a State can change: the markers' poses on what carries them, X_BM of a rigid marker and X_NM of a
    /// flexible one, and the equations' scales.
    struct Placements {
        Placements() : Placements({}, {}) {}
        Placements(const SimTK::Transform& X_I, const SimTK::Transform& X_J) : I(X_I), J(X_J) {
            scales.fill(1);
        }

        SimTK::Transform I;
        SimTK::Transform J;
        std::array<SimTK::Real, MaxEquations> scales;  ///< factors of the equations; with 0 they hold nothing
    };

    const char* getAdamsType() const { return m_adamsType; }
    int getNumEquations() const { return int(m_equations.size()); }
    /// What equation k holds, in words, and whether it is a length.
    const char* describeEquation(int k) const { return m_equations.at(size_t(k)).words; }
    bool isTranslational(int k) const { return m_equations.at(size_t(k)).isTranslational; }
    Dimension getDimension(int k) const { return isTranslational(k) ? Dimension::Length : Dimension::Angle; }
    /// The name if there is one, and the type: what messages call this element.
    std::string getDescription() const;
    Placements getDefaultPlacements() const { return {m_defaultI.getPose(), m_defaultJ.getPose()}; }
    void setDefaultPlacements(const Placements& placements);
    const Placements& getPlacements(const SimTK::State& state) const;
    Placements& updPlacements(SimTK::State& state) const;
    Marker getMarkerI(const SimTK::Transform& X) const { return m_defaultI.withPose(X); }
    Marker getMarkerJ(const SimTK::Transform& X) const { return m_defaultJ.withPose(X); }

    /// Load [moment, force] that the multipliers put on I, in J's axes at I's origin.
    SimTK::SpatialVec calcLoadOnI(const SimTK::State& state, const MarkerPair& pair) const;

    const std::string& getName() const { return m_name; }
    void setName(const std::string& name) { m_name = name; }

private:
    struct Equation {
        const char* words;
        bool isTranslational;
    };
    /// One row of the constraint Jacobian, in A: the unit load on I's body as [momentI about its origin,
    /// force] and on J's as [momentJ, -force]. The row's modal part, if there is one, stands apart.
    struct Row {
        SimTK::Vec3 momentI;
        SimTK::Vec3 momentJ;
        SimTK::Vec3 force;
    };
    struct PositionCache {
        Directions directions;
        std::array<Row, MaxEquations> rows;
        std::vector<SimTK::Real> modalRows;  // m_numCoordinates values for each equation: I's, then J's
    };

    void realizeTopology(SimTK::State& state) const override;
    void realizePosition(const SimTK::State& state) const override;
    void realizeVelocity(const SimTK::State& state) const override;
    void calcPositionErrors(const SimTK::State& state,
                            const SimTK::Array_<SimTK::Transform, SimTK::ConstrainedBodyIndex>& X_AB,
                            const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>& constrainedQ,
                            SimTK::Array_<SimTK::Real>& perr) const override;
    void calcPositionDotErrors(const SimTK::State& state,
                               const SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& V_AB,
                               const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>& constrainedQDot,
                               SimTK::Array_<SimTK::Real>& pverr) const override;
    void calcPositionDotDotErrors(
        const SimTK::State& state, const SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& A_AB,
        const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>& constrainedQDotDot,
        SimTK::Array_<SimTK::Real>& paerr) const override;
    void addInPositionConstraintForces(
        const SimTK::State& state, const SimTK::Array_<SimTK::Real>& multipliers,
        SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& bodyForcesInA,
        SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>& qForces) const override;
    void calcDecorativeGeometryAndAppend(const SimTK::State& state, SimTK::Stage stage,
                                         SimTK::Array_<SimTK::DecorativeGeometry>& geometry) const override;

    const PositionCache& getPositionCache(const SimTK::State& state) const;
    void calcPositionCache(const SimTK::State& state, PositionCache& cache) const;
    const Errors& getBias(const SimTK::State& state) const;
    Errors calcBodyBias(const SimTK::State& state) const;
    SimTK::Real multiply(const PositionCache& cache, int equation,
                         const SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& motions,
                         const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>& coordinates) const;
    void calcDirections(const MarkerPair& pair, Directions& d) const;
    MarkerPair findPair(const SimTK::State& state) const;
    ConstrainedMarker addMarker(const Marker& marker);

    std::string m_name;
    const char* m_adamsType;
    Parts m_parts;
    std::vector<Equation> m_equations;  // of all parts
    Marker m_defaultI;
    Marker m_defaultJ;
    int m_numCoordinates = 0;  // modal coordinates of both markers
    ConstrainedMarker m_I;
    ConstrainedMarker m_J;

    // Topology cache: where in the State our variable and cache entries are.
    mutable SimTK::SubsystemIndex m_subsystem;
    mutable SimTK::DiscreteVariableIndex m_placements;
    mutable SimTK::CacheEntryIndex m_positionCache;
    mutable SimTK::CacheEntryIndex m_bias;
};

}  // namespace jprim

#endif
