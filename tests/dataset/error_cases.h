// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_DATASET_ERROR_CASES_H_
#define JPRIM_TESTS_DATASET_ERROR_CASES_H_

#include <string>
#include <vector>

#include "dataset/reading.h"

namespace jprim {

/// Statements with a mistake, and all that the reader finds. QQQ marks what is wrong on purpose.
struct ErrorCase {
    const char* name;
    std::string statements;  ///< the first stands in line 3
    const char* findings;
};

inline void check(const std::vector<ErrorCase>& cases) {
    for (const ErrorCase& c : cases) {
        SCOPED_TRACE(c.name);
        EXPECT_EQ(readInModel(c.statements).findings, c.findings);
    }
}

}  // namespace jprim

#endif
