// SPDX-License-Identifier: Apache-2.0
// Forces given by expressions, against closed forms and against their own reaction and energy.
#include "jprim/force/marker_force.h"

#include <gtest/gtest.h>

#include "jprim/flexible/reduce_to_modes.h"
#include "jprim/force/expression_measure.h"
#include "support/expect_error.h"
#include "support/steel_beam.h"

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

constexpr Real Rounding = 1e-12;

State simulate(const MultibodySystem& system, const State& initial, Real time) {
    SimTK::RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(1e-9);
    SimTK::TimeStepper stepper(system, integrator);
    stepper.initialize(initial);
    stepper.stepTo(time);
    State end = stepper.getState();
    system.realize(end, Stage::Acceleration);
    return end;
}

// A wheel on a torsional spring, thrown through more than three turns and back:
// angle = W/w sin(w t) with w^2 = k/J.
TEST(MarkerForce, ATorsionalSpringCountsTurns) {
    const Real J = 0.4, k = 0.9, W = 40, w = std::sqrt(k / J), amplitude = W / w;
    ASSERT_GT(amplitude, 6 * SimTK::Pi);
    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    GeneralForceSubsystem forces(system);
    MobilizedBody::Pin wheel(matter.Ground(), Body::Rigid(MassProperties(1, Vec3(0), Inertia(1, 1, J))));
    const Marker I(wheel), G(matter.updGround());
    ForceLaw law;
    law.moment = Expression("UVZ(2)*(-0.9*AZ(1,2))", {{1, I}, {2, G}});
    law.potential = Expression("0.9/2*AZ(1,2)**2", {{1, I}, {2, G}});
    const MarkerForce spring(forces, I, G, law, "spring");
    const ExpressionMeasure angle(forces, Expression("AZ(1,2)", {{1, I}, {2, G}}));
    State state = system.realizeTopology();
    wheel.setRate(state, W);
    system.realize(state, Stage::Velocity);
    const Real energy = system.calcEnergy(state);
    constexpr Real IntegratorTolerance = 1e-6;  // relative, of accuracy 1e-9
    for (const Real time : {0.3, 1.0, 2.9}) {
        const State end = simulate(system, state, time);
        const Real expected = amplitude * std::sin(w * time);
        EXPECT_NEAR(wheel.getAngle(end), expected, IntegratorTolerance * amplitude);
        EXPECT_NEAR(angle.calcValue(end), expected, IntegratorTolerance * amplitude);
        EXPECT_NEAR(spring.calcLoadOnI(end)[0][2], -k * expected, k * IntegratorTolerance * amplitude);
        EXPECT_NEAR(system.calcEnergy(end), energy, IntegratorTolerance * energy);
    }
}

// An internal load changes neither momentum: on rigid bodies, and on nodes of flexible ones.
TEST(MarkerForce, TheReactionIsAtThePlaceOfI) {
    for (const bool flexible : {false, true}) {
        SCOPED_TRACE(flexible);
        MultibodySystem system;
        SimbodyMatterSubsystem matter(system);
        GeneralForceSubsystem forces(system);
        const Body::Rigid body(MassProperties(1.7, Vec3(0.1, -0.2, 0.05), Inertia(0.5, 0.6, 0.4)));
        MobilizedBody::Free a(matter.Ground(), body), b(matter.Ground(), body);
        const Transform X(Rotation(0.7, Vec3(1, -2, 0.5)), Vec3(0.4, -0.1, 0.25));
        Marker I(a, X), J(b);
        if (flexible) {
            const ModalBasis basis =
                reduceToModes(makeFiniteElementModel(testing::makeSteelBeam(3)), {{{4}, 0, {}}}, 3);
            FlexibleBodyOptions options;  // the coupling that conserves momentum
            options.coupling = InertiaCoupling::Constant;
            J = Marker(FlexibleBody(matter, forces, basis, options), 4, X);
        }
        ForceLaw law;
        law.force = Expression("[3,-2,1]*DX(1,2)+UVX(1)*VY(1,2)", {{1, I}, {2, J}});
        law.moment = Expression("UVY(2)*4", {{1, I}, {2, J}});
        const MarkerForce force(forces, I, J, law, "GFORCE/1");
        State state = system.realizeTopology();
        a.setQToFitTransform(state, Transform(Rotation(0.4, SimTK::YAxis), Vec3(1, 2, -0.7)));
        a.setUToFitVelocity(state, SpatialVec(Vec3(1, -2, 0.5), Vec3(0.3, 0.7, -0.2)));
        system.realize(state, Stage::Acceleration);
        const SpatialVec onI = force.calcLoadOnI(state), onJ = force.calcLoadOnJ(state);
        const Vec3 r = I.findPoseInGround(state).p() - J.findPoseInGround(state).p();
        EXPECT_GT(onI[1].norm(), 1);
        EXPECT_LT((onJ[1] + onI[1]).norm(), Rounding);
        EXPECT_LT((onJ[0] + onI[0] + r % onI[1]).norm(), Rounding);

        // Momentum of the whole system, about Ground's origin.
        const SpatialVec before = matter.calcSystemMomentumAboutGroundOrigin(state);
        constexpr Real Short = 1e-3;
        const State after = simulate(system, state, Short);
        const SpatialVec change = matter.calcSystemMomentumAboutGroundOrigin(after) - before;
        constexpr Real IntegratorTolerance = 1e-9;  // the load times Short is 1e-2
        EXPECT_LT(change.norm(), IntegratorTolerance);
    }
}

TEST(MarkerForce, MistakesAreExplained) {
    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    GeneralForceSubsystem forces(system);
    const Marker G(matter.updGround());
    const auto message = [&](const char* force, const char* potential) {
        return catchError([&] {
            ForceLaw law;
            law.force = Expression(force, {{1, G}});
            law.potential = Expression(potential, {{1, G}});
            MarkerForce(forces, G, std::nullopt, law, "SFORCE/4");
        });
    };
    EXPECT_EQ(message("3", "0"), "SFORCE/4: its force must be a vector");
    EXPECT_EQ(message("[1,2,3]", "[1,2,3]"), "SFORCE/4: its potential must be a number");
    EXPECT_EQ(message("ACCXYZ(1)", "0"),
              "SFORCE/4: a force cannot depend on accelerations or reactions, which are known only when all "
              "forces are");
    EXPECT_EQ(
        catchError([&] { MarkerForce(forces, Marker(), std::nullopt, ForceLaw(), "SFORCE/4"); }),
        "SFORCE/4: marker I is not on a body; construct it with a MobilizedBody that has been added to a matter "
        "subsystem");
    EXPECT_EQ(catchError([&] {
                  ExpressionMeasure(forces, Expression("UVX(1)", {{1, G}}));
              }),
              "expression: it is a vector where a number is needed");
}

}  // namespace
}  // namespace jprim
