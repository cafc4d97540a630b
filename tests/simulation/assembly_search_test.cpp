// SPDX-License-Identifier: Apache-2.0
// Positions that have to be found: more equations than coordinates, long chains, coordinates that contradict.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "jprim/simulation/assemble.h"
#include "support/expect_error.h"
#include "support/random_chain.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::Real;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::Vec3;
using testing::buildOrFail;
using testing::RandomChain;

constexpr double Same = 1e-9;     // lengths and angles of what is found by one search in both formulations
constexpr double Met = 1e-8;      // of what the constraints determine
constexpr double Nearest = 1e-5;  // how well the nearest position is found [sizes of a part]
const Formulation Formulations[] = {Formulation::Tree, Formulation::Constraints};

Transform getPose(const Mechanism& mechanism, const AssembledState& assembled, size_t part) {
    return mechanism.getParts()[part].bcs.findPoseInGround(assembled.state);
}

Real calcDistance(const Transform& a, const Transform& b) {
    return std::max((a.p() - b.p()).norm(), (a.R().asMat33() - b.R().asMat33()).norm());
}

// The largest distance between the parts' poses as assembled from two datasets.
Real compare(const std::string& text, const std::string& other, Formulation ofOther) {
    const Mechanism a = buildOrFail(text, {Formulation::Tree}), b = buildOrFail(other, {ofOther});
    const AssembledState inA = assemble(a), inB = assemble(b);
    Real largest = 0;
    for (size_t k = 0; k < a.getParts().size(); ++k)
        largest = std::max(largest, calcDistance(getPose(a, inA, k), getPose(b, inB, k)));
    return largest;
}

//------------------------------------------------------------------- more equations than coordinates
std::string write(const Vec3& v) {
    return fmt::format("{:.17g},{:.17g},{:.17g}", v[0], v[1], v[2]);
}

// A door 2 m high on two hinges on a tilted axis through the origin.
std::string makeDoor(const Vec3& axes, const std::string& argumentsOfHinge, const std::string& partArguments,
                     const std::string& statements) {
    const Rotation R = makeRotation313(axes);
    return fmt::format(
        "door\nPART/1,GROUND\nMARKER/1,REULER={0}\nMARKER/2,QP={1},REULER={0}\n"
        "PART/2,MASS=10,CM=20,IP=1,1,1{2}\nMARKER/20,QP={3}\nMARKER/21,REULER={0}\nMARKER/22,QP={1},REULER={0}\n"
        "JOINT/1,REVOLUTE,I=21,J=1{4}\nJOINT/2,REVOLUTE,I=22,J=2\n{5}END\n",
        write(axes), write(R * Vec3(0, 0, 2)), partArguments, write(R * Vec3(0.5, 0, 1)), argumentsOfHinge,
        statements);
}

const std::vector<Vec3> DoorAxes = {Vec3(0), Vec3(SimTK::Pi / 2, SimTK::Pi / 2, 0), Vec3(0.31, 1.27, -0.83)};

void expectDoorAt(Real angle, const std::string& text, const Vec3& axes) {
    const Rotation R = makeRotation313(axes);
    for (const Formulation formulation : Formulations) {
        const Mechanism mechanism = buildOrFail(text, {formulation});
        const Transform expected(R * Rotation(angle, SimTK::ZAxis) * ~R, Vec3(0));
        EXPECT_LT(calcDistance(getPose(mechanism, assemble(mechanism), 1), expected), Met) << text;
    }
}

TEST(AssemblySearch, ADoorOnTwoHinges) {
    for (const Vec3& axes : DoorAxes) {
        const Real angle = SimTK::Pi / 6;
        expectDoorAt(angle, makeDoor(axes, "", "", "MOTION/1,JOINT=1,FUNCTION=30D\n"), axes);
        expectDoorAt(angle, makeDoor(axes, ",IC=30D", "", ""), axes);
        expectDoorAt(angle, makeDoor(axes, ",IC=30D", ",QG=0.1,0,0", ""), axes);
        // Hanging free it is put back where its hinges are; along its width and height that takes no turn.
        const Vec3 away = makeRotation313(axes) * Vec3(0.1, 0, 0.05);
        expectDoorAt(0, makeDoor(axes, "", ",QG=" + write(away), ""), axes);
    }
}

// A turn that the hinges allow is kept.
TEST(AssemblySearch, ADoorKeepsTheTurnItIsGiven) {
    expectDoorAt(0.4, makeDoor(Vec3(0), "", ",REULER=0.4,0,0,QG=0,0,0.03", ""), Vec3(0));
}

//---------------------------------------------------------------------------------- chains and loops
class Chains : public ::testing::TestWithParam<int> {};

TEST_P(Chains, BothFormulationsAssembleAlikeAndNearby) {
    constexpr double Nearby = 3;  // [sizes]; the largest in all is below 1.5
    for (const bool planar : {false, true})
        for (const bool curled : {false, true}) {
            RandomChain chain{GetParam(), planar, curled};
            chain.seed = unsigned(GetParam());
            const std::string text = chain.write();
            EXPECT_LT(compare(text, text, Formulation::Constraints), Same) << text;
            const Mechanism mechanism = buildOrFail(text);
            const AssembledState assembled = assemble(mechanism);
            EXPECT_LT(std::max(assembled.after.length, assembled.after.angle), AssemblyTolerance);
            for (size_t k = 0; k < assembled.moved.size(); ++k)
                EXPECT_LT(assembled.moved[k].distance, Nearby * mechanism.getParts()[k + 1].size) << text;
        }
}

INSTANTIATE_TEST_SUITE_P(OfLinks, Chains, ::testing::Values(3, 4, 5, 6, 8, 12, 19));

// An arc of links between two fixed points, hung up by ATPOINTs, whose last end is out of place in the plane y = 0.
std::string makeArc(int links, double length, double away) {
    std::string text = "arc\nPART/1,GROUND\nMARKER/1\n";
    Vec3 p(0);
    for (int k = 0; k < links; ++k) {
        const Real slope = 0.8 * (1 - 2 * (k + 0.5) / links);
        const int id = 100 * (k + 2);
        text += fmt::format(
            "PART/{},MASS=0.2,CM={},IP=10,30,30,QG={:.17g},0,{:.17g},REULER={:.17g},{:.17g},{:.17g}\n", k + 2,
            id + 3, p[0], p[2], SimTK::Pi / 2, slope, -SimTK::Pi / 2);
        text += fmt::format("MARKER/{}\nMARKER/{},QP={},0,0\nMARKER/{},QP={},0,0\n", id + 1, id + 2, length,
                            id + 3, length / 2);
        text += fmt::format("JPRIM/{},ATPOINT,I={},J={}\n", k + 1, id + 1, k == 0 ? 1 : id - 98);
        p += length * Vec3(std::cos(slope), 0, -std::sin(slope));
    }
    return text + fmt::format("MARKER/2,PART=1,QP={:.17g},0,{:.17g}\nJPRIM/999,ATPOINT,I={},J=2\nEND\n",
                              p[0] + away, p[2], 100 * (links + 1) + 2);
}

TEST(AssemblySearchMutated, AnEndSlightlyElsewhereIsNoticed) {
    const Real difference =
        compare(makeArc(5, 37.7, 5), makeArc(5, 37.7, 5 + 1e-4), Formulation::Constraints);
    EXPECT_GT(difference, 1e4 * Same);
}

TEST(AssemblySearch, ArcsStayInTheirPlane) {
    constexpr double InPlane = 1e-9;
    for (const int links : {5, 6, 8, 12, 30})
        for (const double away : {-5., 5.}) {
            const std::string text = makeArc(links, 37.7, away);
            EXPECT_LT(compare(text, text, Formulation::Constraints), 1e3 * Same) << links;
            const Mechanism mechanism = buildOrFail(text);
            const AssembledState assembled = assemble(mechanism);
            for (size_t k = 1; k < mechanism.getParts().size(); ++k) {
                const Transform X = getPose(mechanism, assembled, k);
                EXPECT_LT(std::abs(X.p()[1]), InPlane) << links;
                EXPECT_LT((X.p() - mechanism.getParts()[k].givenPose.p()).norm(), 2.5 * std::abs(away))
                    << links;
            }
        }
}

// A rod on a ball, given shifted and turned, is where no further turn brings it nearer.
TEST(AssemblySearch, OfAllPositionsTheNearest) {
    const Mechanism mechanism = buildOrFail(
        "t\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=1,CM=20,IP=1,1,1,QG=0.1,0.2,-0.3,REULER=0.2,0,0\nMARKER/20\n"
        "MARKER/21,QP=1,0,0\nJPRIM/1,ATPOINT,I=21,J=10\nEND\n");
    const AssembledState assembled = assemble(mechanism);
    const MechanismPart& part = mechanism.getParts()[1];
    const Transform given = part.calcGivenBodyPose();
    const auto calcGoal = [&](const Rotation& R) {
        const Rotation turned = R * part.body.getBodyRotation(assembled.state);
        const Vec3 p = -(turned * Vec3(1, 0, 0));
        const Real sine = std::sin((~given.R() * turned).convertRotationToAngleAxis()[0] / 2);
        return (p - given.p()).normSqr() / SimTK::square(part.size) + 4 * sine * sine;
    };
    for (int k = 0; k < 3; ++k) {
        const SimTK::CoordinateAxis axis(k);
        constexpr Real h = 1e-3;
        const Real up = calcGoal(Rotation(h, axis)), down = calcGoal(Rotation(-h, axis)),
                   here = calcGoal(Rotation());
        EXPECT_LT(std::abs(up - down) / (2 * h), Nearest) << k;
        EXPECT_GT(up + down - 2 * here, 0);
    }
}

//------------------------------------------------------------------------------------------- EXACT
std::string makeArm(const std::string& exact, const std::string& statements) {
    return "arm\nPART/1,GROUND\nMARKER/1\nPART/2,MASS=4,CM=20,IP=1,1,1,EXACT=" + exact +
           "\nMARKER/20,QP=0.7,0,0\nMARKER/21\n" + statements + "END\n";
}

TEST(ExactCoordinates, YieldToAMotion) {
    for (const Formulation formulation : Formulations) {
        const Mechanism mechanism =
            buildOrFail(makeArm("X:Y:Z:PSI", "JOINT/1,REVOLUTE,I=21,J=1\nMOTION/1,JOINT=1,FUNCTION=30D\n"),
                        {formulation});
        const AssembledState assembled = assemble(mechanism);
        EXPECT_LT(calcDistance(getPose(mechanism, assembled, 1), Rotation(SimTK::Pi / 6, SimTK::ZAxis)), Met);
        ASSERT_EQ(assembled.yielded.size(), 1u);
        EXPECT_EQ(assembled.yielded[0].element, "PART/2");
        EXPECT_EQ(assembled.yielded[0].coordinate, "EXACT PSI");
        EXPECT_NEAR(assembled.yielded[0].amount, SimTK::Pi / 6, Met);
        EXPECT_EQ(formatAmount(assembled.yielded[0], mechanism.getUnits()), "0.524 rad");
    }
}

TEST(ExactCoordinates, ThatFitDoNotYield) {
    const Mechanism mechanism =
        buildOrFail(makeArm("X:Y:Z:THETA", "JOINT/1,REVOLUTE,I=21,J=1\nMOTION/1,JOINT=1,FUNCTION=30D\n"));
    EXPECT_TRUE(assemble(mechanism).yielded.empty());
}

// Numbers with few digits: the hinge is 0.1 mm from where EXACT has the part.
TEST(ExactCoordinates, WithFewDigitsYieldToTheJoints) {
    const std::string text = "JOINT/1,REVOLUTE,I=22,J=1\nMARKER/22,PART=2,QP=1e-4,0,0\n";
    const AssembledState assembled = assemble(buildOrFail(makeArm("X:Y:Z:PSI:THETA:PHI", text)));
    ASSERT_EQ(assembled.yielded.size(), 1u);
    EXPECT_EQ(assembled.yielded[0].coordinate, "EXACT X");
    EXPECT_NEAR(assembled.yielded[0].amount, 1e-4, Met);
}

// A four-bar that fits, its crank EXACT in all six coordinates, the others given out of place.
TEST(ExactCoordinates, OfACrankLeaveTheRestToBeAssembled) {
    const Real a = 0.6457718232379019;
    for (const Formulation formulation : Formulations) {
        const Mechanism mechanism = buildOrFail(
            fmt::format(
                "fb\nPART/1,GROUND\nMARKER/1\nMARKER/2,QP=139,0,0\n"
                "PART/2,MASS=1,CM=23,IP=1,100,100,REULER={},0,0,EXACT=X:Y:Z:PSI:THETA:PHI\nMARKER/21\n"
                "MARKER/22,QP=47,0,0\nMARKER/23,QP=23.5,0,0\n"
                "PART/3,MASS=2,CM=33,IP=1,500,500,QG=38,28,0,REULER=0.7,0,0\nMARKER/31\n"
                "MARKER/32,QP=151,0,0\nMARKER/33,QP=75.5,0,0\n"
                "PART/4,MASS=2,CM=43,IP=1,500,500,QG=139,-1,0,REULER=1.1,0,0\nMARKER/41\n"
                "MARKER/42,QP=113,0,0\nMARKER/43,QP=56.5,0,0\n"
                "JOINT/1,REVOLUTE,I=21,J=1\nJOINT/2,REVOLUTE,I=31,J=22\nJOINT/3,REVOLUTE,I=42,J=32\n"
                "JOINT/4,REVOLUTE,I=41,J=2\nEND\n",
                a),
            {formulation});
        const AssembledState assembled = assemble(mechanism);
        EXPECT_TRUE(assembled.yielded.empty());
        EXPECT_LT(assembled.after.length, AssemblyTolerance);
        EXPECT_LT(calcDistance(getPose(mechanism, assembled, 1), Rotation(a, SimTK::ZAxis)), Met);
    }
}

// What stands against the joints is an error that names it.
TEST(ExactCoordinates, AgainstTheJointsAreAnError) {
    const std::string text = makeArm("X:Y:Z", "JOINT/1,REVOLUTE,I=22,J=1\nMARKER/22,PART=2,QP=0,0,0.25\n");
    for (const Formulation formulation : Formulations) {
        const std::string error = testing::catchError([&] { assemble(buildOrFail(text, {formulation})); });
        for (const char* words :
             {"JOINT/1: the parts cannot be assembled from their given positions; an error of 0.25 "
              "length units of the dataset and ",
              " rad is left, with the EXACT coordinates of PART/2 held; the nearest "
              "without EXACT has Z of PART/2 elsewhere by 0.25 length units"})
            EXPECT_NE(error.find(words), std::string::npos) << error;
    }
}

}  // namespace
}  // namespace jprim
