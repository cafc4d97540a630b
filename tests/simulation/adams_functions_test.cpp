// SPDX-License-Identifier: Apache-2.0
// Agreement with Adams/Solver's own results where function expressions constrain or pull. Source of the
// figures: Project Chrono, data/testing/joints, computed with Adams by its authors; the datasets are our own
// wording with the same parameters.
#include <gtest/gtest.h>

#include "base/format.h"
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

// Tight enough for our own error to be far below Adams'.
constexpr double Accuracy = 1e-8;
// Required RMS, of the size of the motion and of the peak of the load.
constexpr double PositionTolerance = 1e-5, LoadTolerance = 1e-4;

Results runCase(const std::string& name, double springFactor = 1) {
    Diagnostics diagnostics;
    Dataset dataset = readDatasetFile(testing::getDataFolder() + "adams/" + name + ".adm", diagnostics);
    for (SforceStatement& force : dataset.sforces)
        force.function.text = fmt::format("{}*({})", springFactor, force.function.text);
    std::optional<Mechanism> mechanism = buildMechanism(dataset, diagnostics, testing::getBuildOptions());
    if (!mechanism) throw std::runtime_error(testing::formatAll(diagnostics));
    return testing::run(*mechanism, 5, 100, Accuracy).results;
}

double calcPositionError(const Results& results, const Vectors& reference) {
    return calcRms(sumVectors(results.parts, {"PART/2."}), reference) / findSize(reference);
}

class AdamsDistance : public ::testing::TestWithParam<const char*> {};

TEST_P(AdamsDistance, PositionsAndReactionsAgree) {
    const Table reference = readReference(GetParam());
    const Results results = runCase(GetParam());
    EXPECT_LE(calcPositionError(results, getVectors(reference, {"X", "Y", "Z"})), PositionTolerance);
    const Vectors force = getVectors(reference, {"FX", "FY", "FZ"});
    const Vectors onGround = sumVectors(results.reactions, {"GCON/1.I.F"});
    EXPECT_LE(calcRms(onGround, force), LoadTolerance * findPeak(force));
    EXPECT_LE(calcRms(sumVectors(results.requests, {"R2.F"}), onGround), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Cases, AdamsDistance, ::testing::Values("Distance_Case01", "Distance_Case02"));

TEST(AdamsSpring, TorqueOfASforceOnAnAngle) {
    const Table reference = readReference("RotSpring_Case01");
    const Results results = runCase("RotSpring_Case01");
    EXPECT_LE(calcPositionError(results, getVectors(reference, {"X", "Y", "Z"})), PositionTolerance);
    const Vectors torque = getVectors(reference, {"TX", "TY", "TZ"});
    EXPECT_LE(calcRms(getVectors(results.requests, {"R2.F6", "R2.F7", "R2.F8"}), torque),
              LoadTolerance * findPeak(torque));
}

TEST(AdamsSpring, ForceOfASforceOnADistance) {
    const Table reference = readReference("TranSpring_Case01");
    const Results results = runCase("TranSpring_Case01");
    EXPECT_LE(calcPositionError(results, getVectors(reference, {"X", "Y", "Z"})), PositionTolerance);
    const Vectors force = getVectors(reference, {"FX", "FY", "FZ"});
    EXPECT_LE(calcRms(getVectors(results.requests, {"R2.F2", "R2.F3", "R2.F4"}), force),
              LoadTolerance * findPeak(force));
}

// The comparison can fail: one part in a thousand more force does not agree.
TEST(AdamsSpring, ASlightlyStrongerSpringIsNoticed) {
    const Vectors position = getVectors(readReference("TranSpring_Case01"), {"X", "Y", "Z"});
    EXPECT_GT(calcPositionError(runCase("TranSpring_Case01", 1.001), position), PositionTolerance);
}

}  // namespace
}  // namespace jprim
