// SPDX-License-Identifier: Apache-2.0
// Turns of equations between several angles: those that do not matter, and those that the State remembers.
#include <gtest/gtest.h>

#include <cmath>

#include "jprim/general/general_constraint.h"
#include "support/expect_error.h"

namespace jprim {
namespace {

using SimTK::Body;
using SimTK::Inertia;
using SimTK::MassProperties;
using SimTK::MobilizedBody;
using SimTK::MultibodySystem;
using SimTK::Pi;
using SimTK::Random;
using SimTK::Real;
using SimTK::SimbodyMatterSubsystem;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;
using SimTK::Vector;
using testing::catchError;

constexpr Real Rounding = 1e-12;
// Of accuracy 1e-8 over a few seconds.
constexpr Real IntegratorTolerance = 1e-6;

// Two wheels on parallel axes, coupled.
struct Wheels {
    explicit Wheels(const std::string& text) {
        equation = GeneralConstraint(Expression(text, {{1, Marker(a)}, {2, Marker(b)}}), "gears");
        system.realizeTopology();
    }

    State makeState(Real angleOfA, Real angleOfB) const {
        State state = system.getDefaultState();
        a.setOneQ(state, 0, angleOfA);
        b.setOneQ(state, 0, angleOfB);
        system.realize(state, Stage::Position);
        return state;
    }

    MultibodySystem system;
    SimbodyMatterSubsystem matter{system};
    Body::Rigid body{MassProperties(1, Vec3(0), Inertia(0.3))};
    MobilizedBody::Pin a{matter.Ground(), body},
        b{matter.Ground(), Transform(Vec3(1, 0, 0)), body, Transform()};
    GeneralConstraint equation;
};

TEST(SharedTurns, GearsMeshInEveryState) {
    const Wheels gears("20*AZ(1)+35*AZ(2)");
    Random::Uniform random(-50, 50);
    random.setSeed(7);
    for (int k = 0; k < 100; ++k) {
        const Real turns = random.getValue();
        const State state = gears.makeState(2 * Pi * turns * 35, -2 * Pi * turns * 20);
        EXPECT_NEAR(state.getQErr()[0], 0, Rounding * 1e5) << turns;  // of terms of up to 2e5
    }
    EXPECT_NEAR(std::abs(gears.makeState(0.1, 0).getQErr()[0]), 2, Rounding);
}

// sqrt(2) turns of one for each of the other: the poses do not say which turn; the State does.
TEST(SharedTurns, WhatNoEquationTellsIsReadAndSet) {
    const Wheels wheels("AZ(1)-SQRT(2)*AZ(2)");
    State state = wheels.makeState(2 * Pi * std::sqrt(2) * 5.2, 2 * Pi * 5.2);
    EXPECT_GT(std::abs(state.getQErr()[0]), 0.1);  // what a new State says
    wheels.equation.setTurns(state, Vector(SimTK::Vec2(7, 5)));
    wheels.system.realize(state, Stage::Position);
    EXPECT_NEAR(state.getQErr()[0], 0, Rounding * 100);
    const Vector turns = wheels.equation.getTurns(state);
    EXPECT_NEAR(turns[0], std::sqrt(2) * 5.2, Rounding * 10);
    EXPECT_NEAR(turns[1], 5.2, Rounding * 10);

    State copied = wheels.makeState(0, 0);
    copied.updQ() = state.getQ();
    wheels.equation.setTurns(copied, turns);
    wheels.system.realize(copied, Stage::Position);
    EXPECT_NEAR(copied.getQErr()[0], 0, Rounding * 100);

    copied.updQ() = 0;
    wheels.equation.resetTurns(copied);
    wheels.system.realize(copied, Stage::Position);
    EXPECT_EQ(copied.getQErr()[0], 0);
    EXPECT_EQ(wheels.equation.getTurns(copied).norm(), 0);
}

// Followed by the integrator, also where the equation is switched off.
TEST(SharedTurns, WhatNoEquationTellsIsFollowed) {
    const Wheels wheels("AZ(1)-SQRT(2)*AZ(2)");
    for (const bool disabled : {false, true}) {
        SCOPED_TRACE(disabled);
        State state = wheels.system.getDefaultState();
        if (disabled) wheels.equation.disable(state);
        wheels.a.setOneU(state, 0, 10 * std::sqrt(2));
        wheels.b.setOneU(state, 0, 10);
        SimTK::RungeKuttaMersonIntegrator integrator(wheels.system);
        integrator.setAccuracy(1e-8);
        integrator.setMaximumStepSize(0.1);  // less than half a turn
        SimTK::TimeStepper stepper(wheels.system, integrator);
        stepper.initialize(state);
        stepper.stepTo(3);
        State end = stepper.getState();
        wheels.equation.enable(end);
        wheels.system.realize(end, Stage::Position);
        EXPECT_NEAR(end.getQErr()[0], 0, IntegratorTolerance);
        EXPECT_NEAR(wheels.equation.getTurns(end)[1], 30 / (2 * Pi), IntegratorTolerance);
    }
}

TEST(SharedTurns, MistakesAreExplained) {
    const Wheels wheels("AZ(1)-SQRT(2)*AZ(2)");
    State state = wheels.makeState(0, 0);
    EXPECT_EQ(catchError([&] { wheels.equation.setTurns(state, Vector(3, 1.0)); }),
              "gears: the turns of 3 angles are given; AX, AY and AZ are 2 in it");
    EXPECT_EQ(catchError([&] { wheels.equation.setTurns(state, Vector(2, SimTK::NaN)); }),
              "gears: a number of turns must be finite, not nan");
}

}  // namespace
}  // namespace jprim
