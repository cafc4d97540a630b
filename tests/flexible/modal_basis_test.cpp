// SPDX-License-Identifier: Apache-2.0
#include "jprim/flexible/modal_basis.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "jprim/flexible/reduce_to_modes.h"
#include "support/expect_error.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

using SimTK::Vec3;

ModalBasis makeBasis() {
    return reduceToModes(makeFiniteElementModel(testing::makeSteelBeam(3)), {{{2}, 0, {}}}, 3);
}

std::string getFile(const std::string& name) {
    return ::testing::TempDir() + name;
}

std::string readText(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

void writeText(const std::string& file, const std::string& text) {
    std::ofstream(file) << text;
}

//------------------------------------------------------------------------------------------- file
TEST(ModalBasisFile, ReadsBackToTheSameText) {
    ModalBasis basis = makeBasis();
    basis.name = "crank shaft, left";
    basis.interfaces = {2, 4};
    const std::string first = getFile("first.modes"), second = getFile("second.modes");
    saveModalBasis(basis, first);
    const ModalBasis loaded = loadModalBasis(first);
    saveModalBasis(loaded, second);
    EXPECT_EQ(readText(first), readText(second));
    EXPECT_EQ(loaded.name, "crank shaft, left");
    EXPECT_EQ(loaded.frequencies, basis.frequencies);
    EXPECT_EQ(loaded.getNode(4).rotation[1], basis.getNode(4).rotation[1]);
    EXPECT_EQ(loaded.inertiaChange[2], basis.inertiaChange[2]);
    EXPECT_EQ(loaded.getGyroscopic(2, 1), basis.getGyroscopic(2, 1));
    EXPECT_EQ(loaded.rigid.inertia, basis.rigid.inertia);
}

// A byte changed anywhere, or any part missing, is noticed.
TEST(ModalBasisFile, RefusesDamage) {
    const std::string file = getFile("damaged.modes");
    saveModalBasis(makeBasis(), file);
    const std::string text = readText(file);
    const auto expectError = [&](const std::string& damaged, const std::string& message) {
        writeText(file, damaged);
        EXPECT_EQ(testing::catchError([&] { loadModalBasis(file); }), file + message);
    };
    const std::string changed =
        ": has been changed since it was written (its checksum does not fit); copy it again or make it again "
        "with `jprim reduce`";
    const std::string cut = ": is cut off; copy it again or make it again with `jprim reduce`";
    const std::string foreign =
        ": is not a file of modes; `jprim reduce` makes one from a finite-element mesh";
    for (const size_t at : {size_t(20), text.size() / 2, text.size() - 3}) {
        std::string damaged = text;
        damaged[at] = damaged[at] == '1' ? '2' : '1';
        expectError(damaged, changed);
    }
    expectError(text.substr(0, text.size() / 2), cut);
    expectError(text.substr(0, text.size() - 2), cut);
    expectError("", foreign);
    expectError("PART/1,GROUND\n", foreign);
    expectError("jprim-modes 7\n", ": has version 7; this program reads version 1");
}

TEST(ModalBasisFile, RefusesWhatItCannotOpenOrWrite) {
    EXPECT_EQ(testing::catchError([] { loadModalBasis("/nowhere/x.modes"); }),
              "/nowhere/x.modes: cannot be opened");
    EXPECT_EQ(testing::catchError([] { saveModalBasis({}, "/nowhere/x.modes"); }),
              "/nowhere/x.modes: cannot be written");
}

//------------------------------------------------------------------------------------------- units
// The same beam in mm, tonne and ms, reduced there: the same basis converted.
TEST(ModalBasis, UnitsDoNotMatter) {
    constexpr double L = 1e3, M = 1e-3, T = 1e3, Tolerance = 1e-7;
    UniformBeam beam = testing::makeSteelBeam(3);
    const auto reduce = [](const UniformBeam& b) {
        return reduceToModes(makeFiniteElementModel(b), {{{2}, 0, {}}}, 3);
    };
    const ModalBasis converted = convertUnits(reduce(beam), L, M, T);
    const double stress = M / (L * T * T);
    beam.length *= L;
    beam.youngsModulus *= stress;
    beam.shearModulus *= stress;
    beam.density *= M / (L * L * L);
    beam.area *= L * L;
    for (double* moment : {&beam.secondMomentY, &beam.secondMomentZ, &beam.torsionConstant})
        *moment *= L * L * L * L;
    const ModalBasis direct = reduce(beam);
    EXPECT_NEAR(converted.rigid.mass / direct.rigid.mass, 1, Tolerance);
    EXPECT_LT((converted.rigid.center - direct.rigid.center).norm(), Tolerance * L);
    EXPECT_LT((converted.rigid.inertia - direct.rigid.inertia).norm(),
              Tolerance * direct.rigid.inertia.norm());
    for (int k = 0; k < direct.getNumModes(); ++k) {
        EXPECT_NEAR(converted.frequencies[k] / direct.frequencies[k], 1, Tolerance);
        const ModalNode &a = converted.getNode(4), &b = direct.getNode(4);
        // The largest term may change with the unit, and with it the sign.
        const double sign =
            SimTK::dot(a.translation[k], b.translation[k]) + SimTK::dot(a.rotation[k], b.rotation[k]) < 0 ? -1
                                                                                                          : 1;
        EXPECT_LT((a.translation[k] - sign * b.translation[k]).norm(), Tolerance * b.translation[k].norm());
        EXPECT_LT((a.rotation[k] - sign * b.rotation[k]).norm(), Tolerance * b.rotation[k].norm());
        EXPECT_LT((converted.inertiaChange[k] - sign * direct.inertiaChange[k]).norm(),
                  Tolerance * L * std::sqrt(M));
    }
    EXPECT_NEAR(converted.gyroscopic[0].norm(), direct.gyroscopic[0].norm(), Tolerance);
}

TEST(ModalBasis, MoveOriginMovesPointsOnly) {
    const ModalBasis basis = makeBasis(), moved = moveOrigin(basis, basis.rigid.center);
    EXPECT_LT(moved.rigid.center.norm(), 1e-15);
    EXPECT_LT((moved.getNode(1).position - Vec3(-1, 0, 0)).norm(), 1e-12);
    EXPECT_EQ(moved.rigid.inertia, basis.rigid.inertia);
    EXPECT_EQ(moved.getNode(1).translation[0], basis.getNode(1).translation[0]);
}

TEST(ModalBasis, NamesAnUnknownNode) {
    EXPECT_EQ(testing::catchError([] { makeBasis().getNode(5); }), "beam: has no node 5");
}

}  // namespace
}  // namespace jprim
