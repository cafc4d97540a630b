// SPDX-License-Identifier: Apache-2.0
// Agreement with Adams/Solver's own results. Source of the figures: Project Chrono, data/testing/joints,
// computed with Adams by its authors; the datasets are our own wording with the same parameters, each case
// once with JOINT and once spelled in JPRIMs.
#include <gtest/gtest.h>

#include <cmath>

#include "support/adams_reference.h"

namespace jprim {
namespace {

using testing::calcRms;
using testing::findPeak;
using testing::findSize;
using testing::getVectors;
using testing::readReference;
using testing::sumVectors;
using testing::Vectors;

// Tight enough for our own error to be far below Adams' (see ClosedForm below).
constexpr double Accuracy = 1e-8;

struct Case {
    const char* name;
    std::vector<std::string> jprims;  // the connections that together are JOINT/1
    // Required RMS relative to the motion's size and to the peak load, or in m, N and N m where Adams' own
    // error, found against closed forms, is larger.
    double position = 1e-5, load = 1e-4;
    double positionFloor = 0, forceFloor = 0, torqueFloor = 1e-12;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.name;
}

// In free fall along the joint (Cylindrical_Case01, Prismatic_Case01) all loads are zero: the floors of 1e-12
// then say that ours must be, too.
const Case Cases[] = {{"Revolute_Case01", {"JPRIM/1", "JPRIM/2"}},
                      {"Spherical_Case02", {"JPRIM/1"}},
                      {"Cylindrical_Case01", {"JPRIM/1", "JPRIM/2"}, 1e-5, 1e-4, 0, 1e-12},
                      {"Cylindrical_Case02", {"JPRIM/1", "JPRIM/2"}},
                      {"Prismatic_Case01", {"JPRIM/1", "JPRIM/2"}, 1e-5, 1e-4, 0, 1e-12},
                      {"Prismatic_Case02", {"JPRIM/1", "JPRIM/2"}},
                      {"Universal_Case01", {"JPRIM/1", "JPRIM/2"}, 1e-5, 1e-4, 3e-4, 4e-3}};

class Adams : public ::testing::TestWithParam<std::tuple<Case, bool>> {};

TEST_P(Adams, PositionsAndReactionsAgree) {
    const auto& [c, asJprims] = GetParam();
    const Table reference = readReference(c.name);
    const Mechanism mechanism = testing::buildFileOrFail(testing::getDataFolder() + "adams/" + c.name +
                                                         (asJprims ? "_jprim.adm" : "_joint.adm"));
    const Results results = testing::run(mechanism, 5, 100, Accuracy).results;
    ASSERT_EQ(results.parts.getNumRows(), reference.getNumRows());

    const Vectors position = getVectors(reference, {"X", "Y", "Z"});
    EXPECT_LE(calcRms(sumVectors(results.parts, {"PART/2."}), position),
              std::max(c.position * findSize(position), c.positionFloor));

    std::vector<std::string> elements = asJprims ? c.jprims : std::vector<std::string>{"JOINT/1"};
    const auto onI = [&](const char* component) {
        std::vector<std::string> prefixes;
        for (const std::string& element : elements) prefixes.push_back(element + ".I." + component);
        return sumVectors(results.reactions, prefixes);
    };
    const Vectors force = getVectors(reference, {"FX", "FY", "FZ"});
    const Vectors torque = getVectors(reference, {"TX", "TY", "TZ"});
    EXPECT_LE(calcRms(onI("F"), force), std::max(c.load * findPeak(force), c.forceFloor));
    EXPECT_LE(calcRms(onI("T"), torque), std::max(c.load * findPeak(torque), c.torqueFloor));

    // REQUEST/FORCE adds up whatever acts between the two markers.
    EXPECT_LE(calcRms(sumVectors(results.requests, {"R2.F"}), onI("F")), 1e-12 * (1 + findPeak(force)));
    EXPECT_LE(calcRms(sumVectors(results.requests, {"R1."}), position),
              std::max(c.position * findSize(position), c.positionFloor));
}

INSTANTIATE_TEST_SUITE_P(Cases, Adams, ::testing::Combine(::testing::ValuesIn(Cases), ::testing::Bool()),
                         [](const auto& info) {
                             return std::string(std::get<0>(info.param).name) +
                                    (std::get<1>(info.param) ? "AsJprims" : "AsJoint");
                         });

// The comparison can fail: the same case with one part in ten thousand more gravity does not agree.
TEST(AdamsMutant, SlightlyWrongGravityIsNoticed) {
    const std::string path = testing::getDataFolder() + "adams/Revolute_Case01_joint.adm";
    Diagnostics diagnostics;
    Dataset dataset = readDatasetFile(path, diagnostics);
    dataset.gravity->acceleration[2] *= 1 + 1e-4;
    const Mechanism mechanism = std::move(*buildMechanism(dataset, diagnostics, testing::getBuildOptions()));
    const Results results = testing::run(mechanism, 5, 100, Accuracy).results;
    const Vectors position = getVectors(readReference("Revolute_Case01"), {"X", "Y", "Z"});
    EXPECT_GT(calcRms(sumVectors(results.parts, {"PART/2."}), position), 1e-5 * findSize(position));
}

// A massless link with a hinge at one end and a ball at the other. On the link only these two loads act, so
// the load at the ball, moved along the lever r to the hinge, is the load there.
class RevSpherical : public ::testing::TestWithParam<bool> {};

TEST_P(RevSpherical, ReactionsOnBothBodiesAndTheLever) {
    const bool asJprims = GetParam();
    const Table reference = readReference("RevSpherical_Case01");
    const Mechanism mechanism = testing::buildFileOrFail(
        testing::getDataFolder() + "adams/RevSpherical_Case01" + (asJprims ? "_jprim.adm" : "_joint.adm"));
    const Results results = testing::run(mechanism, 5, 100, Accuracy).results;
    const std::vector<std::string> hinge =
        asJprims ? std::vector<std::string>{"JPRIM/1", "JPRIM/2"} : std::vector<std::string>{"JOINT/1"};
    const std::string ball = asJprims ? "JPRIM/3" : "JOINT/2";
    const auto onGround = [&](const char* component) {
        std::vector<std::string> prefixes;
        for (const std::string& element : hinge) prefixes.push_back(element + ".I." + component);
        return sumVectors(results.reactions, prefixes);
    };

    const Vectors position = getVectors(reference, {"X", "Y", "Z"});
    EXPECT_LE(calcRms(sumVectors(results.parts, {"PART/2."}), position), 1e-5 * findSize(position));
    const Vectors F1 = onGround("F"), M1 = onGround("T");
    const Vectors F2 = sumVectors(results.reactions, {ball + ".I.F"});
    const Vectors M2 = sumVectors(results.reactions, {ball + ".I.T"});
    for (const auto& [ours, name] : {std::pair(&F1, "F1"), std::pair(&M1, "M1"), std::pair(&F2, "F2")}) {
        const Vectors theirs = sumVectors(reference, {name});
        EXPECT_LE(calcRms(*ours, theirs), 1e-4 * findPeak(theirs)) << name;
    }
    EXPECT_EQ(findPeak(M2), 0);  // a ball carries no moment

    // M1 + M2 + r x F2 = 0 for r from the hinge to the ball: the link has next to no inertia of its own.
    const Vectors fromHingeToBall = sumVectors(results.requests, {"R1."});
    double largest = 0;
    for (size_t row = 0; row < M1.size(); ++row)
        largest = std::max(largest, (M1[row] + M2[row] + fromHingeToBall[row] % F2[row]).norm());
    EXPECT_LT(largest, 1e-5 * findPeak(M1));
}

INSTANTIATE_TEST_SUITE_P(Spelled, RevSpherical, ::testing::Bool(),
                         [](const auto& info) { return std::string(info.param ? "AsJprims" : "AsJoint"); });

// The pendulums of the cases above swing from horizontal; the time to the lowest point is a quarter of the
// period, in closed form 4 K(sin(45 deg)) / omega with omega^2 = m g l / (I + m l^2) = 9.80665 * 2 / 4.1.
// (K(sin(45 deg)) = 1.8540746773013719, Abramowitz & Stegun 17.3.)
TEST(ClosedForm, QuarterPeriodOfThePendulum) {
    const double omega = std::sqrt(9.80665 * 2 / 4.1);
    const double quarter = 1.8540746773013719 / omega;
    const Mechanism mechanism =
        testing::buildFileOrFail(testing::getDataFolder() + "adams/Universal_Case01_joint.adm");
    const Results results = testing::run(mechanism, 5 * quarter, 5, Accuracy).results;
    const Vectors position = sumVectors(results.parts, {"PART/2."});
    for (const int quarterNumber : {1, 3, 5})
        EXPECT_LT((position[quarterNumber] - SimTK::Vec3(0, 0, -2)).norm(), 1e-6) << quarterNumber;
}

}  // namespace
}  // namespace jprim
