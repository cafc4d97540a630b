// SPDX-License-Identifier: Apache-2.0
// Assembly from far away. Simbody's own ConstantOrientation and pairs of ConstantAngle end turned by 180
// degrees in about every second case, because their dot products vanish there too.
#include <gtest/gtest.h>

#include "jprim/jprim.h"
#include "support/conformance.h"

namespace jprim {
namespace {

using SimTK::Body;
using SimTK::MobilizedBody;
using SimTK::Random;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

constexpr int NumStarts = 1000;
// The assembler stops at its own tolerance, by default accuracy/10 = 1e-4 rad.
constexpr double AssembledAngle = 1e-3;

// Two free bodies to be oriented against each other.
struct TwoBodies {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    Body::Rigid body{SimTK::MassProperties(1, Vec3(0), SimTK::Inertia(1, 2, 1.5))};
    MobilizedBody::Free first{matter.Ground(), body};
    MobilizedBody::Free second{matter.Ground(), body};
    Marker I{first, Transform(Rotation(0.3, Vec3(1, 2, 3)), Vec3(0.1, 0.2, 0.3))};
    Marker J{second, Transform(Rotation(1.2, Vec3(-1, 0, 2)), Vec3(0.5, 0, -0.3))};

    // The orientation of I in J after assembling from the given orientations of the bodies.
    Rotation assemble(State& state, const Rotation& R_1, const Rotation& R_2) {
        first.setQToFitTransform(state, Transform(R_1, Vec3(1, 0, 0)));
        second.setQToFitTransform(state, Transform(R_2, Vec3(0, 1, 0)));
        SimTK::Assembler(system).assemble(state);
        system.realize(state, Stage::Position);
        return ~J.findPoseInGround(state).R() * I.findPoseInGround(state).R();
    }
};

template <class Measure>
void assembleFromManyStarts(TwoBodies& model, Measure calcAngle) {
    State state = model.system.realizeTopology();
    Random::Uniform random(-1, 1);
    random.setSeed(20);
    int flipped = 0, failed = 0;
    for (int n = 0; n < NumStarts; ++n) {
        try {
            const Rotation R = model.assemble(state, testing::makeRandomRotation(random),
                                              testing::makeRandomRotation(random));
            const Real angle = calcAngle(R);
            if (angle > SimTK::Pi / 2)
                ++flipped;
            else if (angle > AssembledAngle)
                ++failed;
        } catch (const std::exception&) {
            ++failed;
        }
    }
    EXPECT_EQ(flipped, 0);
    EXPECT_EQ(failed, 0);
}

Real calcAngleOfRotation(const Rotation& R) {
    return std::abs(R.convertRotationToAngleAxis()[0]);
}
Real calcAngleOfZAxes(const Rotation& R) {
    return std::acos(std::min(Real(1), R.z()[2]));
}

TEST(Assembly, OrientationNeverFlips) {
    TwoBodies model;
    Orientation(model.I, model.J, "JPRIM/1");
    assembleFromManyStarts(model, calcAngleOfRotation);
}

TEST(Assembly, ParallelAxesNeverFlips) {
    TwoBodies model;
    ParallelAxes(model.I, model.J, "JPRIM/1");
    assembleFromManyStarts(model, calcAngleOfZAxes);
}

// The experiment can fail: with Simbody's dot products many end flipped.
TEST(Assembly, BuiltInConstraintDoesFlip) {
    TwoBodies model;
    SimTK::Constraint::ConstantOrientation(model.second, model.J.getPose().R(), model.first,
                                           model.I.getPose().R());
    State state = model.system.realizeTopology();
    Random::Uniform random(-1, 1);
    random.setSeed(20);
    int flipped = 0;
    for (int n = 0; n < 50; ++n) {
        try {
            const Rotation R = model.assemble(state, testing::makeRandomRotation(random),
                                              testing::makeRandomRotation(random));
            if (calcAngleOfRotation(R) > SimTK::Pi / 2) ++flipped;
        } catch (const std::exception&) {
        }
    }
    EXPECT_GT(flipped, 5);
}

//---------------------------------------------------------------------- exactly 180 degrees apart
// A turn by 180 degrees about each axis, and about a skew one, as the start of I in J.
class ExactlyFlipped : public ::testing::TestWithParam<int> {
protected:
    static Rotation makeHalfTurn() {
        const Vec3 axes[] = {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, -2, 0)};
        return Rotation(SimTK::Pi, SimTK::UnitVec3(axes[GetParam()]));
    }
};

template <class Type>
void expectFiniteAtHalfTurn(const Rotation& halfTurn) {
    TwoBodies model;
    model.I = Marker(model.first);
    model.J = Marker(model.second);
    const Type primitive(model.I, model.J);
    State state = model.system.realizeTopology();
    model.first.setQToFitTransform(state, Transform(halfTurn, Vec3(0.3, 0.2, 0.1)));
    for (int u = 0; u < state.getNU(); ++u) state.updU()[u] = 0.3 - 0.1 * u;
    model.system.realize(state, Stage::Acceleration);
    EXPECT_TRUE(std::isfinite(state.getQErr().norm()));
    EXPECT_TRUE(std::isfinite(state.getUErr().norm()));
    EXPECT_TRUE(std::isfinite(state.getUDotErr().norm()));
    EXPECT_TRUE(std::isfinite(state.getUDot().norm()));
    EXPECT_TRUE(primitive.calcReactionOnI(state).isFinite());
}

TEST_P(ExactlyFlipped, OrientationHasNoNaN) {
    expectFiniteAtHalfTurn<Orientation>(makeHalfTurn());
}
TEST_P(ExactlyFlipped, ParallelAxesHasNoNaN) {
    expectFiniteAtHalfTurn<ParallelAxes>(makeHalfTurn());
}

TEST_P(ExactlyFlipped, SizeOfTheErrorIsTwo) {
    TwoBodies model;
    const Orientation orientation{Marker(model.first), Marker(model.second)};
    State state = model.system.realizeTopology();
    model.first.setQToFitTransform(state, Transform(makeHalfTurn()));
    model.system.realize(state, Stage::Position);
    EXPECT_NEAR(orientation.getPositionErrorsAsVector(state).norm(), 2, 1e-12);
}

TEST_P(ExactlyFlipped, ParallelAxesAssembles) {
    TwoBodies model;
    model.I = Marker(model.first);
    model.J = Marker(model.second);
    ParallelAxes(model.I, model.J);
    State state = model.system.realizeTopology();
    EXPECT_LT(calcAngleOfZAxes(model.assemble(state, makeHalfTurn(), Rotation())), AssembledAngle);
}

std::string getAxisName(const ::testing::TestParamInfo<int>& info) {
    const char* const names[] = {"AboutX", "AboutY", "AboutZ", "AboutSkewAxis"};
    return names[info.param];
}

INSTANTIATE_TEST_SUITE_P(HalfTurns, ExactlyFlipped, ::testing::Range(0, 4), getAxisName);

}  // namespace
}  // namespace jprim
