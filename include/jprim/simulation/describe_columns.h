// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SIMULATION_DESCRIBE_COLUMNS_H_
#define JPRIM_SIMULATION_DESCRIBE_COLUMNS_H_

#include <string>
#include <vector>

#include "jprim/mechanism/mechanism.h"
#include "jprim/results/result_sink.h"

namespace jprim {

/// What the numbers in a column of the results are.
struct ColumnDescription {
    std::string name;
    std::string dimension;  ///< "time", "length", "length/time^2", "rad", "force length", …; empty if unknown
    std::string element;    ///< "REQUEST/3", "JOINT/1", "PART/2"; empty of the time and of energies
};

using ColumnDescriptions = TypedResultTables<std::vector<ColumnDescription>>;

/// The columns that a simulation of the mechanism records, in their order.
ColumnDescriptions describeColumns(const Mechanism& mechanism);

}  // namespace jprim

#endif
