// SPDX-License-Identifier: Apache-2.0
// The equations of SCREW, RACKPIN and MOTIONs: the identities that every constraint must satisfy off its
// manifold.
#include <gtest/gtest.h>

#include <cmath>

#include "jprim/joint/joint.h"
#include "jprim/joint/motion.h"
#include "support/conformance.h"

namespace jprim {
namespace {

using testing::Conformance;
using testing::Tree;
using testing::expressions::DifferenceTolerance;
using testing::expressions::RoundingTolerance;

using MakeEquation = GeneralConstraint (*)(const Marker& I, const Marker& J);

template <Coordinate Q>
GeneralConstraint makeMotion(const Marker& I, const Marker& J) {
    return PrescribedMotion(I, J, Q, Expression("0.3*SIN(2*TIME)", {}));
}

struct Case {
    const char* name;
    MakeEquation make;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.name;
}

using M = const Marker&;
// Threads and teeth are so large that the nearest one stays the same all over the differences.
const Case Cases[] = {
    {"Screw", [](M I, M J) { return *Joint::Screw(I, J, 17, 0.2).getGeneralConstraint(); }},
    {"Rackpin", [](M I, M J) { return *Joint::Rackpin(I, J, -5, 0.1).getGeneralConstraint(); }},
    {"MotionX", makeMotion<Coordinate::X>},
    {"MotionZ", makeMotion<Coordinate::Z>},
    {"MotionRotation", makeMotion<Coordinate::Rotation>},
    {"MotionB1", makeMotion<Coordinate::B1>},
    {"MotionB2", makeMotion<Coordinate::B2>},
    {"MotionB3", makeMotion<Coordinate::B3>}};

class EquationConformance : public ::testing::TestWithParam<std::tuple<Case, Tree>> {};

TEST_P(EquationConformance, HoldsOffTheManifold) {
    const auto& [c, tree] = GetParam();
    const auto add = [make = c.make](M I, M J) -> SimTK::Constraint { return make(I, J); };
    for (int seed = 1; seed <= 5; ++seed) {
        SCOPED_TRACE(seed);
        const Conformance result = testing::measureConformance(add, tree, seed);
        EXPECT_LT(result.rateError, DifferenceTolerance);
        EXPECT_LT(result.accelerationError, DifferenceTolerance);
        EXPECT_LT(result.powerError, RoundingTolerance);
        EXPECT_LT(result.netLoad, RoundingTolerance);
        EXPECT_EQ(result.equations, 1);
    }
}

INSTANTIATE_TEST_SUITE_P(Joints, EquationConformance,
                         ::testing::Combine(::testing::ValuesIn(Cases),
                                            ::testing::Values(Tree::AncestorMoves, Tree::FlexibleBoth)),
                         [](const auto& info) {
                             return std::string(std::get<0>(info.param).name) +
                                    testing::getName(std::get<1>(info.param));
                         });

// What CONVEL holds at shafts b apart that are turned by a and c: (1 + cos b) sin(a + c), or opposed
// (1 - cos b) sin(a - c). Returns how far the equation is from one of the two.
double calcConvelDefect(bool opposed, bool expectOpposed) {
    const double a = 0.7, b = 0.9, c = -0.4;
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter(system);
    SimTK::MobilizedBody::Free body(
        matter.Ground(), SimTK::Body::Rigid(SimTK::MassProperties(1, SimTK::Vec3(0), SimTK::Inertia(1))));
    const SimTK::Rotation R_GJ(0.8, SimTK::UnitVec3(1, -2, 0.5));
    const Marker I(body), J(matter.updGround(), SimTK::Transform(R_GJ, SimTK::Vec3(0.2, 0.1, -0.3)));
    const Joint joint = Joint::Convel(I, J, opposed);
    SimTK::State state = system.realizeTopology();
    const SimTK::Rotation R_JI =
        SimTK::Rotation(SimTK::BodyRotationSequence, a, SimTK::ZAxis, b, SimTK::XAxis) *
        SimTK::Rotation(c, SimTK::ZAxis);
    body.setQToFitTransform(state, SimTK::Transform(R_GJ * R_JI, SimTK::Vec3(1, 2, 3)));
    system.realize(state, SimTK::Stage::Position);
    const double expected =
        expectOpposed ? (1 - std::cos(b)) * std::sin(a - c) : (1 + std::cos(b)) * std::sin(a + c);
    return std::abs(joint.getPairConstraint()->calcEquationError(state, 3) - expected);
}

TEST(EquationConformance, AConvelTurnsItsShaftsAlikeAndNotAgainstEachOther) {
    EXPECT_LT(calcConvelDefect(false, false), RoundingTolerance);
    EXPECT_LT(calcConvelDefect(true, true), RoundingTolerance);
    EXPECT_GT(calcConvelDefect(false, true), 0.1);
    EXPECT_GT(calcConvelDefect(true, false), 0.1);
}

// The suite can fail: DZ with the axes of ground in place of J's has a net moment.
TEST(EquationConformance, NoticesTheAxesOfTheWrongBody) {
    const auto add = [](M I, M J) -> SimTK::Constraint {
        return GeneralConstraint(Expression("DZ(1,2)-0.1*AZ(1,2)", {{1, I}, {2, J}}));
    };
    EXPECT_GT(testing::measureConformance(add, Tree::AncestorMoves, 1).netLoad, 1e-2);
}

}  // namespace
}  // namespace jprim
