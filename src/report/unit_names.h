// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_REPORT_UNIT_NAMES_H_
#define JPRIM_SRC_REPORT_UNIT_NAMES_H_

#include <string>

#include "jprim/dataset/dataset.h"

namespace jprim {

/// What a dataset's units are called: "mm", "N", "kg", "s".
struct UnitNames {
    std::string length, force, mass, time;

    /// Of a ColumnDescription::dimension: "N mm" of "force length".
    std::string getName(const std::string& dimension) const;
};

UnitNames findUnitNames(const Dataset& dataset);

}  // namespace jprim

#endif
