// SPDX-License-Identifier: Apache-2.0
// Equations that say themselves in which turn they are: in every State, whatever happened before.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "jprim/joint/joint.h"
#include "support/conformance.h"
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

// Of errors, in the size of the travel, after some turns.
constexpr Real Rounding = 1e-12;
// Of accuracy 1e-8 over a few seconds.
constexpr Real IntegratorTolerance = 1e-6;

// A nut that turns and travels along an axis in general position, and what makes the two go together.
struct Nut {
    using AddEquation = std::function<GeneralConstraint(const Marker& I, const Marker& J)>;

    explicit Nut(const AddEquation& add, const Transform& X = Transform())
        : nut(matter.Ground(), X, Body::Rigid(MassProperties(1, Vec3(0), Inertia(0.01))), Transform()),
          equation(add(Marker(nut), Marker(matter.updGround(), X))) {
        system.realizeTopology();
    }

    State makeState(Real angle, Real travel, Real rate = 0) const {
        State state = system.getDefaultState();
        nut.setOneQ(state, 0, angle);
        nut.setOneQ(state, 1, travel);
        nut.setOneU(state, 0, rate);
        system.realize(state, Stage::Velocity);
        return state;
    }

    Real calcError(Real angle, Real travel) const { return makeState(angle, travel).getQErr()[0]; }

    State run(State state, Real seconds) const {
        system.realize(state, Stage::Velocity);
        system.projectU(state, 1e-10);
        SimTK::RungeKuttaMersonIntegrator integrator(system);
        integrator.setAccuracy(1e-8);
        SimTK::TimeStepper stepper(system, integrator);
        stepper.initialize(state);
        stepper.stepTo(state.getTime() + seconds);
        State end = stepper.getState();
        system.realize(end, Stage::Acceleration);
        return end;
    }

    MultibodySystem system;
    SimbodyMatterSubsystem matter{system};
    MobilizedBody::Cylinder nut;
    GeneralConstraint equation;
};

constexpr Real Pitch = 0.1;

Nut::AddEquation makeScrew(Real pitch, Real offset = 0) {
    return [=](const Marker& I, const Marker& J) {
        return *Joint::Screw(I, J, pitch, offset, "screw").getGeneralConstraint();
    };
}

Nut::AddEquation makeGcon(const std::string& text) {
    return [=](const Marker& I, const Marker& J) {
        return GeneralConstraint(Expression(text, {{1, I}, {2, J}}));
    };
}

Real getTravelPerTurn(const Nut& nut, const State& state) {
    return nut.nut.getOneQ(state, 1) / (nut.nut.getOneQ(state, 0) / (2 * Pi));
}

//------------------------------------------------------------------------------------- after a run
TEST(Turns, AStateSetBackToItsStartHasNoError) {
    const Nut screw(makeScrew(Pitch));
    State state = screw.run(screw.makeState(0, 0, 10), 3);
    const Real angle = screw.nut.getOneQ(state, 0);
    EXPECT_GT(angle, 4 * 2 * Pi);
    EXPECT_NEAR(getTravelPerTurn(screw, state), Pitch, IntegratorTolerance);
    EXPECT_NEAR(screw.equation.getTurns(state)[0], screw.nut.getOneQ(state, 0) / (2 * Pi), Rounding);
    state.setTime(0);
    state.updQ() = 0;
    screw.system.realize(state, Stage::Position);
    EXPECT_EQ(state.getQErr()[0], 0);
    EXPECT_EQ(screw.equation.getTurns(state)[0], 0);

    // A second run goes as the first did.
    state.updU() = screw.makeState(0, 0, 10).getU();
    const State again = screw.run(state, 3);
    EXPECT_NEAR(getTravelPerTurn(screw, again), Pitch, IntegratorTolerance);
    EXPECT_NEAR(screw.nut.getOneQ(again, 0), angle, IntegratorTolerance);
}

TEST(Turns, FinalCoordinatesInANewStateHaveNoError) {
    const Nut screw(makeScrew(Pitch));
    const State end = screw.run(screw.makeState(0, 0, 10), 3);
    State fresh = screw.system.getDefaultState();
    fresh.setTime(end.getTime());
    fresh.updQ() = end.getQ();
    fresh.updU() = end.getU();
    screw.system.realize(fresh, Stage::Position);
    EXPECT_NEAR(fresh.getQErr()[0], end.getQErr()[0], Rounding);
    const State onward = screw.run(fresh, 1), same = screw.run(end, 1);
    EXPECT_LT((onward.getQ() - same.getQ()).norm(), IntegratorTolerance);
}

TEST(Turns, AScrewSwitchedOffForSomeTurnsFindsItsThread) {
    const Nut screw(makeScrew(Pitch));
    State state = screw.makeState(0, 0, 10);
    screw.equation.disable(state);
    screw.nut.setOneU(state, 1, 10 * Pitch / (2 * Pi));  // just as the thread would have it
    state = screw.run(state, 1.5);
    EXPECT_NEAR(screw.nut.getOneQ(state, 0), 15, IntegratorTolerance);
    screw.equation.enable(state);
    screw.system.realize(state, Stage::Position);
    EXPECT_NEAR(state.getQErr()[0], 0, IntegratorTolerance);
}

TEST(Turns, AnAssemblerFollowsTheThread) {
    const Nut screw(makeScrew(Pitch));
    State state = screw.system.getDefaultState();
    SimTK::Assembler assembler(screw.system);
    auto* angle = new SimTK::QValue(screw.nut, SimTK::MobilizerQIndex(0), 0);
    assembler.adoptAssemblyGoal(angle, SimTK::Infinity);
    assembler.initialize(state);
    assembler.assemble();
    constexpr Real AssemblyTolerance = 1e-4;  // Simbody's default is 1e-3 of what changes errors by about one
    for (int step = 1; step <= 40; ++step) {
        angle->setValue(step);  // six turns in steps of 57 degrees
        assembler.track();
        assembler.updateFromInternalState(state);
        EXPECT_NEAR(screw.nut.getOneQ(state, 1), step * Pitch / (2 * Pi), AssemblyTolerance) << step;
    }
}

TEST(Turns, OfTwoStatesOfOneSystemNeitherDisturbsTheOther) {
    const Nut screw(makeScrew(Pitch));
    State far = screw.makeState(2 * Pi * 7.3, Pitch * 7.3),
          near = screw.makeState(0.4, Pitch * 0.4 / (2 * Pi));
    for (const int repeat : {1, 2, 3}) {
        SCOPED_TRACE(repeat);
        far.updQ();
        screw.system.realize(far, Stage::Position);
        near.updQ();
        screw.system.realize(near, Stage::Position);
        EXPECT_NEAR(far.getQErr()[0], 0, Rounding);
        EXPECT_NEAR(near.getQErr()[0], 0, Rounding);
        EXPECT_NEAR(screw.equation.getTurns(far)[0], 7.3, Rounding);
    }
}

//---------------------------------------------------------------------------- any pitch, axis, turn
struct RandomCase {
    Real perTurn, offset, turns, defect;  // travel per turn; how far off the thread, in threads
    Transform X;
};

// Pitches over four decades, of either hand.
RandomCase makeRandomCase(int seed) {
    Random::Uniform random(-1, 1);
    random.setSeed(seed);
    const Real perTurn = std::pow(10, 2 * random.getValue()) * (random.getValue() < 0 ? -1 : 1);
    return {perTurn, 3 * random.getValue(), 50 * random.getValue(), 0.45 * random.getValue(),
            Transform(testing::makeRandomRotation(random), testing::makeRandomVec3(random))};
}

constexpr int NumSeeds = 200;

// Whatever the turn, the error is that of the nearest thread.
void expectNearestThread(const Nut& nut, const RandomCase& c, Real signOfError) {
    const Real angle = 2 * Pi * c.turns, travel = c.perTurn * (c.turns + c.defect) + c.offset;
    const Real size = std::abs(c.perTurn) * 50 + std::abs(c.offset) + 1;
    EXPECT_NEAR(nut.calcError(angle, travel), signOfError * c.perTurn * c.defect, Rounding * size);
    EXPECT_NEAR(nut.equation.getTurns(nut.makeState(angle, travel))[0], c.turns, Rounding * 100);
}

TEST(Turns, AScrewTakesTheNearestThread) {
    for (int seed = 1; seed <= NumSeeds; ++seed) {
        SCOPED_TRACE(seed);
        const RandomCase c = makeRandomCase(seed);
        expectNearestThread(Nut(makeScrew(c.perTurn, c.offset), c.X), c, 1);
    }
}

// The same, written by hand.
TEST(Turns, AnEquationOfOneAngleTakesTheNearestTurn) {
    for (int seed = 1; seed <= NumSeeds; ++seed) {
        SCOPED_TRACE(seed);
        const RandomCase c = makeRandomCase(seed);
        const std::string text = "AZ(1,2)*(" + std::to_string(c.perTurn) + ")/(2*PI)-DZ(1,2,2)";
        RandomCase rounded = c;
        rounded.perTurn = std::stod(std::to_string(c.perTurn));
        rounded.offset = 0;
        expectNearestThread(Nut(makeGcon(text), c.X), rounded, -1);
    }
}

TEST(Turns, AnAngleDrivenByAFunctionHasNoTurnsToLose) {
    const Nut driven(makeGcon("AZ(1,2)-40*TIME"));
    for (const Real time : {0.0, 0.3, 2.9, -5.0}) {
        State state = driven.makeState(40 * time, 0.3);
        state.setTime(time);
        driven.system.realize(state, Stage::Position);
        EXPECT_NEAR(state.getQErr()[0], 0, Rounding * 100);
    }
}

// A pinion and a rack along its x axis: the pinion's centre goes back along the rack as the rack goes on.
TEST(Turns, ARackpinTakesTheNearestTooth) {
    for (int seed = 1; seed <= NumSeeds; ++seed) {
        SCOPED_TRACE(seed);
        const RandomCase c = makeRandomCase(seed);
        MultibodySystem system;
        SimbodyMatterSubsystem matter(system);
        const Body::Rigid body(MassProperties(1, Vec3(0), Inertia(1)));
        const MobilizedBody::Pin pinion(matter.Ground(), c.X, body, Transform());
        const MobilizedBody::Slider rack(matter.Ground(), c.X, body, Transform());
        const Marker alongTravel(rack, Transform(SimTK::Rotation(Pi / 2, SimTK::YAxis)));
        const Joint joint = Joint::Rackpin(Marker(pinion), alongTravel, c.perTurn / Pi, c.offset, "rackpin");
        State state = system.realizeTopology();
        pinion.setOneQ(state, 0, 2 * Pi * c.turns);
        rack.setOneQ(state, 0, -(c.perTurn * (c.turns + c.defect) + c.offset));
        system.realize(state, Stage::Position);
        EXPECT_NEAR(state.getQErr()[0], c.perTurn * c.defect, Rounding * (std::abs(c.perTurn) * 50 + 4));
        EXPECT_NEAR(joint.getTurns(state)[0], c.turns, Rounding * 100);
    }
}

// The error may not hide what is no turn: half a thread off is half a thread off.
TEST(Turns, AnotherPitchIsNoticed) {
    const Nut screw(makeScrew(Pitch * 1.01));
    EXPECT_NEAR(screw.calcError(2 * Pi * 20, Pitch * 20), -0.2 * Pitch, 1e-3 * Pitch);
}

TEST(Turns, MistakesAreExplained) {
    const Nut screw(makeScrew(Pitch));
    State state = screw.makeState(0, 0);
    EXPECT_EQ(catchError([&] { screw.equation.setTurns(state, Vector()); }),
              "screw: the turns of 0 angles are given; AX, AY and AZ are 1 in it");
}

}  // namespace
}  // namespace jprim
