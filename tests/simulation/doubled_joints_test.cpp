// SPDX-License-Identifier: Apache-2.0
// Two hinges on one axis, three sliders side by side: joints that say what others say already. Whatever becomes of
// their equations, the mechanism moves as if each joint were there once, and the doubles together carry what the
// single one does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "base/format.h"
#include "jprim/marker/angles.h"
#include "jprim/simulation/equilibrium.h"
#include "support/random_dataset.h"
#include "support/run_dataset.h"
#include "support/two_routes.h"

namespace jprim {
namespace {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;
using testing::DoubledDataset;

constexpr Real SameMotion = 1e-7, SameLoad = 1e-6;  // of the largest velocity or coordinate, and load

struct Way {
    const char* name;
    Formulation formulation;
    Redundancy redundancy;
};
const Way Ways[] = {{"share, tree", Formulation::Tree, Redundancy::Share},
                    {"drop, tree", Formulation::Tree, Redundancy::Drop},
                    {"share, constraints", Formulation::Constraints, Redundancy::Share},
                    {"drop, constraints", Formulation::Constraints, Redundancy::Drop}};

/// A mechanism at the end of a run.
struct Outcome {
    std::string failure;
    std::vector<SpatialVec> poses, velocities;  // of the parts: [angles of rotation, origin], [w, v]
    std::map<std::string, SpatialVec> loads;    // on I of each joint, about Ground's origin
};

Outcome runFor(const std::string& text, const Way& way, double end) {
    const Mechanism mechanism = testing::buildOrFail(text, {way.formulation});
    SimulationOptions options;
    options.end = end;
    options.steps = 2;
    options.accuracy = 1e-10;
    options.redundancy = way.redundancy;
    Outcome outcome;
    const SimulationOutcome run = simulate(mechanism, assemble(mechanism), options);
    mechanism.getSystem().realize(run.finalState, SimTK::Stage::Velocity);
    outcome.failure = run.failure;
    for (const MechanismPart& part : mechanism.getParts()) {
        const SimTK::Transform X = part.cm.findPoseInGround(run.finalState);
        const Vec3 turned = X.R() * Vec3(0.6, -0.5, 0.7);
        outcome.poses.push_back({turned, X.p()});
        outcome.velocities.push_back(part.cm.findVelocityInGround(run.finalState));
    }
    const auto last = [&](const std::string& column) {
        return run.results.reactions.getColumn(column).back();
    };
    for (const Element& joint : mechanism.getElements()) {
        if (joint.type.empty()) continue;
        const auto get = [&](char kind) {
            const std::string prefix = joint.getName() + ".I." + kind;
            return Vec3(last(prefix + "X"), last(prefix + "Y"), last(prefix + "Z"));
        };
        const Vec3 F = get('F'), at = mechanism.getMarker(joint.i).findPoseInGround(run.finalState).p();
        outcome.loads[joint.getName()] = {get('T') + at % F, F};
    }
    return outcome;
}

Real calcDifference(const std::vector<SpatialVec>& a, const std::vector<SpatialVec>& b) {
    Real largest = 1, difference = 0;
    for (size_t k = 0; k < a.size(); ++k) {
        largest = std::max(largest, a[k].norm());
        difference = std::max(difference, (a[k] - b[k]).norm());
    }
    return difference / largest;
}

// The largest difference between a joint's load and that of all that are in its place.
Real calcLoadDifference(const Outcome& single, const Outcome& doubled, const DoubledDataset& dataset) {
    Real largest = 1, difference = 0;
    for (const auto& [name, load] : single.loads) {
        SpatialVec sum = doubled.loads.at(name);
        const auto doubles = dataset.doubles.find(std::stoi(name.substr(name.find('/') + 1)));
        if (name[1] == 'O' && doubles != dataset.doubles.end())
            for (const int id : doubles->second) sum += doubled.loads.at(fmt::format("JOINT/{}", id));
        largest = std::max(largest, load.norm());
        difference = std::max(difference, (sum - load).norm());
    }
    return difference / largest;
}

class RandomDoubles : public ::testing::TestWithParam<int> {};

TEST_P(RandomDoubles, MoveAndCarryAsSingleOnes) {
    constexpr int PerGroup = 25;
    constexpr double End = 0.05;  // s: long enough to move by a tenth of a radian
    int compared = 0;
    for (int k = 0; compared < PerGroup && k < 20 * PerGroup; ++k) {
        const unsigned seed = unsigned(1000 * GetParam() + k);
        const DoubledDataset dataset = testing::RandomDataset(seed).writeDoubled(1 + k % 4, k % 3);
        if (dataset.doubles.empty() || !testing::isDetermined(dataset.single)) continue;
        ++compared;
        const Outcome single = runFor(dataset.single, Ways[0], End);
        for (const Way& way : Ways) {
            const Outcome doubled = runFor(dataset.doubled, way, End);
            ASSERT_EQ(doubled.failure, "") << seed << " " << way.name << "\n" << dataset.doubled;
            EXPECT_LE(calcDifference(single.poses, doubled.poses), SameMotion);
            EXPECT_LE(calcDifference(single.velocities, doubled.velocities), SameMotion);
            EXPECT_LE(calcLoadDifference(single, doubled, dataset), SameLoad);
            ASSERT_FALSE(HasFailure()) << seed << " " << way.name << "\n" << dataset.doubled;
        }
    }
    EXPECT_EQ(compared, PerGroup);
}

// The dataset with positions and angles rounded to a number of decimals.
std::string roundPlaces(const std::string& dataset, int decimals) {
    static const std::regex Places("(QP|QG|REULER)=([-+.0-9eE]+),([-+.0-9eE]+),([-+.0-9eE]+)");
    std::string rounded;
    auto rest = dataset.begin();
    for (std::sregex_iterator match(dataset.begin(), dataset.end(), Places), end; match != end; ++match) {
        rounded.append(rest, dataset.begin() + match->position());
        rounded += match->str(1) + '=';
        for (int k = 2; k < 5; ++k)
            rounded += fmt::format("{:.{}f}{}", std::stod(match->str(k)), decimals, k < 4 ? "," : "");
        rest = dataset.begin() + match->position() + match->length();
    }
    return rounded.append(rest, dataset.end());
}

// Doubles contradict each other by what was rounded, and mean the same.
TEST_P(RandomDoubles, MoveAsSingleOnesWhereNumbersAreRounded) {
    constexpr int PerGroup = 4;
    constexpr double End = 0.05, Amplified = 1000;  // s; by assembly, levers and the motion
    int compared = 0;
    for (int k = 0; compared < PerGroup && k < 20 * PerGroup; ++k) {
        const unsigned seed = unsigned(1000 * GetParam() + 500 + k);
        const DoubledDataset dataset = testing::RandomDataset(seed).writeDoubled(1 + k % 4, k % 3);
        if (dataset.doubles.empty() || !testing::isDetermined(dataset.single)) continue;
        const int decimals = 5 + compared++ % 5;
        const Outcome single = runFor(roundPlaces(dataset.single, decimals), Ways[0], End);
        const std::string text = roundPlaces(dataset.doubled, decimals);
        for (const Way& way : Ways) {
            const Outcome doubled = runFor(text, way, End);
            const Real same = Amplified * std::pow(0.1, decimals);
            ASSERT_EQ(doubled.failure, "") << seed << " " << way.name << "\n" << text;
            EXPECT_LE(calcDifference(single.poses, doubled.poses), same);
            EXPECT_LE(calcDifference(single.velocities, doubled.velocities), same);
            ASSERT_FALSE(HasFailure()) << seed << " " << way.name << "\n" << text;
        }
    }
    EXPECT_EQ(compared, PerGroup);
}

// A spring from each mass centre to ground.
std::string addSprings(const std::string& dataset) {
    std::string springs;
    int id = 0;
    for (size_t at = dataset.find("CM="); at != std::string::npos; at = dataset.find("CM=", at + 1)) {
        ++id;
        springs += fmt::format(
            "MARKER/9{0},PART=1,QP=0.3,-0.2,0.1\n"
            "SPRINGDAMPER/{0},TRANSLATION,I={1},J=9{0},K=30,LENGTH=0.4\n",
            1000 + id, std::stoi(dataset.substr(at + 3)));
    }
    std::string text = dataset;
    return text.insert(text.rfind("END"), springs);
}

std::vector<Vec3> findCentersAtRest(const std::string& text) {
    const Mechanism mechanism = testing::buildOrFail(text, {Formulation::Constraints});
    const State rest = findEquilibrium(mechanism, assemble(mechanism).state);
    std::vector<Vec3> centers;
    for (const MechanismPart& part : mechanism.getParts())
        centers.push_back(part.cm.findPoseInGround(rest).p());
    return centers;
}

// With dependent equations the loads that hold the rest are not unique, and must not be found by dividing by what
// rounding leaves: the same search goes the same way.
TEST(DoubledJoints, ComeToRestWhereSingleOnesDo) {
    constexpr int Compared = 10;
    constexpr Real SameRest = 1e-6;  // of balanced forces, and of ways that are rounded differently
    int compared = 0;
    for (unsigned seed = 1; compared < Compared && seed < 100; ++seed) {
        const DoubledDataset dataset = testing::RandomDataset(seed).writeDoubled(3, 0);
        if (dataset.doubles.empty() || dataset.single.find("MOTION") != std::string::npos) continue;
        ++compared;
        const std::vector<Vec3> single = findCentersAtRest(addSprings(dataset.single)),
                                doubled = findCentersAtRest(addSprings(dataset.doubled));
        for (size_t k = 0; k < single.size(); ++k)
            EXPECT_LE((single[k] - doubled[k]).norm(), SameRest) << seed;
    }
    EXPECT_EQ(compared, Compared);
}

//------------------------------------------------------------------------------------ a lid on two hinges
struct Hinges {
    const char* name;
    const char* turn;    // REULER of all markers of the hinges
    const char* second;  // where the second hinge is, on the axis through the origin
    bool isDoubled;
};

std::string writeLid(const Hinges& hinges) {
    return fmt::format(
        "lid\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/1,REULER={0}\nMARKER/2,QP={1},REULER={0}\n"
        "PART/2,MASS=10,CM=20,IP=1,2,3\nMARKER/20,QP=0.3,-0.2,0.5\nMARKER/21,REULER={0}\n"
        "MARKER/22,QP={1},REULER={0}\nJOINT/1,REVOLUTE,I=21,J=1\n{2}REQUEST/1,F2=AZ(21,1)\nEND\n",
        hinges.turn, hinges.second, hinges.isDoubled ? "JOINT/2,REVOLUTE,I=22,J=2\n" : "");
}

class Lids : public ::testing::TestWithParam<Hinges> {};

// With y = m g and r from the axis, I a'' = m g r sin(...): 2.354823 rad after 1 s and 1.190290 rad at rest, the angle
// between the mass centre's given place and straight down, atan2(0.5, 0.2).
TEST_P(Lids, FallAndComeToRestAsOnOneHinge) {
    constexpr double Printed = 1e-6;  // the digits of the figures
    const Mechanism mechanism = testing::buildOrFail(writeLid(GetParam()));
    const SimulationOutcome outcome = testing::run(mechanism, 1, 10, 1e-9);
    EXPECT_NEAR(outcome.results.requests.getColumn("R1.F2").back(), 2.354823, Printed);
    const State rest = findEquilibrium(mechanism, assemble(mechanism).state);
    EXPECT_NEAR(mechanism.getRequests()[0].functions[0].second.calcValue(rest), std::atan2(0.5, 0.2),
                Printed);
}

INSTANTIATE_TEST_SUITE_P(Hinges, Lids,
                         ::testing::Values(Hinges{"One", "90D,90D,0D", "1,0,0", false},
                                           Hinges{"Two", "90D,90D,0D", "1,0,0", true},
                                           Hinges{"FarApart", "90D,90D,0D", "123.4567,0,0", true},
                                           Hinges{"NextToEachOther", "90D,90D,0D", "1E-3,0,0", true}),
                         [](const auto& info) { return info.param.name; });

INSTANTIATE_TEST_SUITE_P(Groups, RandomDoubles, ::testing::Range(0, 20));

}  // namespace
}  // namespace jprim
