// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_DATASET_UNITS_H_
#define JPRIM_TESTS_SUPPORT_DATASET_UNITS_H_

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/format.h"

namespace jprim::testing {

/// A metre and a second in the units of a dataset, whose masses are in kg and forces in N. A stiffness of
/// 500 N/m is written 500 / u.m.
struct DatasetUnits {
    const char* name;
    const char* statement;
    double m;
    double s;
};

const DatasetUnits MetreSecond = {"MetreSecond", "UNITS/SYSTEM=MKS\n", 1, 1};
/// 1 N is 1000 kg mm/ms^2 here: whoever forgets a conversion is off by powers of 1000.
const DatasetUnits MillimetreMillisecond = {
    "MillimetreMillisecond", "UNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=MILLIMETER,TIME=MILLISECOND\n", 1e3,
    1e3};

/// A test that is run with its numbers in both.
class InBothUnits : public ::testing::TestWithParam<DatasetUnits> {
protected:
    const DatasetUnits& u = GetParam();
};

inline std::string getUnitsName(const ::testing::TestParamInfo<DatasetUnits>& info) {
    return info.param.name;
}

#define JPRIM_INSTANTIATE_IN_BOTH_UNITS(Suite)                                                        \
    INSTANTIATE_TEST_SUITE_P(Units, Suite,                                                            \
                             ::testing::Values(testing::MetreSecond, testing::MillimetreMillisecond), \
                             testing::getUnitsName)

/// The largest difference between a column, in units of `unit`, and a function of time in seconds, of the function's
/// largest value or of 1 if that is smaller.
template <class Law>
double calcDeviation(const std::vector<double>& time, double second, const std::vector<double>& column,
                     double unit, const Law& law) {
    double difference = 0, size = 1;
    for (size_t k = 0; k < time.size(); ++k) {
        const double expected = law(time[k] / second);
        difference = std::max(difference, std::abs(column[k] / unit - expected));
        size = std::max(size, std::abs(expected));
    }
    return time.empty() ? INFINITY : difference / size;
}

}  // namespace jprim::testing

#endif
