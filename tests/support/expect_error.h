// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_EXPECT_ERROR_H_
#define JPRIM_TESTS_SUPPORT_EXPECT_ERROR_H_

#include <gtest/gtest.h>

#include <string>

#include "jprim/base/error.h"

namespace jprim::testing {

/// The message of the jprim::Error that the action throws; the test fails if it throws none.
template <class Action>
std::string catchError(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    ADD_FAILURE() << "no jprim::Error was thrown";
    return "";
}

}  // namespace jprim::testing

#endif
