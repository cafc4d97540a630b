// SPDX-License-Identifier: Apache-2.0
// What is no number, or cannot mean anything, is refused where it is given, with the element and the value.
#include <gtest/gtest.h>

#include <functional>

#include "jprim/force/expression_measure.h"
#include "jprim/force/marker_force.h"
#include "jprim/joint/joint.h"
#include "jprim/joint/motion.h"
#include "support/expect_error.h"

namespace jprim {
namespace {

using SimTK::Body;
using SimTK::GeneralForceSubsystem;
using SimTK::Infinity;
using SimTK::MassProperties;
using SimTK::MobilizedBody;
using SimTK::NaN;
using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;
using testing::catchError;

struct Two {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    GeneralForceSubsystem forces{system};
    Body::Rigid body{MassProperties(1, Vec3(0), SimTK::Inertia(0.1))};
    MobilizedBody::Free a{matter.Ground(), body}, b{matter.Ground(), body};
    Marker I{a, Vec3(0.1, 0.2, 0.3)}, J{b};

    Expression write(const char* text) { return Expression(text, {{1, I}, {2, J}}); }
    std::string refuse(const std::function<void(Two&)>& action) {
        const std::string message = catchError([&] { action(*this); });
        EXPECT_EQ(matter.getNumConstraints() + forces.getNumForces(), 0) << message;
        return message;
    }
};

Expression writeTime() {
    return Expression("TIME", {});
}

//------------------------------------------------------------------------------------- not finite
TEST(Refusals, OfMarkersThatAreNowhere) {
    Two t;
    Vec3 unset(NaN);
    SimTK::Rotation bad;
    bad.setRotationFromMat33TrustMe(SimTK::Mat33(1, 0, 0, 0, NaN, 0, 0, 0, 1));
    EXPECT_EQ(t.refuse([&](Two&) { AtPoint(Marker(t.a, unset), t.J, "p"); }),
              "marker on body 1: its place is (nan, nan, nan); it must be finite");
    EXPECT_EQ(t.refuse([](Two& m) { Marker(m.b, Vec3(0, Infinity, 0)); }),
              "marker on body 2: its place is (0, inf, 0); it must be finite");
    EXPECT_EQ(t.refuse([&](Two& m) { Marker(m.b, Transform(bad)); }),
              "marker on body 2: its y axis is (0, nan, 0); it must be finite");
    EXPECT_EQ(t.refuse([&](Two& m) { m.I.withPose(Vec3(-Infinity, 0, 0)); }),
              "marker on body 1: its place is (-inf, 0, 0); it must be finite");
}

TEST(Refusals, OfPosesThatAreSet) {
    Two t;
    const Transform nowhere(Vec3(0, 0, Infinity));
    AtPoint p(t.I, t.J, "p");
    Joint hinge = Joint::Revolute(t.I, t.J, "hinge");
    State state = t.system.realizeTopology();
    const std::string I = "p ATPOINT: marker I's place is (0, 0, inf); it must be finite";
    const std::string J = "p ATPOINT: marker J's place is (0, 0, inf); it must be finite";
    EXPECT_EQ(catchError([&] { p.setMarkerI(state, nowhere); }), I);
    EXPECT_EQ(catchError([&] { p.setMarkerJ(state, nowhere); }), J);
    EXPECT_EQ(catchError([&] { p.setDefaultMarkerI(nowhere); }), I);
    EXPECT_EQ(catchError([&] { p.setDefaultMarkerJ(nowhere); }), J);
    EXPECT_EQ(catchError([&] { hinge.setMarkerI(state, nowhere); }),
              "hinge REVOLUTE: marker I's place is (0, 0, inf); it must be finite");
    EXPECT_EQ(p.getMarkerI(state).getPose().p(), t.I.getPose().p());
}

TEST(Refusals, OfNumbersOfJointsAndEquations) {
    Two t;
    EXPECT_EQ(t.refuse([](Two& m) { Joint::Screw(m.I, m.J, NaN, 0, "s"); }),
              "s SCREW: its pitch is nan; it must be a finite number");
    EXPECT_EQ(t.refuse([](Two& m) { Joint::Screw(m.I, m.J, 0.1, Infinity); }),
              "SCREW: its offset is inf; it must be a finite number");
    EXPECT_EQ(t.refuse([](Two& m) { Joint::Rackpin(m.I, m.J, -Infinity, 0, "r"); }),
              "r RACKPIN: its diameter is -inf; it must be a finite number");
    EXPECT_EQ(t.refuse([](Two& m) { Joint::Rackpin(m.I, m.J, 0.1, NaN); }),
              "RACKPIN: its offset is nan; it must be a finite number");
    for (const auto& [period, text] : {std::pair(Real(NaN), "nan"), {Infinity, "inf"}, {-1, "-1"}})
        EXPECT_EQ(t.refuse([p = period](Two& m) {
            GeneralConstraint(m.write("AZ(1,2)"), writeTime(), KinematicLevel::Position, p, "g");
        }),
                  std::string("g: its period is ") + text + "; it must be positive, or 0 for none");
    GeneralConstraint g(t.write("DX(1,2)-1"), "g");
    for (const auto& [scale, text] : {std::pair(Real(NaN), "nan"), {Infinity, "inf"}, {0, "0"}})
        EXPECT_EQ(catchError([&, s = scale] { g.setDefaultScale(s); }),
                  std::string("g: its scale is ") + text + "; it must be a finite number other than 0");
    g.setDefaultScale(-0.5);
}

// The expression is finite where it was written; not everywhere.
TEST(Refusals, OfEquationsWithoutAValue) {
    Two t;
    const GeneralConstraint root(t.write("SQRT(DX(1,2)-1)"), "root");
    PrescribedMotion drive(t.I, t.J, Coordinate::Y, Expression("LOG(TIME)", {}), KinematicLevel::Position,
                           "drive");
    drive.setDisabledByDefault(true);
    State state = t.system.realizeTopology();
    const std::string message = catchError([&] { t.system.realize(state, Stage::Position); });
    EXPECT_EQ(message.rfind("root: its expression has no finite value here, but is ", 0), 0u) << message;
    root.disable(state);
    drive.enable(state);
    EXPECT_EQ(catchError([&] { t.system.realize(state, Stage::Position); }),
              "drive: its function has no finite value here, but is -inf");
    state.setTime(1);
    t.system.realize(state, Stage::Acceleration);
    EXPECT_TRUE(std::isfinite(state.getUDot().norm()));
}

//---------------------------------------------------------------------------------- no such thing
TEST(Refusals, OfDerivativesThatCannotBePrescribed) {
    for (const int derivative : {-1, 3, 100}) {
        Two t;
        EXPECT_EQ(
            t.refuse([&](Two& m) {
                PrescribedMotion(m.I, m.J, Coordinate::X, writeTime(), KinematicLevel(derivative), "m");
            }),
            "m: derivative " + std::to_string(derivative) +
                " of a coordinate cannot be prescribed; use 0 for the coordinate itself, 1 for its rate or "
                "2 for its acceleration");
        EXPECT_EQ(t.refuse([&](Two& m) {
                       GeneralConstraint(m.write("DX(1,2)"), writeTime(), KinematicLevel(derivative), 0);
                   }).rfind("GCON: derivative", 0),
                  0u);
    }
}

TEST(Refusals, OfTwoMarkersOnOneBody) {
    Two t;
    const Marker other(t.a, Vec3(0, 0, 1));
    const std::string reason = "markers I and J are both on body 1; it acts between two different bodies";
    EXPECT_EQ(t.refuse([&](Two& m) { Joint::Screw(m.I, other, 0.3, 0, "s"); }), "s SCREW: " + reason);
    EXPECT_EQ(t.refuse([&](Two& m) { Joint::Rackpin(m.I, other, 0.3); }), "RACKPIN: " + reason);
    EXPECT_EQ(t.refuse([&](Two& m) { PrescribedMotion(m.I, other, Coordinate::B2, writeTime()); }),
              "MOTION: " + reason);
    EXPECT_EQ(t.refuse([&](Two& m) { Joint::Revolute(m.I, other); }), "REVOLUTE: " + reason);
    const Marker G(t.matter.Ground()), H(t.matter.Ground(), Vec3(1, 0, 0));
    EXPECT_EQ(t.refuse([&](Two&) {
        GeneralConstraint(Expression("DX(1,2)-1", {{1, G}, {2, H}}), "g");
    }),
              "g: all markers of the expression are on Ground, so it constrains nothing");
}

TEST(Refusals, OfMarkersOfOtherSystems) {
    Two t, u;
    ForceLaw law;
    law.force = Expression("[0,7,0]", {});
    const auto refuseForce = [&](const std::optional<Marker>& I, const std::optional<Marker>& J) {
        return t.refuse([&](Two& m) { MarkerForce(m.forces, *I, J, law, "f"); });
    };
    const std::string other = " belongs to another system; put all bodies into one";
    EXPECT_EQ(refuseForce(u.I, std::nullopt), "f: marker I" + other);
    EXPECT_EQ(refuseForce(t.I, u.J), "f: marker J" + other);
    EXPECT_EQ(refuseForce(Marker(), t.J).rfind("f: marker I is not on a body", 0), 0u);
    EXPECT_EQ(refuseForce(t.I, Marker()).rfind("f: marker J is not on a body", 0), 0u);
    law.force = Expression("[DX(1,7),0,0]", {{1, t.I}, {7, u.I}});
    EXPECT_EQ(refuseForce(t.I, t.J), "f: marker 7" + other);
    law.force = Expression("[DX(1,7),0,0]", {{1, t.I}, {7, Marker()}});
    EXPECT_EQ(refuseForce(t.I, t.J).rfind("f: marker 7 is not on a body", 0), 0u);

    EXPECT_EQ(t.refuse([&](Two& m) { ExpressionMeasure(m.forces, u.write("DM(1,2)")); }),
              "expression: marker 2" + other);
    EXPECT_EQ(t.refuse([&](Two& m) {
                   ExpressionMeasure(m.forces, Expression("DX(5)", {{5, Marker()}}));
               }).rfind("expression: marker 5 is not on a body", 0),
              0u);
    EXPECT_EQ(t.refuse([&](Two&) {
        GeneralForceSubsystem none;
        ExpressionMeasure(none, writeTime());
    }),
              "expression: its force subsystem belongs to no system; construct it with a MultibodySystem");
}

TEST(Refusals, OfPotentialsOfVelocities) {
    Two t;
    ForceLaw law;
    law.potential = t.write("VX(1)**2");
    EXPECT_EQ(
        t.refuse([&](Two& m) { MarkerForce(m.forces, m.I, m.J, law, "f"); }),
        "f: its potential depends on velocities; an energy that is stored depends on positions and TIME "
        "only");
    law.potential = t.write("DM(1,2)*TIME");
    MarkerForce(t.forces, t.I, t.J, law, "f");
}

//---------------------------------------------------------------------------------------- lifetime
struct Built {
    MobilizedBody rod;
    MarkerForce spring;
    ExpressionMeasure measure;
};

// A builder function returns: its handles are gone, and their place on the stack is written over.
Built build(SimTK::MultibodySystem& system) {
    SimTK::SimbodyMatterSubsystem matter(system);
    GeneralForceSubsystem forces(system);
    MobilizedBody::Free rod(matter.Ground(), Body::Rigid(MassProperties(2, Vec3(0), SimTK::Inertia(0.1))));
    const std::map<int, Marker> markers = {{1, Marker(rod, Vec3(0.2, 0, 0))}, {2, Marker(matter.Ground())}};
    ForceLaw law;
    law.force = Expression("-10*DXYZ(1,2)", markers);
    law.potential = Expression("5*DM(1,2)**2", markers);
    return {rod, MarkerForce(forces, markers.at(1), markers.at(2), law, "spring"),
            ExpressionMeasure(forces, Expression("3*DM(1,2)+TIME", markers))};
}

void writeOverTheStack() {
    volatile char bytes[16384];
    for (volatile char& byte : bytes) byte = char(0x5a);
}

TEST(Lifetime, ForcesAndMeasuresNeedNoHandleOfTheirSubsystem) {
    SimTK::MultibodySystem system;
    const Built built = build(system);
    writeOverTheStack();
    State state = system.realizeTopology();
    system.realize(state, Stage::Acceleration);
    EXPECT_NEAR(built.rod.getBodyOriginAcceleration(state)[0], -10 * 0.2 / 2, 1e-12);
    EXPECT_NEAR(built.spring.calcLoadOnI(state)[1][0], -2, 1e-12);
    EXPECT_NEAR(system.calcPotentialEnergy(state), 5 * 0.04, 1e-12);
    EXPECT_NEAR(built.measure.calcValue(state), 0.6, 1e-12);
}

}  // namespace
}  // namespace jprim
