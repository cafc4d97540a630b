// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_PRIMITIVE_PRIMITIVE_IMPL_H_
#define JPRIM_SRC_PRIMITIVE_PRIMITIVE_IMPL_H_

#include <array>
#include <string>
#include <vector>

#include "jprim/marker/marker.h"
#include "jprim/marker/marker_pair.h"
#include "marker/constrained_marker.h"

namespace jprim {

/// Everything about a primitive but its equations: markers, caching, and the three error levels Simbody
/// asks for. A primitive has at most three equations; unused places are left alone.
///
/// The rows of the constraint Jacobian are computed once per position and their bias once per velocity:
/// Simbody asks every constraint once for each multiplier of the whole system.
class PrimitiveImpl : public SimTK::Constraint::Custom::Implementation {
public:
    static constexpr int MaxEquations = 3;
    using Errors = SimTK::Vec3;
    using Directions = std::array<SimTK::SpatialVec, MaxEquations>;

    /// @name The equations, on the motion [w, v] of I relative to J. All vectors are in J.
    ///@{
    /// e.
    virtual void calcErrors(const MarkerPair& pair, Errors& e) const = 0;
    /// d_k = [t, f] with de_k/dt = t.w + f.v; lambda_k d_k is also the load on I at I's origin.
    virtual void calcDirections(const MarkerPair& pair, Directions& d) const = 0;
    /// The part of d2e/dt2 that depends on velocity: d2e_k/dt2 = t.dw/dt + f.dv/dt + bias_k.
    virtual void calcBias(const MarkerPair& pair, const SimTK::SpatialVec& V_J, Errors& bias) const = 0;
    ///@}

    /// True if equations are lengths and loads are forces, false if they are angles and torques.
    bool isTranslational() const { return m_isTranslational; }

    /// What a State can change: the markers' poses on what carries them, X_BM of a rigid marker and X_NM of a
    /// flexible one, and equations switched off.
    struct Placements {
        SimTK::Transform I;
        SimTK::Transform J;
        std::array<bool, MaxEquations> isDropped{};  ///< equations that hold nothing
    };

    const char* getAdamsType() const { return m_adamsType; }
    int getNumEquations() const { return m_numEquations; }
    /// What equation k holds, in words.
    const char* describeEquation(int k) const { return m_words.at(size_t(k)); }
    /// The name if there is one, and the type: what messages call this element.
    std::string getDescription() const;
    Placements getDefaultPlacements() const { return {m_defaultI.getPose(), m_defaultJ.getPose(), {}}; }
    void setDefaultPlacements(const Placements& placements);
    const Placements& getPlacements(const SimTK::State& state) const;
    Placements& updPlacements(SimTK::State& state) const;
    Marker getMarkerI(const SimTK::Transform& X) const { return m_defaultI.withPose(X); }
    Marker getMarkerJ(const SimTK::Transform& X) const { return m_defaultJ.withPose(X); }

    /// Load [moment, force] that the multipliers put on I, in J's axes at I's origin.
    SimTK::SpatialVec calcLoadOnI(const SimTK::State& state, const MarkerPair& pair) const;

    const std::string& getName() const { return m_name; }
    void setName(const std::string& name) { m_name = name; }

protected:
    enum class Kind { Translational, Rotational };
    /// One entry of words for each equation.
    using Words = std::vector<const char*>;
    PrimitiveImpl(const char* adamsType, Kind kind, const Words& words, const Marker& I, const Marker& J,
                  const std::string& name);

private:
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
    MarkerPair findPair(const SimTK::State& state) const;
    ConstrainedMarker addMarker(const Marker& marker);

    std::string m_name;
    const char* m_adamsType;
    bool m_isTranslational;
    Words m_words;
    int m_numEquations;
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
