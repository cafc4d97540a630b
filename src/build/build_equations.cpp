// SPDX-License-Identifier: Apache-2.0
// The part of MechanismBuilder that makes GCONs, MOTIONs and COUPLERs, and given coordinates at the start.
#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "build/mechanism_builder.h"
#include "jprim/joint/motion.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Transform;

void MechanismBuilder::addEquations() {
    for (const GconStatement& s : m_dataset.gcons) addGcon(s);
    for (const MotionStatement& s : m_dataset.motions) addMotion(s);
    for (const CouplerStatement& s : m_dataset.couplers) addCoupler(s);
    for (const JointStatement& s : m_dataset.joints) addInitialCoordinates(s);
}

// The scale makes a displacement of one length unit, or a turn of a part that moves its farthest marker as
// far, change the error by about one: tolerances then mean the same for every equation.
void MechanismBuilder::addEquation(const std::string& name, GeneralConstraint constraint,
                                   const Expression& f) {
    const MarkerExpression& e = f.getImplementation();
    std::vector<MarkerMotion> motions(e.markers.size());
    std::vector<Real> sizes;
    for (size_t k = 0; k < e.markers.size(); ++k) {
        const MechanismPart& part = m_mechanism.m_parts[size_t(m_ownerOfMarker.at(e.markerIds[k]))];
        motions[k].X = getGivenPose(e.markerIds[k]);
        sizes.push_back(part.size);
    }
    Evaluation evaluation(e.program);
    e.setInputs(0, motions.data(), evaluation);
    evaluation.calcValue();
    evaluation.calcGradient();
    Real linear = 0, angular = 0;
    for (size_t k = 0; k < e.markers.size(); ++k) {
        const SpatialVec direction = e.getDirection(evaluation, motions.data(), int(k));
        linear = std::max(linear, direction[1].norm());
        angular = std::max(angular, direction[0].norm() / sizes[k]);
    }
    const Real size = std::max(linear, angular);
    if (size > 0 && std::isfinite(size)) constraint.setDefaultScale(std::exp2(-std::round(std::log2(size))));
    m_mechanism.m_equations.push_back({name, constraint, linear > 0 ? Dimension::Length : Dimension::Angle});
}

namespace {

// Of an equation between two markers the one that is not i; 0 if it is not of that kind.
int findOther(const std::vector<int>& markers, int i) {
    if (markers.size() != 2 || (markers[0] != i && markers[1] != i)) return 0;
    return markers[0] == i ? markers[1] : markers[0];
}

// Whether keeping f = 0 may take work: if f depends on time, or is an equation of velocities that rest does not
// satisfy. In which position does not matter, as long as it is not a special one.
bool doesWork(const MarkerExpression& f) {
    if (f.program.getTimeInput() >= 0) return true;
    if (f.program.getLevel() != KinematicLevel::Velocity) return false;
    std::vector<MarkerMotion> atRest;
    for (size_t k = 0; k < f.markers.size(); ++k)
        atRest.push_back({Transform(SimTK::Rotation(1.1 + Real(k), SimTK::UnitVec3(1, 2, 3)),
                                    SimTK::Vec3(1.3, -0.7, 2.1) * (1.9 + Real(k)))});
    Evaluation evaluation(f.program);
    f.setInputs(0, atRest.data(), evaluation);
    return evaluation.calcValue() != 0;
}

}  // namespace

// A GCON has no J, but one between two markers is reported on both.
void MechanismBuilder::addGcon(const GconStatement& s) {
    const std::string name = fmt::format("GCON/{}", s.id);
    attempt(name, s.function.getPosition(0), [&] {
        const Expression f =
            write(FunctionUse::Equation, [&s](FunctionWriter& w) { return w.scalar(s.function); });
        const GeneralConstraint constraint(f, name);
        addEquation(name, constraint, f);
        if (doesWork(f.getImplementation())) {
            m_mechanism.m_hasPower = true;
            m_working.push_back(constraint);
        }
        const auto on = [&constraint](int marker) -> LoadFunction {
            return
                [constraint, marker](const State& state) { return constraint.calcReactionOn(state, marker); };
        };
        const int j = findOther(f.getImplementation().markerIds, s.i);
        addLoadElement({name, s.i, j, on(s.i), j == 0 ? LoadFunction() : on(j), true});
    });
}

namespace {

Coordinate getCoordinate(MotionAxis axis, JointType jointType) {
    switch (axis) {
        case MotionAxis::Joint:
            return jointType == JointType::Translational ? Coordinate::Z : Coordinate::Rotation;
        case MotionAxis::Rotation: return Coordinate::Rotation;
        case MotionAxis::X: return Coordinate::X;
        case MotionAxis::Y: return Coordinate::Y;
        case MotionAxis::B1: return Coordinate::B1;
        case MotionAxis::B2: return Coordinate::B2;
        case MotionAxis::B3: return Coordinate::B3;
        case MotionAxis::Translation:
        case MotionAxis::Z: break;
    }
    return Coordinate::Z;
}

}  // namespace

void MechanismBuilder::addMotion(const MotionStatement& s) {
    const std::string name = fmt::format("MOTION/{}", s.id);
    int i = s.i, j = s.j;
    JointType jointType = JointType::Revolute;
    if (s.joint != 0) {
        const JointStatement& joint = *m_joints.at(s.joint);
        i = joint.i;
        j = joint.j;
        jointType = joint.type;
    }
    const Coordinate coordinate = getCoordinate(s.axis, jointType);
    const UnitSystem& units = m_mechanism.m_units;
    const Real displacement = units.getDisplacement(getDimension(coordinate));
    attempt(name, s.where, [&] {
        const Expression function = write(FunctionUse::OfTime, [&](FunctionWriter& w) {
            return w.scale(displacement / std::pow(units.time, int(s.level)), w.scalar(s.function));
        });
        const Marker &I = m_mechanism.getMarker(i), &J = m_mechanism.getMarker(j);
        const PrescribedMotion motion(I, J, coordinate, function, s.level, name);
        m_mechanism.m_equations.push_back({name, motion, getDimension(coordinate)});
        m_mechanism.m_hasPower = true;
        m_working.push_back(motion);
        addLoadElement({name, i, j, [motion](const State& state) { return motion.calcReactionOnI(state); },
                        [motion](const State& state) { return motion.calcReactionOnJ(state); }, true});
        addInitialCoordinate(name, i, j, coordinate, s.icdisp, s.icvel);
    });
}

void MechanismBuilder::addInitialCoordinate(const std::string& name, int i, int j, Coordinate coordinate,
                                            const std::optional<double>& value,
                                            const std::optional<double>& rate) {
    if (!value && !rate) return;
    const UnitSystem& units = m_mechanism.m_units;
    const Real unit = units.getDisplacement(getDimension(coordinate));
    InitialCoordinate given{name,
                            makeCoordinate(m_mechanism.getMarker(i), m_mechanism.getMarker(j), coordinate),
                            getDimension(coordinate),
                            {},
                            {}};
    if (value) given.value = *value * unit;
    if (rate) given.rate = *rate * unit / units.time;
    m_mechanism.m_initialCoordinates.push_back(given);
}

void MechanismBuilder::addInitialCoordinates(const JointStatement& s) {
    const std::string name = fmt::format("JOINT/{}", s.id);
    const auto add = [&](const std::optional<JointInitialValue>& given, Coordinate coordinate) {
        if (given) addInitialCoordinate(name, s.i, s.j, coordinate, given->displacement, given->velocity);
    };
    add(s.ic, s.type == JointType::Translational ? Coordinate::Z : Coordinate::Rotation);
    add(s.icTranslation, Coordinate::Z);
    add(s.icRotation, Coordinate::Rotation);
}

// Sum of scale times displacement, in the dataset's units; angles count whole turns.
void MechanismBuilder::addCoupler(const CouplerStatement& s) {
    const std::string name = fmt::format("COUPLER/{}", s.id);
    attempt(name, s.where, [&] {
        const Expression f = write(FunctionUse::Equation, [&](FunctionWriter& w) {
            MarkerFrames& frames = w.updFrames();
            Operand sum = w.updBuilder().number(0);
            for (size_t k = 0; k < s.joints.size(); ++k) {
                const JointStatement& joint = *m_joints.at(s.joints[k]);
                const Operand q = s.types[k] == CouplerType::Rotational
                                      ? frames.angleAboutZ(joint.i, joint.j)
                                      : frames.along(frames.position(joint.i, joint.j), joint.j, 2);
                sum = w.updBuilder().add(sum, w.scale(s.scales[k], q));
            }
            return sum;
        });
        addEquation(name, GeneralConstraint(f, name), f);
    });
}

}  // namespace jprim
