// SPDX-License-Identifier: Apache-2.0
// Mechanisms of parts whose moments of inertia no body has: two routes to the same motion, and what such parts must
// not change: freedoms, kinematics, equilibria and reactions.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "jprim/simulation/equilibrium.h"
#include "support/random_dataset.h"
#include "support/random_part.h"
#include "support/run_dataset.h"
#include "support/two_routes.h"

namespace jprim {
namespace {

using SimTK::Mat33;
using SimTK::Rotation;
using SimTK::Vec3;
using testing::buildFromText;
using testing::buildOrFail;
using testing::formatAll;
using testing::makeInertia;
using testing::RandomPart;

constexpr double Tolerance = 1e-8;  // above the accuracies of 1e-9 and 1e-10 over a turn
constexpr Formulation Both[] = {Formulation::Tree, Formulation::Constraints};

//----------------------------------------------------------------------------------------- mechanisms
// The dataset with all velocities that its parts start with: what is left open, more parts may decide otherwise.
Dataset giveVelocities(Dataset dataset) {
    Diagnostics diagnostics;
    const std::optional<Mechanism> mechanism = buildMechanism(dataset, diagnostics);
    const SimTK::State state = assemble(*mechanism).state;
    mechanism->getSystem().realize(state, SimTK::Stage::Velocity);
    for (size_t k = 0; k < dataset.parts.size(); ++k) {
        const MechanismPart& part = mechanism->getParts()[k];
        if (part.ground) continue;
        const SimTK::SpatialVec V = part.body.getBodyVelocity(state);
        const Vec3 w = ~part.wm.findPoseInGround(state).R() * V[0],
                   v = ~part.vm.findPoseInGround(state).R() * V[1];
        for (int i = 0; i < 3; ++i) {
            dataset.parts[k].w[size_t(i)] = w[i];
            dataset.parts[k].v[size_t(i)] = v[i] / mechanism->getUnits().getVelocity();
        }
    }
    return dataset;
}

// Every part as two that are fixed to each other, with half of the mass each, and inertias that no body has and that
// add up to what it was: the same mechanism by another route.
Dataset splitParts(const Dataset& whole, RandomPart& r) {
    Dataset halves = whole;
    for (size_t k = 0; k < whole.parts.size(); ++k) {
        if (whole.parts[k].ground) continue;
        PartStatement half = whole.parts[k], other = half;
        half.mass = other.mass = *half.mass / 2;
        // Their differences are larger than any moment of the whole, in axes that are not those of the whole.
        const Mat33 change = makeInertia({r.draw(-1, 0), r.draw(0, 1), r.draw(0, 2)}, r.drawRotation());
        const double products[] = {change(0, 0),  change(1, 1),  change(2, 2),
                                   -change(0, 1), -change(0, 2), -change(1, 2)};
        for (size_t i = 0; i < 6; ++i) {
            (*other.ip)[i] = (*half.ip)[i] / 2 - products[i];
            (*half.ip)[i] = (*half.ip)[i] / 2 + products[i];
        }
        other.id += 1000;
        other.cm += 10000;
        halves.parts[k] = half;
        halves.parts.push_back(other);
        for (const MarkerStatement& marker : whole.markers)
            if (marker.id == half.cm) {
                halves.markers.push_back(marker);
                halves.markers.back().id = other.cm;
                halves.markers.back().part = other.id;
            }
        JointStatement fixed;
        fixed.id = other.id;
        fixed.type = JointType::Fixed;
        fixed.i = other.cm;
        fixed.j = half.cm;
        halves.joints.push_back(fixed);
    }
    return halves;
}

SimulationOutcome runDataset(const Dataset& dataset, Formulation formulation, const std::string& integrator,
                             double accuracy) {
    Diagnostics diagnostics;
    const std::optional<Mechanism> mechanism = buildMechanism(dataset, diagnostics, {formulation});
    if (!mechanism) throw std::runtime_error(formatAll(diagnostics));
    SimulationOptions options;
    options.end = 0.2;
    options.steps = 2;
    options.accuracy = accuracy;
    options.integrator = integrator;
    return simulate(*mechanism, assemble(*mechanism), options);
}

struct Differences {
    double motion = 0, reactions = 0;
};

Differences compareWithHalves(const std::string& text, unsigned seed, Formulation formulation,
                              const std::string& integrator = "RungeKuttaMerson", double accuracy = 1e-10,
                              double change = 0) {
    Diagnostics diagnostics;
    const Dataset whole = giveVelocities(readDataset(text, diagnostics));
    RandomPart random(seed);
    Dataset halves = splitParts(whole, random);
    (*halves.parts[1].ip)[0] += change;
    const SimulationOutcome a = runDataset(whole, formulation, integrator, accuracy),
                            b = runDataset(halves, formulation, integrator, accuracy);
    EXPECT_EQ(a.failure + b.failure, "") << seed << "\n" << text;
    EXPECT_EQ(a.summary.degreesOfFreedom, b.summary.degreesOfFreedom) << seed;
    EXPECT_EQ(a.summary.isKinematic, b.summary.isKinematic) << seed;
    using testing::findDifference;
    return {std::max(findDifference(a.results.parts, b.results.parts),
                     findDifference(a.results.requests, b.results.requests)),
            findDifference(a.results.reactions, b.results.reactions)};
}

constexpr double SameMotion = 1e-7, SameReactions = 1e-6;

TEST(BrokenInertia, HalvesThatNoBodyIsMoveAsTheWhole) {
    constexpr int Compared = 20;
    int compared = 0;
    for (unsigned seed = 1; compared < Compared && seed < 20 * Compared; ++seed) {
        const std::string text = testing::RandomDataset(seed).write(1 + int(seed) % 3, int(seed) % 2);
        if (!testing::isDetermined(text)) continue;
        ++compared;
        for (const Formulation formulation : Both) {
            const Differences differences = compareWithHalves(text, seed, formulation);
            EXPECT_LE(differences.motion, SameMotion) << seed << "\n" << text;
            EXPECT_LE(differences.reactions, SameReactions) << seed << "\n" << text;
        }
    }
    EXPECT_EQ(compared, Compared);
}

// Each of the hinges carries the same too, whatever share of the load it is given.
TEST(BrokenInertia, HalvesMoveAsTheWholeOnTwoHinges) {
    const std::string door =
        "door\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/1\nMARKER/2,QP=0,0,1.3\n"
        "PART/2,MASS=3,CM=20,IP=1,1.2,1.4,-0.2,0.3,-0.4,WZ=1\nMARKER/20,QP=0.4,0.1,0.3\nMARKER/21\n"
        "MARKER/22,QP=0,0,1.3\nJOINT/1,REVOLUTE,I=21,J=1\nJOINT/2,REVOLUTE,I=22,J=2\n"
        "SFORCE/1,ROTATIONAL,I=21,J=1,FUNCTION=1+0.3*TIME\nEND\n";
    for (const Formulation formulation : Both) {
        const Differences differences = compareWithHalves(door, 1, formulation);
        EXPECT_LE(differences.motion, SameMotion);
        EXPECT_LE(differences.reactions, SameReactions);
    }
}

// In the tree both have the same states and take the same steps, otherwise each has its own errors.
TEST(BrokenInertia, HalvesMoveAsTheWholeWithEveryIntegrator) {
    constexpr double Coarse = 1e-5;
    const std::string text = testing::RandomDataset(1).write(2, 0);
    for (const std::string& integrator : getIntegratorNames())
        for (const Formulation formulation : Both) {
            const bool isTree = formulation == Formulation::Tree;
            const Differences differences = compareWithHalves(text, 1, formulation, integrator, Coarse);
            EXPECT_LE(differences.motion, isTree ? SameMotion : Coarse) << integrator;
            EXPECT_LE(differences.reactions, isTree ? SameReactions : Coarse) << integrator;
        }
}

TEST(BrokenInertiaMutant, ATenThousandthOfAMomentIsNoticed) {
    const std::string text = testing::RandomDataset(1).write(2, 0);
    const Differences differences =
        compareWithHalves(text, 1, Formulation::Tree, "RungeKuttaMerson", 1e-10, 1e-4);
    EXPECT_GT(differences.motion, SameMotion);
}

//----------------------------------------------------------------------------- where it does not matter
// A slider crank in a plane: of the inertia of its parts only IZZ counts.
std::string makeSliderCrank(const std::string& crank, const std::string& rod, const std::string& slider) {
    return "crank\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/10\nMARKER/11,REULER=90D,90D,0\n"
           "PART/2,MASS=1.3,CM=20,WZ=3,REULER=0.7,0,0,IP=" +
           crank +
           "\nMARKER/20,QP=0.11,0.02,0\nMARKER/21\nMARKER/22,QP=0.31,0,0\n"
           "PART/3,MASS=0.7,CM=30,QG=0.237101078,0.199707482,0,REULER=-0.25,0,0,IP=" +
           rod +
           "\nMARKER/30,QP=0.4,-0.03,0\nMARKER/31\nMARKER/32,QP=0.83,0,0\n"
           "PART/4,MASS=0.9,CM=40,QG=1.04,0,0,IP=" +
           slider +
           "\nMARKER/40\nMARKER/41,REULER=90D,90D,0\n"
           "JOINT/1,REVOLUTE,I=21,J=10\nJOINT/2,REVOLUTE,I=31,J=22\nJOINT/3,REVOLUTE,I=40,J=32\n"
           "JOINT/4,TRANSLATIONAL,I=41,J=11\nEND\n";
}

TEST(BrokenInertia, OnlyMomentsAboutAxesOfTurnsCount) {
    const std::string sound = makeSliderCrank("0.1,0.11,0.2", "0.05,0.2,0.21", "1,1,1"),
                      broken = makeSliderCrank("-3,0.01,0.2,0.1,0,0", "-8,-3,0.21", "-1,2,-3");
    for (const Formulation formulation : Both) {
        Diagnostics diagnostics;
        ASSERT_TRUE(buildFromText(broken, diagnostics, {formulation})) << formatAll(diagnostics);
        EXPECT_EQ(diagnostics.size(), 3u) << formatAll(diagnostics);
        const SimulationOutcome a = testing::run(buildOrFail(sound, {formulation}), 1, 10, 1e-10),
                                b = testing::run(buildOrFail(broken, {formulation}), 1, 10, 1e-10);
        EXPECT_EQ(b.summary.degreesOfFreedom, 1);
        EXPECT_LE(testing::findDifference(a.results.parts, b.results.parts), SameMotion);
        for (const char* component : {"FX", "FY", "TZ"})
            for (int joint = 1; joint <= 4; ++joint) {
                const std::string column = fmt::format("JOINT/{}.I.{}", joint, component);
                EXPECT_NEAR(a.results.reactions.getColumn(column).back(),
                            b.results.reactions.getColumn(column).back(), 100 * SameReactions)
                    << column;
            }
    }
}

// A pendulum may have less than nothing about its mass centre, as long as it has something about its hinge.
TEST(BrokenInertia, ItIsTheMotionsThatMustHaveEnergy) {
    const auto makePendulum = [](const std::string& ip) {
        return "t\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=" + ip +
               "\nMARKER/20,QP=0.5,0,0\nMARKER/21\nJOINT/1,REVOLUTE,I=21,J=10\nREQUEST/1,F2=WDTZ(21)\nEND\n";
    };
    for (const Formulation formulation : Both) {
        const SimulationOutcome outcome =
            testing::run(buildOrFail(makePendulum("1,1,-0.3"), {formulation}), 0.1, 1, 1e-9);
        EXPECT_NEAR(outcome.results.requests.getColumn("R1.F2").front(), -2 * 9.81 * 0.5 / (0.5 - 0.3), 1e-6);
        for (const std::string moment : {"-0.5", "-0.6"}) {
            Diagnostics diagnostics;
            EXPECT_FALSE(buildFromText(makePendulum("1,1," + moment), diagnostics, {formulation}));
            EXPECT_EQ(
                formatAll(diagnostics),
                "5:1: error: PART/2 has a negative principal moment of inertia about the mass centre (" +
                    moment +
                    "), and the constraints allow a motion whose kinetic energy it makes negative or zero; "
                    "check MASS, IP, IM and CM\n");
        }
    }
}

// Of two parts only the one is named that is to blame.
TEST(BrokenInertia, TheRightPartIsToBlame) {
    for (const Formulation formulation : Both) {
        Diagnostics diagnostics;
        EXPECT_FALSE(
            buildFromText("t\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=1,CM=20,IP=-1,1,2\nMARKER/20\n"
                          "PART/3,MASS=1,CM=30,IP=-1,1,2\nMARKER/30\nJOINT/1,REVOLUTE,I=20,J=10\n"
                          "JOINT/2,SPHERICAL,I=30,J=20\nEND\n",
                          diagnostics, {formulation}));
        const std::string text = formatAll(diagnostics);
        EXPECT_NE(text.find("4:1: warning: PART/2 has a negative"), std::string::npos) << text;
        EXPECT_NE(text.find("6:1: error: PART/3 has a negative"), std::string::npos) << text;
    }
}

//--------------------------------------------------------------------------- kinematics and statics
// At a steady rate a part that is not balanced pulls at its hinge with the moment w x I w.
TEST(BrokenInertia, DrivenPartsAreKinematicAndTheirReactionsRight) {
    const Mat33 inertia(1, 0.2, -0.3, 0.2, 1.2, 0.4, -0.3, 0.4, 4);  // products are minus those of IP
    const Vec3 w(0, 0, 5), moment = SimTK::cross(w, inertia * w);
    for (const Formulation formulation : Both) {
        const SimulationOutcome outcome = testing::run(
            buildOrFail(
                "t\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=1,CM=20,IP=1,1.2,4,-0.2,0.3,-0.4\nMARKER/20\n"
                "JOINT/1,REVOLUTE,I=20,J=10\nMOTION/1,JOINT=1,FUNCTION=5*TIME\nEND\n",
                {formulation}),
            0.3, 1, 1e-9);
        EXPECT_TRUE(outcome.summary.isKinematic);
        EXPECT_EQ(outcome.summary.degreesOfFreedom, 0);
        const Vec3 inGround = Rotation(1.5, SimTK::ZAxis) * moment;
        const Table& reactions = outcome.results.reactions;
        EXPECT_NEAR(reactions.getColumn("JOINT/1.I.TX").back(), inGround[0], Tolerance);
        EXPECT_NEAR(reactions.getColumn("JOINT/1.I.TY").back(), inGround[1], Tolerance);
        EXPECT_NEAR(reactions.getColumn("MOTION/1.I.TZ").back(), inGround[2], Tolerance);
        EXPECT_NEAR(reactions.getColumn("JOINT/1.I.FX").back(), 0, Tolerance);
    }
}

TEST(BrokenInertia, HangsInEquilibriumBelowItsHinge) {
    for (const Formulation formulation : Both) {
        const Mechanism mechanism = buildOrFail(
            "t\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=0.1,0.1,9\n"
            "MARKER/20,QP=0.5,0.1,0\nMARKER/21\nJOINT/1,REVOLUTE,I=21,J=10\nEND\n",
            {formulation});
        const SimTK::State state = findEquilibrium(mechanism, assemble(mechanism).state);
        const Vec3 center = mechanism.getParts()[1].body.getBodyOriginLocation(state);
        EXPECT_NEAR(center[0], 0, Tolerance);
        EXPECT_NEAR(center[1], -std::hypot(0.5, 0.1), Tolerance);
    }
}

}  // namespace
}  // namespace jprim
