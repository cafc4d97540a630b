// SPDX-License-Identifier: Apache-2.0
// Equations that hold nothing, be they all there are, and expressions that have no derivative where they begin.
#include <gtest/gtest.h>

#include <functional>

#include "jprim/joint/joint.h"
#include "jprim/joint/motion.h"
#include "support/expect_error.h"

namespace jprim {
namespace {

using SimTK::Body;
using SimTK::Constraint;
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

constexpr Real Gravity = 9.8, Rounding = 1e-12;
constexpr Real Assembled = 1e-9;

void assembleExactly(const SimTK::MultibodySystem& system, State& state) {
    SimTK::Assembler assembler(system);
    assembler.setErrorTolerance(Assembled / 10);
    assembler.assemble(state);
}

struct Falling {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    SimTK::GeneralForceSubsystem forces{system};
    SimTK::Force::Gravity gravity{forces, matter, Vec3(0, -Gravity, 0)};
    Body::Rigid body{MassProperties(1.3, Vec3(0), SimTK::Inertia(0.1, 0.2, 0.25))};
    MobilizedBody::Free a{matter.Ground(), body}, b{matter.Ground(), body};
    Marker I{a}, J{b}, G{matter.Ground()};

    Expression write(const char* text) { return Expression(text, {{1, I}, {2, J}, {3, G}}); }
};

//---------------------------------------------------------------------------------- all are dropped
void dropAll(const PairConstraint& constraint, State& state) {
    for (int k = 0; k < constraint.getNumEquations(); ++k) constraint.dropEquation(state, k);
}

void expectFree(Falling& f, State& state, const std::function<SpatialVec(const State&)>& calcReaction) {
    f.system.realize(state, Stage::Acceleration);
    for (int k = 0; k < state.getNU(); ++k)
        EXPECT_NEAR(state.getUDot()[k], k % 6 == 4 ? -Gravity : 0, Rounding) << k;
    EXPECT_EQ(calcReaction(state).norm(), 0);
    EXPECT_EQ(state.getUDotErr().norm(), 0);
}

TEST(DroppedEquations, HoldNothingWhereNoOthersAreInUse) {
    Falling f;
    const AtPoint point(f.I, f.G, "p");
    State state = f.system.realizeTopology();
    dropAll(point, state);
    expectFree(f, state, [&](const State& s) { return point.calcReactionOnJ(s); });
}

TEST(DroppedEquations, OfJointsToo) {
    Falling f;
    const Joint hinge = Joint::Revolute(f.I, f.J), screw = Joint::Screw(f.I, f.G, 0.3);
    State state = f.system.realizeTopology();
    dropAll(*hinge.getPairConstraint(), state);
    screw.getGeneralConstraint()->dropEquation(state);
    expectFree(f, state, [&](const State& s) { return hinge.calcReactionOnI(s) + screw.calcReactionOnI(s); });
}

TEST(DroppedEquations, OfMotionsAndVelocities) {
    Falling f;
    std::vector<GeneralConstraint> all = {GeneralConstraint(f.write("DY(1)-0")),
                                          GeneralConstraint(f.write("VX(1,2)+WZ(2)"))};
    for (const KinematicLevel level :
         {KinematicLevel::Position, KinematicLevel::Velocity, KinematicLevel::Acceleration})
        all.push_back(PrescribedMotion(f.I, f.G, Coordinate::Y, Expression("2", {}), level));
    State state = f.system.realizeTopology();
    for (const GeneralConstraint& equation : all) equation.dropEquation(state);
    expectFree(f, state, [&](const State& s) { return all[0].calcReactionOn(s, 1); });
}

// On one body all are dropped, on another one is in use.
TEST(DroppedEquations, BesideOthersOnAnotherBody) {
    Falling f;
    const AtPoint dropped(f.I, f.G);
    const InPlane kept(f.J, Marker(f.matter.Ground(), Rotation(-SimTK::Pi / 2, SimTK::XAxis)));
    State state = f.system.realizeTopology();
    dropAll(dropped, state);
    f.system.realize(state, Stage::Acceleration);
    EXPECT_NEAR(f.a.getBodyOriginAcceleration(state)[1], -Gravity, Rounding);
    EXPECT_NEAR(f.b.getBodyOriginAcceleration(state)[1], 0, Rounding);
    EXPECT_NEAR(kept.calcReactionOnI(state)[1][1], 1.3 * Gravity, Rounding * Gravity);
    EXPECT_EQ(dropped.calcReactionOnI(state).norm(), 0);
}

// They stay so through integration and projection: a free fall.
TEST(DroppedEquations, HoldNothingInARun) {
    constexpr Real Time = 0.7, Fall = Gravity * Time * Time / 2;
    Falling f;
    const Joint hinge = Joint::Revolute(f.I, f.G);
    State state = f.system.realizeTopology();
    dropAll(*hinge.getPairConstraint(), state);
    SimTK::RungeKuttaMersonIntegrator integrator(f.system);
    integrator.setAccuracy(1e-8);
    integrator.setProjectEveryStep(true);
    SimTK::TimeStepper stepper(f.system, integrator);
    stepper.initialize(state);
    stepper.stepTo(Time);
    EXPECT_NEAR(f.a.getBodyOriginLocation(stepper.getState())[1], -Fall, 1e-8);
    hinge.getPairConstraint()->restoreEquation(state, 1);
    f.system.realize(state, Stage::Acceleration);
    EXPECT_NEAR(f.a.getBodyOriginAcceleration(state)[1], 0, Rounding);
}

// Where the only equation cannot move anything, Simbody has no multiplier for it either.
TEST(DroppedEquations, AsGoodAsDroppedWhereNoMobilityFeelsThem) {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter(system);
    SimTK::GeneralForceSubsystem forces(system);
    SimTK::Force::Gravity gravity(forces, matter, Vec3(-Gravity, 0, 0));
    MobilizedBody::Slider slider(matter.Ground(), Body::Rigid(MassProperties(1, Vec3(0), SimTK::Inertia(1))));
    const InPlane plane(Marker(slider), Marker(matter.Ground()));
    State state = system.realizeTopology();
    system.realize(state, Stage::Acceleration);
    EXPECT_NEAR(state.getUDot()[0], -Gravity, Rounding);
    EXPECT_EQ(plane.calcReactionOnI(state).norm(), 0);
}

//------------------------------------------------------------------------------ no derivative here
// The value after assembly from positions as they are by default: all markers in one place, all axes alike.
Real assembleFromDefault(const char* text, const char* value) {
    Falling f;
    const GeneralConstraint equation(f.write(text), "g");
    State state = f.system.realizeTopology();
    f.system.realize(state, Stage::Acceleration);
    EXPECT_TRUE(std::isfinite(state.getUDot().norm()));
    assembleExactly(f.system, state);
    f.system.realize(state, Stage::Acceleration);
    EXPECT_TRUE(std::isfinite(state.getUDot().norm()));
    return f.write(value).calcValue(state);
}

TEST(SingularStart, ADistanceGrowsFromZero) {
    EXPECT_NEAR(assembleFromDefault("DM(1,2)-0.5", "DM(1,2)"), 0.5, Assembled);
    EXPECT_NEAR(assembleFromDefault("3*DM(1,3)+DZ(1,3)-0.7", "3*DM(1,3)+DZ(1,3)"), 0.7, Assembled);
}

// As far as Simbody's own Rod goes, which moves one way of its choice.
TEST(SingularStart, AsSimbodysRodDoes) {
    Falling f;
    Constraint::Rod(f.a, Vec3(0), f.b, Vec3(0), 0.5);
    State state = f.system.realizeTopology();
    assembleExactly(f.system, state);
    f.system.realize(state, Stage::Position);
    EXPECT_NEAR((f.a.getBodyOriginLocation(state) - f.b.getBodyOriginLocation(state)).norm(), 0.5, Assembled);
}

TEST(SingularStart, OnASliderAlongAnyAxis) {
    for (const SimTK::CoordinateAxis axis :
         {SimTK::CoordinateAxis(0), SimTK::CoordinateAxis(1), SimTK::CoordinateAxis(2)}) {
        SimTK::MultibodySystem system;
        SimTK::SimbodyMatterSubsystem matter(system);
        const Rotation R(SimTK::UnitVec3(axis), SimTK::XAxis);
        MobilizedBody::Slider slider(matter.Ground(), R,
                                     Body::Rigid(MassProperties(1, Vec3(0), SimTK::Inertia(1))), R);
        const Expression distance("DM(1,2)-0.5", {{1, Marker(slider)}, {2, Marker(matter.Ground())}});
        const GeneralConstraint equation(distance);
        State state = system.realizeTopology();
        assembleExactly(system, state);
        system.realize(state, Stage::Position);
        EXPECT_NEAR(distance.calcValue(state), 0, Assembled);
    }
}

TEST(SingularStart, AnAngleOpensFromZero) {
    EXPECT_NEAR(assembleFromDefault("THETA(1)-0.1", "THETA(1)"), 0.1, Assembled);
    EXPECT_NEAR(assembleFromDefault("THETA(1,2)-1.1", "THETA(1,2)"), 1.1, Assembled);
}

// Two rays of no length include no angle, and no direction of motion is better than another.
TEST(SingularStart, IsRefusedWhereNoDirectionLeadsOut) {
    const auto refuse = [](const char* text) { return catchError([&] { assembleFromDefault(text, text); }); };
    const std::string reason =
        ", and no motion from here changes it (its derivatives are zero or do not exist); start from another position";
    EXPECT_EQ(refuse("INCANG(1,2,0)-1"), "g: it is not met, its error is -1" + reason);
    EXPECT_EQ(refuse("DM(1,2)**2-0.25"), "g: it is not met, its error is -0.25" + reason);
    EXPECT_EQ(refuse("ABS(DX(1,2))-0.5"), "g: it is not met, its error is -0.5" + reason);
    EXPECT_EQ(refuse("VR(1,2)-1"), "g: it is not met, its error is -1" + reason);
    EXPECT_EQ(refuse("DM(1,2)").rfind("g: the distance between markers 1 and 2 has become zero", 0), 0u);
    EXPECT_EQ(refuse("THETA(1,2)").rfind("g: a length in its expression has become zero", 0), 0u);
}

// No motion changes it, and none needs to: no error, and no reaction.
TEST(SingularStart, AnEquationThatIsMetEverywhereNearbyIsNone) {
    Falling f;
    const GeneralConstraint stop(f.write("STEP(DY(1),-2,1,-1,0)"));
    State state = f.system.realizeTopology();
    f.system.realize(state, Stage::Acceleration);
    EXPECT_NEAR(f.a.getBodyOriginAcceleration(state)[1], -Gravity, Rounding);
    EXPECT_EQ(stop.calcReactionOn(state, 1).norm(), 0);
}

}  // namespace
}  // namespace jprim
