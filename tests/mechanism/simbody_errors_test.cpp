// SPDX-License-Identifier: Apache-2.0
// What Simbody does not accept is an error at the statement that asks for it, not an exception.
#include <gtest/gtest.h>

#include "jprim/flexible/reduce_to_modes.h"
#include "support/run_dataset.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

TEST(SimbodyErrors, AFlexibleBodyThatNoneIsIsReportedAtItsStatement) {
    ModalBasis basis = reduceToModes(makeFiniteElementModel(testing::makeSteelBeam(2)), {{{1}, 0, {}}}, 1);
    basis.rigid.inertia = SimTK::Mat33(1, 0, 0, 0, 1, 0, 0, 0, 5);
    const std::string file = ::testing::TempDir() + "jprim_impossible_inertia.modes";
    saveModalBasis(basis, file);
    Diagnostics diagnostics;
    EXPECT_FALSE(testing::buildFromText("t\nPART/1,GROUND\n  FLEX_BODY/3,MODES_FILE='" + file + "'\nEND\n",
                                        diagnostics));
    const std::string text = testing::formatAll(diagnostics);
    EXPECT_EQ(text.rfind("3:3: error: FLEX_BODY/3: ", 0), 0u) << text;
    EXPECT_EQ(text.find('\n'), text.size() - 1) << text;
}

}  // namespace
}  // namespace jprim
