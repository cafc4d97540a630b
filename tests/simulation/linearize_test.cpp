// SPDX-License-Identifier: Apache-2.0
// Any Simbody system linearised on its constraints, against closed forms.
#include "jprim/simulation/linearize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "jprim/general/general_constraint.h"
#include "jprim/primitive/primitives.h"
#include "simulation/derivative.h"
#include "support/expect_error.h"
#include "support/modes_of.h"

namespace jprim {
namespace {

using namespace SimTK;
using Complex = std::complex<double>;

constexpr double ByDifferences = 1e-8;  // of an eigenvalue, relative

struct System {
    MultibodySystem system;
    SimbodyMatterSubsystem matter{system};
    GeneralForceSubsystem forces{system};

    State makeState() {
        State state = system.realizeTopology();
        system.realize(state, Stage::Position);
        return state;
    }
};

Body::Rigid makeBody(Real mass, const Inertia& central = Inertia(1)) {
    return Body::Rigid(MassProperties(mass, Vec3(0), central));
}

void expectEigenvalues(const Eigenmodes& modes, const testing::Eigenvalues& expected) {
    testing::expectEigenvalues(modes.modes, expected, ByDifferences);
}

//-------------------------------------------------------------------------------------------- chains
// n masses between n + 1 springs along x: w_k = 2 sqrt(k/m) sin(k pi/(2 (n + 1))).
TEST(Linearize, AChainOfMassesAndSprings) {
    constexpr int n = 12;
    constexpr Real mass = 0.3, stiffness = 700;
    System s;
    MobilizedBody before = s.matter.Ground();
    std::vector<Complex> expected;
    for (int k = 1; k <= n; ++k) {
        MobilizedBody::Translation body(s.matter.Ground(), makeBody(mass));
        Constraint::PointOnLine(s.matter.Ground(), UnitVec3(XAxis), Vec3(0), body, Vec3(0));
        Force::TwoPointLinearSpring(s.forces, before, Vec3(k == 1 ? -1 : 0, 0, 0), body, Vec3(0), stiffness,
                                    0.8);
        expected.emplace_back(0, 2 * std::sqrt(stiffness / mass) * std::sin(k * Pi / (2 * (n + 1))));
        before = body;
    }
    Force::TwoPointLinearSpring(s.forces, before, Vec3(0), s.matter.Ground(), Vec3(n, 0, 0), stiffness, 0.8);
    State state = s.makeState();
    for (int k = 1; k <= n; ++k)
        s.matter.getMobilizedBody(MobilizedBodyIndex(k)).setQToFitTranslation(state, Vec3(k - 1, 0, 0));
    s.system.realize(state, Stage::Position);
    const LinearModel model = linearize(s.system, state);
    EXPECT_EQ(model.numPositions, n);
    EXPECT_EQ(model.numSpeeds, n);
    EXPECT_LT(model.uDot.normInf(), 1e-12);
    expectEigenvalues(calcEigenmodes(model), expected);
}

TEST(Linearize, ADampedOscillatorIsAComplexPairOrTwoRealValues) {
    for (const Real ratio : {0.1, 0.999, 1.5}) {
        constexpr Real mass = 2, stiffness = 50, w = 5;
        System s;
        MobilizedBody::Slider body(s.matter.Ground(), makeBody(mass));
        Force::MobilityLinearSpring(s.forces, body, MobilizerQIndex(0), stiffness, 0);
        Force::MobilityLinearDamper(s.forces, body, MobilizerUIndex(0), 2 * ratio * mass * w);
        const Eigenmodes modes = calcEigenmodes(linearize(s.system, s.makeState()));
        const Complex root = std::sqrt(Complex(ratio * ratio - 1));
        std::vector<Complex> expected = {w * (-ratio + root)};
        if (ratio > 1) expected.push_back(w * (-ratio - root));
        expectEigenvalues(modes, expected);
        EXPECT_NEAR(modes.modes[0].getDampingRatio(), std::min(ratio, 1.), 1e-8);
        EXPECT_FALSE(modes.modes[0].isUnstable());
        EXPECT_NEAR(modes.modes[0].getFrequency(), std::abs(expected[0]) / (2 * Pi), 1e-8);
    }
}

// What pushes away from an upright position: real values, one of them unstable.
TEST(Linearize, AnUprightPendulumFallsOver) {
    System s;
    MobilizedBody::Pin body(s.matter.Ground(), Transform(), makeBody(2), Transform(Vec3(0, -0.5, 0)));
    Force::Gravity(s.forces, s.matter, Vec3(0, -9.81, 0));
    const Eigenmodes modes = calcEigenmodes(linearize(s.system, s.makeState()));
    const Real rate = std::sqrt(2 * 9.81 * 0.5 / (1 + 2 * 0.25));
    expectEigenvalues(modes, {rate, -rate});
    EXPECT_EQ(std::count_if(modes.modes.begin(), modes.modes.end(),
                            [](const Eigenmode& mode) { return mode.isUnstable(); }),
              1);
}

//-------------------------------------------------------------------------------------- zero modes
TEST(Linearize, RigidBodyMotionsAreZeroExactly) {
    System s;
    MobilizedBody::Free a(s.matter.Ground(), makeBody(2)), b(s.matter.Ground(), makeBody(3));
    Force::TwoPointLinearSpring(s.forces, a, Vec3(0), b, Vec3(0), 1e4, 1);
    State state = s.makeState();
    b.setQToFitTranslation(state, Vec3(0.6, 0.8, 0));
    const Eigenmodes modes = calcEigenmodes(linearize(s.system, state));
    EXPECT_EQ(modes.numZero, 22);
    ASSERT_EQ(modes.modes.size(), 12u);
    for (int k = 0; k < 11; ++k) {
        EXPECT_TRUE(modes.modes[k].isZero);
        EXPECT_EQ(modes.modes[k].eigenvalue, 0.);
        EXPECT_FALSE(modes.modes[k].isUnstable());
    }
    expectEigenvalues(modes, {Complex(0, std::sqrt(1e4 / 1.2))});
}

//-------------------------------------------------------------------------------------- constraints
// A rod between a slider on x and one on y in a spring's plane: its closed form is that of the coordinate theta,
// x = l cos, y = l sin; (J + m l^2/4) in every position for a slender rod, V = k (l sin theta - y0)^2/2.
TEST(Linearize, ALadderInAClosedLoop) {
    constexpr Real mass = 3, J = 0.2, l = 1.3, stiffness = 400, theta = 0.7;
    System s;
    MobilizedBody::Free rod(s.matter.Ground(), makeBody(mass, Inertia(0.1, J, J)));
    const Marker foot(rod, Transform(Vec3(l / 2, 0, 0))), head(rod, Transform(Vec3(-l / 2, 0, 0)));
    const Marker ground(s.matter.Ground());
    const Marker alongX(s.matter.Ground(), Transform(Rotation(Pi / 2, YAxis)));
    const Marker alongY(s.matter.Ground(), Transform(Rotation(-Pi / 2, XAxis)));
    const InLine onX(foot, alongX), onY(head, alongY);
    const Perpendicular upright(Marker(rod, Transform()),
                                Marker(s.matter.Ground(), Transform(Rotation(Pi / 2, YAxis))));
    Force::TwoPointLinearSpring(s.forces, s.matter.Ground(), Vec3(0, 5, 0), rod, Vec3(-l / 2, 0, 0),
                                stiffness, 5 - l * std::sin(theta));
    State state = s.makeState();
    rod.setQToFitTransform(
        state, Transform(Rotation(-theta, ZAxis), Vec3(l / 2 * std::cos(theta), l / 2 * std::sin(theta), 0)));
    s.system.realize(state, Stage::Position);
    const LinearModel model = linearize(s.system, state);
    EXPECT_EQ(model.numPositions, 1);
    const Real w = std::sqrt(stiffness * square(l * std::cos(theta)) / (J + mass * l * l / 4));
    expectEigenvalues(calcEigenmodes(model), {Complex(0, w)});
}

// A pendulum on a rod whose weight pulls slantwise. Along one coordinate alone, off the tangent space, differences see
// half of the stiffness.
TEST(Linearize, OnlyTheTangentSpaceTellsTheStiffness) {
    constexpr Real length = 0.7, g = 9.81;
    System s;
    MobilizedBody::Translation bob(s.matter.Ground(), makeBody(2));
    Constraint::Rod(s.matter.Ground(), Vec3(0), bob, Vec3(0), length);
    Force::Gravity(s.forces, s.matter, g * Vec3(UnitVec3(1, -1, 0)));
    State state = s.makeState();
    bob.setQToFitTranslation(state, length * Vec3(UnitVec3(1, -1, 0)));
    s.system.realize(state, Stage::Position);
    const LinearModel model = linearize(s.system, state);
    const Complex swing(0, std::sqrt(g / length));
    expectEigenvalues(calcEigenmodes(model), {swing, swing});

    const auto calcUDot = [&](double h) {
        State moved = model.state;
        moved.updQ()[0] += h;
        s.system.realize(moved, Stage::Acceleration);
        return Eigen::VectorXd::Constant(1, moved.getUDot()[0]);
    };
    EXPECT_NEAR(-differentiate(calcUDot, calcUDot(0)).value[0], g / length / 2, 1e-6);
}

TEST(Linearize, MotionsOfSimbodyAreNotPerturbed) {
    System s;
    MobilizedBody::Slider cart(s.matter.Ground(), makeBody(1));
    MobilizedBody::Pin arm(cart, Transform(), makeBody(2), Transform(Vec3(0, 0.5, 0)));
    Force::Gravity(s.forces, s.matter, Vec3(0, -9.81, 0));
    cart.lockByDefault(Motion::Position);
    const LinearModel model = linearize(s.system, s.makeState());
    EXPECT_EQ(model.numPositions, 1);
    expectEigenvalues(calcEigenmodes(model), {Complex(0, std::sqrt(2 * 9.81 * 0.5 / (1 + 2 * 0.25)))});
}

//---------------------------------------------------------------------------------------- steady motions
// Chaplygin's sleigh glides with its blade behind: a turn w dies away, b^2 dw/dt = -a v w. What remains is 0: place, heading
// and speed.
TEST(Linearize, AGlidingSleigh) {
    constexpr Real m = 3, J = 0.4, a = 0.25, v = 2;
    System s;
    MobilizedBody::Planar sleigh(s.matter.Ground(),
                                 Body::Rigid(MassProperties(m, Vec3(0), Inertia(1, 1, J))));
    const GeneralConstraint edge(Expression("VY(1,0,1)", {{1, Marker(sleigh, Vec3(-a, 0, 0))}}), "edge");
    State state = s.makeState();
    sleigh.setQ(state, Vec3(0.6, 1, 2));
    sleigh.setU(state, Vec3(0, v * std::cos(0.6), v * std::sin(0.6)));
    s.system.realize(state, Stage::Velocity);
    const LinearModel model = linearize(s.system, state);
    EXPECT_EQ(model.numPositions, 3);
    EXPECT_EQ(model.numSpeeds, 2);
    const Eigenmodes modes = calcEigenmodes(model);
    EXPECT_EQ(modes.numZero, 4);
    expectEigenvalues(modes, {-a * v / (J / m + a * a)});
}

//------------------------------------------------------------------------------------- auxiliary states
// dz/dt = -z/T + x, a force -k z: z is a state, beside one that nothing depends on.
class Lag : public Force::Custom::Implementation {
public:
    Lag(const GeneralForceSubsystem& forces, const MobilizedBody& body, Real gain, Real time)
        : m_forces(forces), m_body(body), m_gain(gain), m_time(time) {}
    void realizeTopology(State& state) const override { m_z = m_forces.allocateZ(state, Vector(1, Real(0))); }
    void calcForce(const State& state, Vector_<SpatialVec>&, Vector_<Vec3>&, Vector& f) const override {
        f[m_body.getFirstUIndex(state)] -= m_gain * m_forces.getZ(state)[m_z];
    }
    void realizeAcceleration(const State& state) const override {
        m_forces.updZDot(state)[m_z] = m_body.getOneQ(state, 0) - m_forces.getZ(state)[m_z] / m_time;
    }
    Real calcPotentialEnergy(const State&) const override { return 0; }

private:
    const GeneralForceSubsystem& m_forces;
    MobilizedBody m_body;
    Real m_gain, m_time;
    mutable ZIndex m_z;
};

TEST(Linearize, VariablesThatActOnTheMotionAreStates) {
    constexpr Real mass = 2, stiffness = 60, gain = 80, time = 0.4;
    System s;
    MobilizedBody::Slider body(s.matter.Ground(), makeBody(mass));
    Force::MobilityLinearSpring(s.forces, body, MobilizerQIndex(0), stiffness, 0);
    Force::Custom(s.forces, new Lag(s.forces, body, 0, 1));
    Force::Custom(s.forces, new Lag(s.forces, body, gain, time));
    const LinearModel model = linearize(s.system, s.makeState());
    EXPECT_EQ(model.z, std::vector<int>{1});
    ASSERT_EQ(model.getNumStates(), 3);
    for (const Eigenmode& mode : calcEigenmodes(model).modes) {
        const Complex v = mode.eigenvalue;
        EXPECT_LT(std::abs((mass * v * v + stiffness) * (v + 1 / time) + gain), 1e-6);
    }
}

//---------------------------------------------------------------------------------------------- errors
TEST(Linearize, AKinkIsInTheStatedError) {
    const auto f = [](double x) { return Eigen::VectorXd::Constant(1, x > 0 ? 3 * x : x); };
    const Derivative kink = differentiate(f, f(0));
    EXPECT_NEAR(kink.value[0], 2, 1e-9);
    EXPECT_NEAR(kink.error[0], 1, 1e-9);
    const auto smooth = [](double x) { return Eigen::VectorXd::Constant(1, std::exp(3 * x)); };
    const Derivative exact = differentiate(smooth, smooth(0));
    EXPECT_NEAR(exact.value[0], 3, 1e-10);
    EXPECT_LT(exact.error[0], 1e-8);
    const auto narrow = [](double x) { return Eigen::VectorXd::Constant(1, std::tanh(1e5 * x)); };
    EXPECT_NEAR(differentiate(narrow, narrow(0)).value[0] / 1e5, 1, 1e-4);
}

TEST(Linearize, RefusesAStateOffTheConstraints) {
    System s;
    MobilizedBody::Translation bob(s.matter.Ground(), makeBody(2));
    Constraint::Rod(s.matter.Ground(), Vec3(0), bob, Vec3(0), 1);
    State state = s.makeState();
    bob.setQToFitTranslation(state, Vec3(0, -0.9, 0));
    s.system.realize(state, Stage::Position);
    EXPECT_EQ(
        testing::catchError([&] { linearize(s.system, state); }),
        "linearize: the State does not satisfy the constraints: by 0.1, its speeds by 0 [sizes of the mechanism, "
        "rad, s]");
}

// Bars along each other: a parallelogram or an antiparallelogram from here.
TEST(Linearize, RefusesASingularPosition) {
    System s;
    const auto addPin = [](MobilizedBody parent, const Vec3& place, Real length) {
        return MobilizedBody::Pin(parent, Transform(place), makeBody(1), Transform(Vec3(-length, 0, 0)));
    };
    const MobilizedBody::Pin crank = addPin(s.matter.Ground(), Vec3(0), 1),
                             coupler = addPin(crank, Vec3(0), 2),
                             rocker = addPin(s.matter.Ground(), Vec3(2, 0, 0), 1);
    const AtPoint joint(Marker(coupler, Transform()), Marker(rocker, Transform()));
    EXPECT_EQ(
        testing::catchError([&] { linearize(s.system, s.makeState()); }),
        "linearize: the position is singular: 2 degrees of freedom here, 1 nearby, so that there is no tangent "
        "space; move the mechanism a little");
}

}  // namespace
}  // namespace jprim
