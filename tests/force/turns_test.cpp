// SPDX-License-Identifier: Apache-2.0
// Turns that nothing but the State remembers: those of forces and measures.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "jprim/force/expression_measure.h"
#include "jprim/force/marker_force.h"
#include "support/expect_error.h"

namespace jprim {
namespace {

using SimTK::Body;
using SimTK::GeneralForceSubsystem;
using SimTK::Inertia;
using SimTK::MassProperties;
using SimTK::MobilizedBody;
using SimTK::MultibodySystem;
using SimTK::Pi;
using SimTK::Real;
using SimTK::SimbodyMatterSubsystem;
using SimTK::Stage;
using SimTK::State;
using SimTK::Vec3;
using SimTK::Vector;
using testing::catchError;

// Relative, of accuracy 1e-9.
constexpr Real IntegratorTolerance = 1e-6;

// A wheel on a torsional spring, thrown through more than three turns and back.
struct Wheel {
    static constexpr Real J = 0.4, K = 0.9, W = 40;

    Wheel() {
        ForceLaw law;
        law.moment = Expression("UVZ(2)*(-0.9*AZ(1,2))", {{1, I}, {2, G}});
        law.potential = Expression("0.9/2*AZ(1,2)**2", {{1, I}, {2, G}});
        spring = MarkerForce(forces, I, G, law, "spring");
        angle = ExpressionMeasure(forces, Expression("AZ(1,2)+2*AX(1,2)", {{1, I}, {2, G}}));
        system.realizeTopology();
    }

    State start() const {
        State state = system.getDefaultState();
        wheel.setOneU(state, 0, W);
        return state;
    }

    State run(const State& initial, Real until) const {
        SimTK::RungeKuttaMersonIntegrator integrator(system);
        integrator.setAccuracy(1e-9);
        SimTK::TimeStepper stepper(system, integrator);
        stepper.initialize(initial);
        stepper.stepTo(until);
        State end = stepper.getState();
        system.realize(end, Stage::Acceleration);
        return end;
    }

    static Real calcAngle(Real time) {
        const Real w = std::sqrt(K / J);
        return W / w * std::sin(w * time);
    }

    MultibodySystem system;
    SimbodyMatterSubsystem matter{system};
    GeneralForceSubsystem forces{system};
    MobilizedBody::Pin wheel{matter.Ground(), Body::Rigid(MassProperties(1, Vec3(0), Inertia(1, 1, J)))};
    Marker I{wheel}, G{matter.updGround()};
    MarkerForce spring;
    ExpressionMeasure angle;
};

constexpr Real Amplitude = 27;  // of the angle, in rad: more than four turns

std::string write(const Vector& v) {
    std::ostringstream text;
    text.precision(17);
    for (int k = 0; k < v.size(); ++k) text << v[k] << ' ';
    return text.str();
}

Vector read(const std::string& text) {
    std::istringstream in(text);
    std::vector<Real> values;
    for (Real x = 0; in >> x;) values.push_back(x);
    return Vector(int(values.size()), values.data());
}

// Stopped at 0.9 s, copied to text and back, and gone on.
TEST(ForceTurns, AStateCopiedAsTextGoesOnTheSame) {
    const Wheel w;
    const State stopped = w.run(w.start(), 0.9);
    ASSERT_GT(stopped.getQ()[0], 3 * 2 * Pi);
    const std::string q = write(stopped.getQ()), u = write(stopped.getU());
    const std::string ofSpring = write(w.spring.getTurns(stopped)),
                      ofAngle = write(w.angle.getTurns(stopped));
    for (const bool turns : {true, false}) {
        SCOPED_TRACE(turns);
        State fresh = w.system.getDefaultState();
        fresh.setTime(0.9);
        fresh.updQ() = read(q);
        fresh.updU() = read(u);
        if (turns) {
            w.spring.setTurns(fresh, read(ofSpring));
            w.angle.setTurns(fresh, read(ofAngle));
        }
        const State end = w.run(fresh, 2.5);
        const Real expected = Wheel::calcAngle(2.5);
        if (turns) {
            EXPECT_NEAR(end.getQ()[0], expected, IntegratorTolerance * Amplitude);
            EXPECT_NEAR(w.angle.calcValue(end), expected, IntegratorTolerance * Amplitude);
        } else {
            EXPECT_GT(std::abs(end.getQ()[0] - expected), 1);  // turns are needed
        }
    }
}

TEST(ForceTurns, AStateSetBackIsResetAndRunsAgain) {
    const Wheel w;
    State state = w.run(w.start(), 0.9);
    state.setTime(0);
    state.updQ() = 0;
    w.wheel.setOneU(state, 0, Wheel::W);
    w.system.realize(state, Stage::Position);
    EXPECT_GT(w.angle.calcValue(state), 2 * Pi);  // not reset yet: it is told nothing
    w.spring.resetTurns(state);
    w.angle.resetTurns(state);
    const State end = w.run(state, 0.9);
    EXPECT_NEAR(end.getQ()[0], Wheel::calcAngle(0.9), IntegratorTolerance * Amplitude);
    EXPECT_NEAR(w.spring.getTurns(end)[0], Wheel::calcAngle(0.9) / (2 * Pi), IntegratorTolerance * Amplitude);
}

TEST(ForceTurns, ADisabledForceIsFollowed) {
    const Wheel w;
    State state = w.start();
    w.spring.disable(state);
    w.angle.disable(state);
    SimTK::RungeKuttaMersonIntegrator integrator(w.system);
    integrator.setMaximumStepSize(0.05);  // 2 rad
    SimTK::TimeStepper stepper(w.system, integrator);
    stepper.initialize(state);
    stepper.stepTo(0.7);
    state = stepper.getState();
    w.spring.enable(state);
    w.system.realize(state, Stage::Velocity);
    EXPECT_NEAR(w.spring.calcLoadOnI(state)[0][2], -Wheel::K * Wheel::W * 0.7,
                IntegratorTolerance * Amplitude);
    EXPECT_NEAR(w.angle.calcValue(state), Wheel::W * 0.7, IntegratorTolerance * Amplitude);
}

// What is realized in between, at other times and positions, leaves no trace.
TEST(ForceTurns, StatesRealizedOutOfOrderDoNotDisturb) {
    const Wheel w;
    const State start = w.start(), far = w.run(start, 0.9);
    State other = far;
    for (const Real angle : {-70.0, 3.0, 55.0}) {
        w.wheel.setOneQ(other, 0, angle);
        w.system.realize(other, Stage::Acceleration);
    }
    w.wheel.setOneQ(other, 0, far.getQ()[0]);
    w.system.realize(other, Stage::Acceleration);
    EXPECT_EQ(w.angle.calcValue(other), w.angle.calcValue(far));
    const State end = w.run(other, 1.3);
    EXPECT_NEAR(w.angle.calcValue(end), Wheel::calcAngle(1.3), IntegratorTolerance * Amplitude);
    EXPECT_NEAR(w.angle.calcValue(w.run(start, 1.3)), Wheel::calcAngle(1.3), IntegratorTolerance * Amplitude);
}

TEST(ForceTurns, EachExpressionHasItsOwn) {
    const Wheel w;
    const State end = w.run(w.start(), 0.9);
    const Vector spring = w.spring.getTurns(end), angle = w.angle.getTurns(end);
    ASSERT_EQ(spring.size(), 2);  // of moment and potential
    ASSERT_EQ(angle.size(), 2);   // AZ and AX
    EXPECT_EQ(spring[0], spring[1]);
    EXPECT_EQ(angle[0], spring[0]);
    EXPECT_EQ(angle[1], 0);
    State state = end;
    EXPECT_EQ(catchError([&] { w.spring.setTurns(state, Vector(1, 0.0)); }),
              "spring: the turns of 1 angles are given; AX, AY and AZ are 2 in it");
    w.spring.setTurns(state, Vector(SimTK::Vec2(0, 4)));  // told apart
    w.system.realize(state, Stage::Velocity);
    EXPECT_NEAR(w.spring.calcLoadOnI(state)[0][2], -Wheel::K * std::remainder(end.getQ()[0], 2 * Pi), 1e-12);
}

}  // namespace
}  // namespace jprim
