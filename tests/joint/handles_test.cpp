// SPDX-License-Identifier: Apache-2.0
// Handles as Simbody's are used: from an index back to the class, names found without a list, a Joint as a Constraint.
#include <gtest/gtest.h>

#include <functional>

#include "jprim/analysis/constraint_equations.h"
#include "jprim/force/expression_measure.h"
#include "jprim/force/marker_force.h"
#include "jprim/joint/motion.h"
#include "support/expect_error.h"

namespace jprim {
namespace {

using SimTK::Body;
using SimTK::Constraint;
using SimTK::ConstraintIndex;
using SimTK::Inertia;
using SimTK::MassProperties;
using SimTK::MobilizedBody;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;
using testing::catchError;

struct Two {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    SimTK::GeneralForceSubsystem forces{system};
    Body::Rigid body{MassProperties(1.7, Vec3(0), Inertia(0.5, 0.6, 0.4, 0.02, -0.03, 0.01))};
    MobilizedBody::Free a{matter.Ground(), body}, b{matter.Ground(), body};
    Marker I{a, Transform(Rotation(0.3, SimTK::UnitVec3(1, 2, -1)), Vec3(0.21, 0.43, -0.17))};
    Marker J{b, Transform(Rotation(-0.7, SimTK::UnitVec3(0, 1, 3)), Vec3(-0.31, 0.11, 0.37))};

    Expression write(const char* text) { return Expression(text, {{1, I}, {2, J}}); }
};

//------------------------------------------------------------------------------------------ classes
struct ClassCase {
    const char* name;
    bool (*isInstanceOf)(const Constraint&);
};

const ClassCase Classes[] = {{"AtPoint", AtPoint::isInstanceOf},
                             {"InLine", InLine::isInstanceOf},
                             {"InPlane", InPlane::isInstanceOf},
                             {"Orientation", Orientation::isInstanceOf},
                             {"ParallelAxes", ParallelAxes::isInstanceOf},
                             {"Perpendicular", Perpendicular::isInstanceOf},
                             {"Primitive", Primitive::isInstanceOf},
                             {"PairConstraint", PairConstraint::isInstanceOf},
                             {"GeneralConstraint", GeneralConstraint::isInstanceOf},
                             {"PrescribedMotion", PrescribedMotion::isInstanceOf},
                             {"Joint", Joint::isInstanceOf}};

std::string listClasses(const Constraint& constraint) {
    std::string list;
    for (const ClassCase& c : Classes)
        if (c.isInstanceOf(constraint)) list += std::string(list.empty() ? "" : " ") + c.name;
    return list;
}

TEST(Handles, KnowTheirOwnClass) {
    Two t;
    const std::pair<Constraint, const char*> cases[] = {
        {AtPoint(t.I, t.J), "AtPoint Primitive PairConstraint"},
        {InLine(t.I, t.J), "InLine Primitive PairConstraint"},
        {InPlane(t.I, t.J), "InPlane Primitive PairConstraint"},
        {Orientation(t.I, t.J), "Orientation Primitive PairConstraint"},
        {ParallelAxes(t.I, t.J), "ParallelAxes Primitive PairConstraint"},
        {Perpendicular(t.I, t.J), "Perpendicular Primitive PairConstraint"},
        {Joint::Spherical(t.I, t.J), "PairConstraint Joint"},
        {Joint::Revolute(t.I, t.J), "PairConstraint Joint"},
        {Joint::Screw(t.I, t.J, 0.3), "GeneralConstraint Joint"},
        {Joint::Rackpin(t.I, t.J, 0.3), "GeneralConstraint Joint"},
        {GeneralConstraint(t.write("DX(1,2)")), "GeneralConstraint"},
        {PrescribedMotion(t.I, t.J, Coordinate::X, Expression("TIME", {})),
         "GeneralConstraint PrescribedMotion"},
        {Constraint::Ball(t.a, t.b), ""},
        {Constraint::CoordinateCoupler(
             t.matter, new SimTK::Function::Linear(SimTK::Vector(2, 1.)),
             SimTK::Array_<SimTK::MobilizedBodyIndex>(1, t.a.getMobilizedBodyIndex()),
             SimTK::Array_<SimTK::MobilizerQIndex>(1, SimTK::MobilizerQIndex(0))),
         ""}};
    for (const auto& [constraint, classes] : cases) {
        EXPECT_EQ(listClasses(constraint), classes);
        EXPECT_EQ(listClasses(t.matter.getConstraint(constraint.getConstraintIndex())), classes);
    }
    EXPECT_EQ(listClasses(Constraint()), "");
}

TEST(Handles, ComeBackFromAnIndex) {
    Two t;
    const ConstraintIndex point = AtPoint(t.I, t.J, "p").getConstraintIndex();
    const ConstraintIndex equation = GeneralConstraint(t.write("DX(1,2)-1"), "g").getConstraintIndex();
    const ConstraintIndex hinge = Joint::Revolute(t.I, t.J, "hinge").getConstraintIndex();
    const ConstraintIndex screw = Joint::Screw(t.I, t.J, 0.3, 0, "screw").getConstraintIndex();
    const auto find = [&](ConstraintIndex index) -> Constraint& { return t.matter.updConstraint(index); };

    static_assert(std::is_same_v<decltype(AtPoint::downcast(find(point))), const AtPoint&>);
    static_assert(std::is_same_v<decltype(PrescribedMotion::updDowncast(find(point))), PrescribedMotion&>);
    EXPECT_EQ(AtPoint::downcast(find(point)).getName(), "p");
    AtPoint::updDowncast(find(point)).setName("renamed");
    EXPECT_EQ(Primitive::downcast(find(point)).getName(), "renamed");
    EXPECT_EQ(GeneralConstraint::downcast(find(equation)).getName(), "g");
    EXPECT_EQ(Joint::downcast(find(hinge)).getDescription(), "hinge REVOLUTE");
    EXPECT_EQ(Joint::downcast(find(screw)).getDescription(), "screw SCREW");
    EXPECT_EQ(Joint::downcast(find(screw)).getGeneralConstraint()->getAdamsType(), std::string("SCREW"));

    EXPECT_EQ(catchError([&] { InLine::downcast(find(point)); }),
              "constraint 0: is no InLine; ask InLine::isInstanceOf() first");
    EXPECT_EQ(catchError([&] { AtPoint::updDowncast(find(equation)); }),
              "constraint 1: is no AtPoint; ask AtPoint::isInstanceOf() first");
    EXPECT_EQ(catchError([&] { Joint::downcast(find(point)); }),
              "constraint 0: is no Joint; ask Joint::isInstanceOf() first");
    EXPECT_EQ(catchError([&] { PrescribedMotion::downcast(Constraint()); }),
              "constraint: is no PrescribedMotion; ask PrescribedMotion::isInstanceOf() first");
}

TEST(Handles, OfForcesKnowTheirClassToo) {
    Two t;
    ForceLaw law;
    law.force = t.write("-DXYZ(1,2)");
    const MarkerForce force(t.forces, t.I, t.J, law, "spring");
    const ExpressionMeasure measure(t.forces, t.write("DM(1,2)"));
    const SimTK::Force& first = t.forces.getForce(SimTK::ForceIndex(0));
    const SimTK::Force& second = t.forces.getForce(SimTK::ForceIndex(1));
    EXPECT_EQ(MarkerForce::downcast(first).getName(), "spring");
    EXPECT_TRUE(ExpressionMeasure::isInstanceOf(second));
    EXPECT_FALSE(ExpressionMeasure::isInstanceOf(first));
    EXPECT_EQ(catchError([&] { MarkerForce::downcast(second); }),
              "force 1: is no MarkerForce; ask MarkerForce::isInstanceOf() first");
}

//-------------------------------------------------------------------------------------------- names
TEST(Handles, NamesAreFoundWithoutAList) {
    Two t;
    InPlane(t.I, t.J, "guide");
    InPlane(t.I, t.J);
    GeneralConstraint(t.write("DM(1,2)-1"), "rope");
    GeneralConstraint(t.write("AZ(1,2)"));
    PrescribedMotion(t.I, t.J, Coordinate::X, Expression("TIME", {}), KinematicLevel::Position, "drive");
    PrescribedMotion(t.I, t.J, Coordinate::Rotation, Expression("TIME", {}));
    Joint::Screw(t.I, t.J, 0.3, 0, "screw");
    Joint::Rackpin(t.I, t.J, 0.3);
    Constraint::Ball(t.a, t.b);
    State state = t.system.realizeTopology();
    t.system.realize(state, Stage::Instance);
    std::vector<std::string> texts;
    std::string lengths;
    for (const ConstraintEquation& equation : findEquations(t.matter, state)) {
        texts.push_back(equation.getText());
        lengths += equation.dimension == Dimension::Length ? 'L' : '-';
    }
    texts.resize(9);
    EXPECT_EQ(texts,
              (std::vector<std::string>{
                  "guide INPLANE: translation of I along Zj", "INPLANE: translation of I along Zj",
                  "rope: its equation", "GCON: its equation", "drive: its equation", "MOTION: its equation",
                  "screw SCREW: its equation", "RACKPIN: its equation", "Ball (constraint 8): equation 1"}));
    EXPECT_EQ(lengths, "LLL-L-LL---");
}

// No message begins with ": ".
TEST(Handles, UnnamedElementsAreCalledByTheirType) {
    Two t, elsewhere;
    EXPECT_EQ(catchError([&] { GeneralConstraint{t.write("VM(1)")}; }),
              "GCON: the expression is not linear in velocities; a constraint of velocities must be");
    EXPECT_EQ(catchError([&] { PrescribedMotion(t.I, t.J, Coordinate::X, t.write("DX(1)")); }),
              "MOTION: the function must depend on nothing but TIME");
    EXPECT_EQ(catchError([&] {
                  GeneralConstraint(Expression("DX(1)", {{1, Marker()}}));
              }),
              "GCON: marker 1 is not on a body; construct it with a MobilizedBody that has been added to a "
              "matter subsystem");
    ForceLaw law;
    law.force = t.write("DX(1)");
    EXPECT_EQ(catchError([&] { MarkerForce(t.forces, t.I, t.J, law); }), "force: its force must be a vector");
    const GeneralConstraint distance(t.write("DM(1,2)"));
    State state = t.system.realizeTopology();
    t.system.realizeModel(state);
    t.a.setQToFitTransform(state, t.J.getPose() * ~t.I.getPose());
    EXPECT_EQ(catchError([&] { t.system.realize(state, Stage::Position); }).rfind("GCON: the distance", 0),
              0u);
}

//-------------------------------------------------------------------------------------------- joints
TEST(Joint, IsAConstraint) {
    Two t;
    Joint hinge;  // to be assigned to
    hinge = Joint::Revolute(t.I, t.J, "hinge");
    const Constraint& constraint = hinge;
    EXPECT_EQ(hinge.getConstraintIndex(), constraint.getConstraintIndex());
    State state = t.system.realizeTopology();
    state.updQ()[4] = 0.3;  // off the manifold
    t.system.realize(state, Stage::Acceleration);
    EXPECT_GT(hinge.getPositionErrorsAsVector(state).norm(), 0.1);
    const auto expectSame = [](const SimTK::Vector& a, const SimTK::Vector& b) {
        EXPECT_EQ(a.size(), 5);
        EXPECT_EQ((a - b).norm(), 0);
    };
    expectSame(hinge.getPositionErrorsAsVector(state), constraint.getPositionErrorsAsVector(state));
    expectSame(hinge.getVelocityErrorsAsVector(state), constraint.getVelocityErrorsAsVector(state));
    expectSame(hinge.getAccelerationErrorsAsVector(state), constraint.getAccelerationErrorsAsVector(state));
    expectSame(hinge.getMultipliersAsVector(state), constraint.getMultipliersAsVector(state));
}

TEST(Joint, MayBeDisabledByDefault) {
    Two t;
    for (Joint joint : {Joint::Revolute(t.I, t.J), Joint::Screw(t.I, t.J, 0.3)}) {
        EXPECT_FALSE(joint.isDisabledByDefault());
        joint.setDisabledByDefault(true);
        EXPECT_TRUE(joint.isDisabledByDefault());
        EXPECT_TRUE(joint.isDisabled(t.system.realizeTopology()));
        joint.setDisabledByDefault(false);
        EXPECT_FALSE(joint.isDisabled(t.system.realizeTopology()));
    }
}

TEST(Joint, HasMarkersOfItsOwn) {
    Two t;
    const Transform X(Rotation(0.9, SimTK::UnitVec3(2, -1, 1)), Vec3(0.7, -0.3, 0.2));
    Joint hinge = Joint::Revolute(t.I, t.J);
    hinge.setDefaultMarkerI(X);
    State state = t.system.realizeTopology();
    EXPECT_EQ(hinge.getDefaultMarkerI().getPose().p(), X.p());
    EXPECT_EQ(hinge.getMarkerI(state).getPose().p(), X.p());
    EXPECT_EQ(hinge.getMarkerJ(state).getPose().p(), t.J.getPose().p());
    hinge.setMarkerJ(state, X);
    EXPECT_EQ(hinge.getMarkerJ(state).getPose().p(), X.p());
    EXPECT_EQ(hinge.getDefaultMarkerJ().getPose().p(), t.J.getPose().p());

    Joint screw = Joint::Screw(t.I, t.J, 0.3, 0, "screw");
    EXPECT_EQ(screw.getDefaultMarkerI().getPose().p(), t.I.getPose().p());
    EXPECT_EQ(screw.getMarkerJ(state).getPose().p(), t.J.getPose().p());
    const char* refusal =
        "screw SCREW: its markers are part of its equation and stay where they are; make another joint";
    EXPECT_EQ(catchError([&] { screw.setDefaultMarkerI(X); }), refusal);
    EXPECT_EQ(catchError([&] { screw.setMarkerJ(state, X); }), refusal);
}

}  // namespace
}  // namespace jprim
