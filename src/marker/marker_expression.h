// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MARKER_MARKER_EXPRESSION_H_
#define JPRIM_SRC_MARKER_MARKER_EXPRESSION_H_

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "expression/evaluation.h"
#include "jprim/marker/marker.h"

namespace jprim {

/// How a marker moves in Ground: pose, [w, v] and [b, a] of its origin. What an expression does not depend on
/// may be left out.
struct MarkerMotion {
    SimTK::Transform X;
    SimTK::SpatialVec V{SimTK::Vec3(0), SimTK::Vec3(0)};
    SimTK::SpatialVec A{SimTK::Vec3(0), SimTK::Vec3(0)};
};

/// The units of an expression's numbers, in the system's. Its angles are radians.
struct ExpressionUnits {
    SimTK::Real length = 1;
    SimTK::Real time = 1;
};

/// What a vector input of an expression's program is, of one of its markers.
enum class MarkerQuantity {
    Origin,
    AxisX,
    AxisY,
    AxisZ,
    Velocity,
    AngularVelocity,
    Acceleration,
    AngularAcceleration
};

/// What the inputs of an expression's program are.
struct ExpressionInputs {
    struct VectorInput {
        int marker = 0;  ///< place in `markers`
        MarkerQuantity quantity = MarkerQuantity::Origin;
    };
    using StateFunction = std::function<SimTK::Real(const SimTK::State&)>;
    struct ScalarInput {
        StateFunction calc;      ///< empty for time
        StateFunction calcRate;  ///< its time derivative, at Stage::Acceleration; empty if it is not known
    };

    ExpressionUnits units;
    std::vector<Marker> markers;
    std::vector<int> markerIds;             ///< of `markers`
    std::vector<VectorInput> vectorInputs;  ///< of the program
    std::vector<ScalarInput> scalarInputs;  ///< of the program
    /// Pairs of markers whose distance the expression takes, where it has no derivative at zero; -1 is Ground.
    std::vector<std::pair<int, int>> distances;

    int findMarker(int id) const;  ///< place in `markers`, or -1
};

/// A compiled expression. Immutable; made by MarkerFrames.
struct MarkerExpression : ExpressionInputs {
    MarkerExpression(ExpressionInputs inputs, Program compiled)
        : ExpressionInputs(std::move(inputs)), program(std::move(compiled)) {}

    Program program;

    /// What is wrong if so many derivatives are needed, or empty. Only functions that a user gives can lack any.
    std::string findDerivativeProblem(int needed) const;

    /// The motions of the markers in a State, as far as a level goes.
    std::vector<MarkerMotion> findMotions(const SimTK::State& state, KinematicLevel level) const;

    /// Puts time and motions into the inputs of an evaluation: `motions` has one entry for each marker.
    void setInputs(SimTK::Real time, const MarkerMotion* motions, Evaluation& evaluation) const;
    /// The same from a State, scalar inputs included; only inputs up to a level. Takes no memory.
    void setInputs(const SimTK::State& state, Evaluation& evaluation,
                   KinematicLevel highest = KinematicLevel::Acceleration) const;

    /// d(value)/d[w, v] of a marker, in Ground, after calcGradient(): of a value that depends on positions
    /// that of its rate, of one that depends on velocities that of itself. Times a multiplier it is the load
    /// on the marker.
    SimTK::SpatialVec getDirection(const Evaluation& evaluation, const MarkerMotion* motions,
                                   int marker) const;

    /// The partial derivative by time, in the system's unit.
    SimTK::Real getTimeDerivative(const Evaluation& evaluation) const;

private:
    void setTime(SimTK::Real time, Evaluation& evaluation) const;
    void setMotion(size_t marker, const MarkerMotion& motion, Evaluation& evaluation) const;
};

}  // namespace jprim

#endif
