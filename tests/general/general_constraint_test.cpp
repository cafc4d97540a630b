// SPDX-License-Identifier: Apache-2.0
// General constraints against primitives, Simbody's own, and closed forms.
#include "jprim/general/general_constraint.h"

#include <gtest/gtest.h>

#include "jprim/analysis/constraint_report.h"
#include "jprim/primitive/primitives.h"
#include "support/expect_error.h"

namespace jprim {
namespace {

using SimTK::Body;
using SimTK::GeneralForceSubsystem;
using SimTK::Inertia;
using SimTK::MassProperties;
using SimTK::MobilizedBody;
using SimTK::MultibodySystem;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::SimbodyMatterSubsystem;
using SimTK::SpatialVec;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;
using testing::catchError;
using ::testing::Combine;
using ::testing::Values;

//---------------------------------------------------------------------------------- against primitives
/// A body with products of inertia, free, under gravity, with a spin.
struct Free {
    MultibodySystem system;
    SimbodyMatterSubsystem matter{system};
    GeneralForceSubsystem forces{system};
    SimTK::Force::Gravity gravity{forces, matter, Vec3(0.3, -9.81, 0.2)};
    MobilizedBody::Free body{matter.Ground(), Body::Rigid(MassProperties(
                                                  1.7, Vec3(0), Inertia(0.5, 0.6, 0.4, 0.02, -0.03, 0.01)))};
    Marker I{body, Transform(Rotation(0.3, SimTK::ZAxis), Vec3(0.2, 0.4, -0.1))};
    Marker J{matter.updGround(), Transform(Rotation(0.3, SimTK::ZAxis), Vec3(0.1, 0.2, 0.3))};

    /// I on J, turning about an axis.
    State start(const Vec3& w) {
        State state = system.realizeTopology();
        system.realizeModel(state);
        body.setQToFitTransform(state, J.getPose() * ~I.getPose());
        system.realize(state, Stage::Position);
        body.setUToFitVelocity(state, SpatialVec(w, -w % (body.getBodyRotation(state) * I.getPose().p())));
        system.realize(state, Stage::Velocity);
        return state;
    }

    State run(State state, Real time) {
        SimTK::RungeKuttaMersonIntegrator integrator(system);
        integrator.setAccuracy(1e-9);
        SimTK::TimeStepper stepper(system, integrator);
        stepper.initialize(state);
        stepper.stepTo(time);
        State end = stepper.getState();
        system.realize(end, Stage::Acceleration);
        return end;
    }
};

TEST(GeneralConstraint, ThreeOfThemAreABall) {
    constexpr Real IntegratorTolerance = 1e-6;  // of accuracy 1e-9 over 1 s
    const Vec3 w(1.1, -0.7, 2.3);
    Free withBall, withEquations;
    const AtPoint ball(withBall.I, withBall.J);
    std::vector<GeneralConstraint> equations;
    for (const char* text : {"DX(1,2)", "DY(1,2)", "DZ(1,2)"})
        equations.emplace_back(Expression(text, {{1, withEquations.I}, {2, withEquations.J}}));
    const State a = withBall.run(withBall.start(w), 1), b = withEquations.run(withEquations.start(w), 1);

    const Transform X_a = withBall.body.getBodyTransform(a), X_b = withEquations.body.getBodyTransform(b);
    EXPECT_LT((X_a.p() - X_b.p()).norm(), IntegratorTolerance);
    EXPECT_LT((X_a.R() - X_b.R()).norm(), IntegratorTolerance);
    for (const int marker : {1, 2}) {
        SpatialVec sum(Vec3(0), Vec3(0));
        for (const GeneralConstraint& equation : equations) sum += equation.calcReactionOn(b, marker);
        const SpatialVec expected = marker == 1 ? ball.calcReactionOnI(a) : ball.calcReactionOnJ(a);
        EXPECT_LT((sum - expected).norm(), 100 * IntegratorTolerance) << "on marker " << marker;
    }
}

TEST(GeneralConstraint, AGuardOnParallelAxesIsRedundantAndDisturbsNothing) {
    constexpr Real Same = 1e-9;
    const Vec3 aboutZ(0, 0, 2);
    Free plain, guarded;
    for (Free* f : {&plain, &guarded}) {
        AtPoint(f->I, f->J);
        ParallelAxes(f->I, f->J);
    }
    GeneralConstraint(Expression("UVZ(1)*UVZ(2)-1", {{1, guarded.I}, {2, guarded.J}}));
    const State start = guarded.start(aboutZ);
    const ConstraintReport report = analyzeConstraints(guarded.matter, start);
    EXPECT_EQ(report.getNumRedundant(), 1);
    EXPECT_EQ(report.getDegreesOfFreedom(), 1);
    const State a = plain.run(plain.start(aboutZ), 1), b = guarded.run(start, 1);
    EXPECT_LT((plain.body.getBodyOriginLocation(a) - guarded.body.getBodyOriginLocation(b)).norm(), Same);
}

//------------------------------------------------------------------------------------- closed forms
// A disc that rolls without slip down a plane inclined by 30 degrees: a = g sin(30) / (1 + J/(m r^2)).
TEST(GeneralConstraint, ADiscRollsAsTheClosedFormSays) {
    const Real m = 1.3, r = 0.25, J = 0.5 * m * r * r, g = 9.81, slope = SimTK::Pi / 6;
    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    GeneralForceSubsystem forces(system);
    SimTK::Force::Gravity(forces, matter, g * Vec3(std::sin(slope), -std::cos(slope), 0));
    MobilizedBody::Planar disc(matter.Ground(), Body::Rigid(MassProperties(m, Vec3(0), Inertia(J, J, J))));
    const Marker center(disc), ground(matter.updGround());
    // The wheel stands on y = 0; its centre is at y = r, and turns by -v/r.
    InPlane(center,
            Marker(ground.getBody(), Transform(Rotation(-SimTK::Pi / 2, SimTK::XAxis), Vec3(0, r, 0))));
    const GeneralConstraint rolling(Expression("VX(2)+WZ(2)*DY(2)", {{2, center}}));
    EXPECT_FALSE(rolling.isHolonomic());
    State state = system.realizeTopology();
    disc.setQToFitTransform(state, Transform(Vec3(0, r, 0)));
    system.realize(state, Stage::Acceleration);
    const Real expected = g * std::sin(slope) / (1 + J / (m * r * r));
    constexpr Real Rounding = 1e-12;
    EXPECT_NEAR(disc.getBodyOriginAcceleration(state)[0], expected, Rounding);
    // The force at the rim that makes it roll, here at the centre with its moment.
    const SpatialVec load = rolling.calcReactionOn(state, 2);
    EXPECT_NEAR(load[1][0], m * expected - m * g * std::sin(slope), Rounding);
    EXPECT_NEAR(load[0][2], r * load[1][0], Rounding);

    SimTK::RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(1e-8);
    SimTK::TimeStepper stepper(system, integrator);
    stepper.initialize(state);
    stepper.stepTo(2);
    constexpr Real IntegratorTolerance = 1e-6;
    EXPECT_NEAR(disc.getBodyOriginLocation(stepper.getState())[0], expected * 4 / 2, IntegratorTolerance);
}

// Simbody's own Rod is a second route to a distance.
TEST(GeneralConstraint, ADistanceActsAsSimbodysRod) {
    const auto accelerate = [](bool useRod, Real length) {
        Free f;
        f.start(Vec3(0));
        if (useRod)
            SimTK::Constraint::Rod(f.matter.Ground(), f.J.getPose().p(), f.body, f.I.getPose().p(), length);
        else
            GeneralConstraint(Expression("DM(1,2)-0.5", {{1, f.I}, {2, f.J}}));
        State state = f.system.realizeTopology();
        f.body.setQToFitTransform(state, Transform(Rotation(0.4, SimTK::XAxis), Vec3(0.3, 0.1, 0.2)));
        f.body.setUToFitVelocity(state, SpatialVec(Vec3(1, 2, -0.5), Vec3(0.3, 0.2, 0.1)));
        f.system.realize(state, Stage::Acceleration);
        return SimTK::Vector(state.getUDot());
    };
    constexpr Real Rounding = 1e-10;
    EXPECT_LT((accelerate(false, 0.5) - accelerate(true, 0.5)).norm(), Rounding);
}

TEST(GeneralConstraint, TheReactionHoldsAWeight) {
    Free f;
    const Marker center(f.body), above(f.matter.updGround(), Transform(Vec3(-0.3, 9.81, -0.2) * 0.1));
    const GeneralConstraint string(Expression("DM(1,2)-TIME", {{1, center}, {2, above}}));
    State state = f.system.realizeTopology();
    state.setTime(above.getPose().p().norm());
    f.system.realize(state, Stage::Acceleration);
    constexpr Real Rounding = 1e-12;
    EXPECT_LT((string.calcReactionOn(state, 1)[1] - 1.7 * Vec3(-0.3, 9.81, -0.2)).norm(), Rounding);
    EXPECT_LT((string.calcReactionOn(state, 2)[1] + string.calcReactionOn(state, 1)[1]).norm(), Rounding);
    EXPECT_EQ(string.calcReactionOn(state, 3).norm(), 0) << "a marker that the expression does not know";
    string.disable(state);
    f.system.realize(state, Stage::Acceleration);
    EXPECT_EQ(string.calcReactionOn(state, 1).norm(), 0);
}

// The scale changes what the error means and nothing else.
TEST(GeneralConstraint, TheScaleChangesNoReaction) {
    const auto calcReaction = [](Real scale, Real& error) {
        Free f;
        GeneralConstraint distance(Expression("DM(1,2)-0.5", {{1, f.I}, {2, f.J}}));
        distance.setDefaultScale(scale);
        State state = f.system.realizeTopology();
        f.system.realize(state, Stage::Acceleration);
        error = distance.getPositionErrorsAsVector(state)[0];
        return distance.calcReactionOn(state, 1);
    };
    Real one = 0, thousand = 0;
    const SpatialVec a = calcReaction(1, one), b = calcReaction(1000, thousand);
    constexpr Real Rounding = 1e-12;
    EXPECT_NEAR(thousand, 1000 * one, Rounding);
    EXPECT_LT((a - b).norm(), Rounding);
}

//------------------------------------------------------------------------------------------ mistakes
TEST(GeneralConstraint, MistakesAreExplained) {
    Free f;
    const auto message = [&f](const char* text) {
        return catchError([&] { GeneralConstraint(Expression(text, {{1, f.I}, {2, f.J}}), "GCON/7"); });
    };
    EXPECT_EQ(message("UVZ(1)"), "GCON/7: the expression is a vector; write one equation for each component");
    EXPECT_EQ(message("VM(1,2)-3"),
              "GCON/7: the expression is not linear in velocities; a constraint of velocities must be");
    EXPECT_EQ(
        message("ACCX(1)"),
        "GCON/7: a constraint cannot depend on accelerations or reactions; only on positions, velocities "
        "and TIME");
    EXPECT_EQ(message("TIME-1"), "GCON/7: the expression depends on no marker, so it constrains nothing");
    EXPECT_EQ(message("DX(1,2"), "expression \"DX(1,2\": column 3: '(' is not closed");
    EXPECT_EQ(message("DX(1,3)"), "expression \"DX(1,3)\": column 6: MARKER/3 does not exist");
    EXPECT_EQ(message("DXX(1)"), "expression \"DXX(1)\": column 1: unknown function 'DXX'; did you mean DX?");
    EXPECT_EQ(message("DX()"), "expression \"DX()\": column 1: DX takes 1 to 3 ids, not 0");
    EXPECT_EQ(message("DX(1+0)"), "expression \"DX(1+0)\": column 4: argument 1 of DX must be an id");
    EXPECT_EQ(message("DX(0,1)"), "expression \"DX(0,1)\": column 4: the first marker of DX must not be 0");
}

TEST(GeneralConstraint, ADistanceOfZeroIsRefusedByName) {
    Free f;
    GeneralConstraint distance(Expression("DM(1,2)", {{1, f.I}, {2, f.J}}), "GCON/7");
    State state = f.system.realizeTopology();
    f.body.setQToFitTransform(state, f.J.getPose() * ~f.I.getPose());
    EXPECT_EQ(
        catchError([&] { f.system.realize(state, Stage::Position); }),
        "GCON/7: the distance between markers 1 and 2 has become zero, where a single equation cannot keep it; "
        "to hold two points together use JPRIM ATPOINT");
}

// Close to zero, where the equation can still be evaluated but nobody can step beyond.
TEST(GeneralConstraint, SaysThatADistanceVanishesNearby) {
    const auto findProblemAt = [](Real distance) {
        Free f;
        GeneralConstraint constraint(Expression("DM(1,2)-0.5", {{1, f.I}, {2, f.J}}), "GCON/7");
        State state = f.system.realizeTopology();
        const Transform apart(f.J.getPose().R(), f.J.getPose() * Vec3(distance, 0, 0));
        f.body.setQToFitTransform(state, apart * ~f.I.getPose());
        f.system.realize(state, Stage::Position);
        return constraint.findProblem(state);
    };
    EXPECT_EQ(findProblemAt(1e-3), "");
    EXPECT_EQ(findProblemAt(1e-8),
              "the distance between markers 1 and 2 has become zero, where a single equation cannot keep it; "
              "to hold two points together use JPRIM ATPOINT");
}

}  // namespace
}  // namespace jprim
