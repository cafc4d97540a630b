// SPDX-License-Identifier: Apache-2.0
// What README says of threads: a System each.
#include <gtest/gtest.h>

#include <thread>

#include "jprim/force/expression_measure.h"
#include "jprim/force/marker_force.h"
#include "jprim/joint/joint.h"

namespace jprim {
namespace {

using SimTK::Body;
using SimTK::MassProperties;
using SimTK::MobilizedBody;
using SimTK::Real;
using SimTK::Stage;
using SimTK::State;
using SimTK::Vec3;
using SimTK::Vector;

/// Two arms, driven by a spring and joined by constraints.
class Arms {
public:
    Arms() {
        const Joint shoulder = Joint::Revolute(Marker(m_a, Vec3(-0.5, 0, 0)), m_G);
        const Joint elbow = Joint::Revolute(m_C, Marker(m_a, Vec3(0.5, 0, 0)));
        const GeneralConstraint gear(Expression("AZ(1,3)-2*AZ(2,1)", {{1, Marker(m_a)}, {2, m_C}, {3, m_G}}));
        m_initial = m_system.realizeTopology();
    }

    /// Thrown with a spin of its own, so that States differ; what all elements say at the end.
    Vector run(Real spin) const {
        State state = m_initial;
        m_a.setQToFitTranslation(state, Vec3(0.5, 0, 0));
        m_b.setQToFitTranslation(state, Vec3(1.4, 0, 0));
        m_a.setUToFitAngularVelocity(state, Vec3(0, 0, spin));
        SimTK::RungeKuttaMersonIntegrator integrator(m_system);
        integrator.setAccuracy(1e-6);
        SimTK::TimeStepper stepper(m_system, integrator);
        stepper.initialize(state);
        stepper.stepTo(0.4);
        const State& end = stepper.getState();
        m_system.realize(end, Stage::Acceleration);
        Vector all(end.getNQ() + end.getNU() + 2);
        all(0, end.getNQ()) = end.getQ();
        all(end.getNQ(), end.getNU()) = end.getUDot();
        all[all.size() - 2] = m_spring.calcLoadOnJ(end).norm();
        all[all.size() - 1] = m_angle.calcValue(end);
        return all;
    }

private:
    MarkerForce addSpring() {
        ForceLaw law;
        law.force = Expression("-20*DXYZ(1,2)-STEP(TIME,0,0,1,1)*VXYZ(1)", {{1, m_C}, {2, m_G}});
        return MarkerForce(m_forces, m_C, m_G, law);
    }

    SimTK::MultibodySystem m_system;
    SimTK::SimbodyMatterSubsystem m_matter{m_system};
    SimTK::GeneralForceSubsystem m_forces{m_system};
    SimTK::Force::Gravity m_gravity{m_forces, m_matter, Vec3(0, -9.81, 0)};
    Body::Rigid m_body{MassProperties(1.3, Vec3(0), SimTK::Inertia(0.1, 0.2, 0.25))};
    MobilizedBody::Free m_a{m_matter.Ground(), m_body}, m_b{m_matter.Ground(), m_body};
    Marker m_G{m_matter.Ground()}, m_C{m_b, Vec3(-0.4, 0, 0)};
    MarkerForce m_spring = addSpring();
    ExpressionMeasure m_angle{m_forces,
                              Expression("AZ(1,3)+DM(2,3)", {{1, Marker(m_a)}, {2, m_C}, {3, m_G}})};
    State m_initial;
};

// Two threads at once, each several runs; every run the same to the last digit as when it is alone.
TEST(Threads, EachWithItsSystem) {
    constexpr int Threads = 2, Runs = 3;
    const auto spin = [](int thread, int run) { return 1.5 + thread + 0.37 * run; };
    const Arms arms[Threads];
    std::vector<Vector> together(Threads * Runs);
    std::vector<std::thread> threads;
    for (int k = 0; k < Threads; ++k)
        threads.emplace_back([&, k] {
            for (int r = 0; r < Runs; ++r) together[size_t(k * Runs + r)] = arms[k].run(spin(k, r));
        });
    for (std::thread& thread : threads) thread.join();
    for (int k = 0; k < Threads; ++k)
        for (int r = 0; r < Runs; ++r) {
            const Vector alone = arms[k].run(spin(k, r));
            EXPECT_TRUE(std::isfinite(alone.norm()));
            EXPECT_EQ((alone - together[size_t(k * Runs + r)]).norm(), 0) << "thread " << k << " run " << r;
        }
    // The comparison can fail: other spins give other numbers.
    EXPECT_GT((together[0] - together[1]).norm(), 1e-3);
}

}  // namespace
}  // namespace jprim
