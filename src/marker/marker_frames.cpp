// SPDX-License-Identifier: Apache-2.0
#include "marker/marker_frames.h"

namespace jprim {

namespace {

KinematicLevel getLevel(MarkerQuantity quantity) {
    switch (quantity) {
        case MarkerQuantity::Velocity:
        case MarkerQuantity::AngularVelocity: return KinematicLevel::Velocity;
        case MarkerQuantity::Acceleration:
        case MarkerQuantity::AngularAcceleration: return KinematicLevel::Acceleration;
        default: return KinematicLevel::Position;
    }
}

}  // namespace

int MarkerFrames::addMarker(int id) {
    const int known = m_inputs.findMarker(id);
    if (known >= 0) return known;
    m_inputs.markers.push_back(*m_find(id));
    m_inputs.markerIds.push_back(id);
    return int(m_inputs.markers.size()) - 1;
}

Operand MarkerFrames::getVector(int id, MarkerQuantity quantity) {
    if (id == 0) {
        const auto component = [&](MarkerQuantity axis) {
            return m_builder.number(quantity == axis ? 1 : 0);
        };
        return m_builder.vector(component(MarkerQuantity::AxisX), component(MarkerQuantity::AxisY),
                                component(MarkerQuantity::AxisZ));
    }
    const auto found = m_known.find({id, quantity});
    if (found != m_known.end()) return found->second;
    const Operand added = m_builder.addVectorInput(getLevel(quantity));
    m_inputs.vectorInputs.push_back({addMarker(id), quantity});
    m_known[{id, quantity}] = added;
    return added;
}

Operand MarkerFrames::position(int i, int j) {
    return m_builder.subtract(origin(i), origin(j));
}

Operand MarkerFrames::distance(int i, int j) {
    const Operand norm = m_builder.norm(position(i, j));
    m_inputs.distances.emplace_back(i == 0 ? -1 : addMarker(i), j == 0 ? -1 : addMarker(j));
    return norm;
}

Operand MarkerFrames::velocity(int i, int j, int l) {
    const Operand v = m_builder.subtract(velocity(i), velocity(j));
    return m_builder.subtract(v, m_builder.cross(angularVelocity(l), position(i, j)));
}

// a_i - a_j - b_l x r - w_l x (w_l x r) - 2 w_l x (dr/dt seen from l)
Operand MarkerFrames::acceleration(int i, int j, int l) {
    ProgramBuilder& b = m_builder;
    const Operand w = angularVelocity(l), r = position(i, j);
    const Operand a = b.subtract(acceleration(i), acceleration(j));
    const Operand euler = b.cross(angularAcceleration(l), r);
    const Operand centripetal = b.cross(w, b.cross(w, r));
    const Operand coriolis = b.multiply(b.number(2), b.cross(w, velocity(i, j, l)));
    return b.subtract(b.subtract(a, euler), b.add(centripetal, coriolis));
}

Operand MarkerFrames::angularVelocity(int i, int j) {
    return m_builder.subtract(angularVelocity(i), angularVelocity(j));
}

Operand MarkerFrames::angularAcceleration(int i, int j, int l) {
    const Operand b = m_builder.subtract(angularAcceleration(i), angularAcceleration(j));
    return m_builder.subtract(b, m_builder.cross(angularVelocity(l), angularVelocity(i, j)));
}

Operand MarkerFrames::element(int i, int j, int row, int column) {
    return m_builder.multiply(axis(j, row), axis(i, column));
}

Operand MarkerFrames::direction(int i, int j) {
    return m_builder.normalize(position(i, j));
}

Operand MarkerFrames::radialVelocity(int i, int j, int l) {
    return m_builder.multiply(velocity(i, j, l), direction(i, j));
}

// AX = atan2(-z_i.y_j, z_i.z_j), AY = atan2(z_i.x_j, z_i.z_j), AZ = atan2(x_i.y_j, x_i.x_j)
Operand MarkerFrames::projectedAngle(int i, int j, int axis) {
    const auto [known, isNew] = m_angles.try_emplace({i, j, axis});
    if (!isNew) return known->second;
    const Operand sine = axis == 0   ? m_builder.negate(element(i, j, 1, 2))
                         : axis == 1 ? element(i, j, 0, 2)
                                     : element(i, j, 1, 0);
    const int other = axis == 2 ? 0 : 2;
    return known->second = m_builder.continuousAngle(sine, element(i, j, other, other));
}

Operand MarkerFrames::inAxesOf(Operand v, int k) {
    return k == 0 ? v : m_builder.vector(along(v, k, 0), along(v, k, 1), along(v, k, 2));
}

Operand MarkerFrames::addScalar(KinematicLevel level, ExpressionInputs::StateFunction calc,
                                ExpressionInputs::StateFunction calcRate) {
    m_inputs.scalarInputs.resize(size_t(m_builder.getNumScalarInputs()));  // time leaves a gap
    m_inputs.scalarInputs.push_back({std::move(calc), std::move(calcRate)});
    return m_builder.addScalarInput(level);
}

// The program numbers its scalar inputs in the order they were added, time among them.
MarkerExpression MarkerFrames::finish(Operand result) {
    Program program = m_builder.finish(result);
    ExpressionInputs inputs = m_inputs;
    inputs.scalarInputs.resize(size_t(program.getNumScalarInputs()));
    return MarkerExpression(std::move(inputs), std::move(program));
}

Expression composeExpression(const MarkerFrames::FindMarker& find, const ExpressionUnits& units,
                             const std::function<Operand(MarkerFrames&)>& compose) {
    ProgramBuilder builder;
    MarkerFrames frames(builder, find, units);
    const Operand result = compose(frames);
    return Expression(std::make_shared<const MarkerExpression>(frames.finish(result)));
}

Expression composeExpression(const Marker& I, const Marker& J,
                             const std::function<Operand(MarkerFrames&)>& compose) {
    const auto find = [&](int id) { return id == PairI ? &I : id == PairJ ? &J : nullptr; };
    return composeExpression(find, {}, compose);
}

}  // namespace jprim
