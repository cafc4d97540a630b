// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MARKER_MARKER_FRAMES_H_
#define JPRIM_SRC_MARKER_MARKER_FRAMES_H_

#include <array>
#include <functional>
#include <map>

#include "jprim/marker/expression.h"
#include "marker/marker_expression.h"

namespace jprim {

/// Markers by id as operands of an expression's program: vectors in Ground, in the expression's units. Id 0
/// is Ground itself, whose vectors are constants.
class MarkerFrames {
public:
    /// The marker with an id, or null.
    using FindMarker = std::function<const Marker*(int)>;

    MarkerFrames(ProgramBuilder& builder, FindMarker find, const ExpressionUnits& units)
        : m_builder(builder), m_find(std::move(find)) {
        m_inputs.units = units;
    }

    ProgramBuilder& updBuilder() { return m_builder; }
    const ExpressionUnits& getUnits() const { return m_inputs.units; }
    bool exists(int id) const { return id == 0 || m_find(id) != nullptr; }

    /// @name Of one marker
    ///@{
    Operand origin(int id) { return getVector(id, MarkerQuantity::Origin); }
    Operand axis(int id, int axis) {
        return getVector(id, MarkerQuantity(int(MarkerQuantity::AxisX) + axis));
    }
    Operand velocity(int id) { return getVector(id, MarkerQuantity::Velocity); }
    Operand angularVelocity(int id) { return getVector(id, MarkerQuantity::AngularVelocity); }
    Operand acceleration(int id) { return getVector(id, MarkerQuantity::Acceleration); }
    Operand angularAcceleration(int id) { return getVector(id, MarkerQuantity::AngularAcceleration); }
    ///@}

    /// @name Of i relative to j
    ///@{
    Operand position(int i, int j);                      ///< r = r_i - r_j
    Operand distance(int i, int j);                      ///< its length
    Operand velocity(int i, int j, int l);               ///< dr/dt seen from l
    Operand acceleration(int i, int j, int l);           ///< d2r/dt2 seen from l
    Operand angularVelocity(int i, int j);               ///< w_i - w_j
    Operand angularAcceleration(int i, int j, int l);    ///< its derivative seen from l
    Operand element(int i, int j, int row, int column);  ///< of R_ji: axis `row` of j . axis `column` of i
    Operand direction(int i, int j);                     ///< of r, zero where the markers coincide
    Operand radialVelocity(int i, int j, int l);         ///< VR: dr/dt seen from l along r
    Operand projectedAngle(int i, int j, int axis);      ///< AX, AY, AZ, counting whole turns
    Operand angleAboutZ(int i, int j) { return projectedAngle(i, j, 2); }
    ///@}

    /// A vector's component along an axis of k, and all three.
    Operand along(Operand v, int k, int axis) { return m_builder.multiply(v, this->axis(k, axis)); }
    Operand inAxesOf(Operand v, int k);

    /// A scalar that only a State can tell.
    Operand addScalar(KinematicLevel level, ExpressionInputs::StateFunction calc,
                      ExpressionInputs::StateFunction calcRate = {});

    /// The finished program with its inputs.
    MarkerExpression finish(Operand result);

private:
    Operand getVector(int id, MarkerQuantity quantity);
    int addMarker(int id);

    ProgramBuilder& m_builder;
    FindMarker m_find;
    ExpressionInputs m_inputs;  // but for the place of time among the scalars
    std::map<std::pair<int, MarkerQuantity>, Operand> m_known;
    std::map<std::array<int, 3>, Operand> m_angles;  // by i, j, axis: one count of turns for each
};

/// An expression written in code instead of text.
Expression composeExpression(const MarkerFrames::FindMarker& find, const ExpressionUnits& units,
                             const std::function<Operand(MarkerFrames&)>& compose);

/// The same between two markers, which have the ids PairI and PairJ.
constexpr int PairI = 1, PairJ = 2;
Expression composeExpression(const Marker& I, const Marker& J,
                             const std::function<Operand(MarkerFrames&)>& compose);

}  // namespace jprim

#endif
