// SPDX-License-Identifier: Apache-2.0
#include "support/two_routes.h"

#include <algorithm>
#include <cmath>

#include "jprim/analysis/constraint_report.h"
#include "support/run_dataset.h"

namespace jprim::testing {

namespace {

bool isCompared(const std::string& column) {
    const std::string name = column.substr(column.rfind('.') + 1);
    return name[0] != 'E' && name != "PSI" && name != "THETA" && name != "PHI";
}

}  // namespace

double findDifference(const Table& a, const Table& b) {
    if (a.getNumRows() != b.getNumRows()) return SimTK::Infinity;
    double largest = 1, difference = 0;
    for (const double value : a.values) largest = std::max(largest, std::abs(value));
    for (size_t i = 0; i < a.columns.size(); ++i) {
        if (!isCompared(a.columns[i])) continue;
        const auto found = std::find(b.columns.begin(), b.columns.end(), a.columns[i]);
        if (found == b.columns.end()) return SimTK::Infinity;
        for (size_t row = 0; row < a.getNumRows(); ++row)
            difference = std::max(difference, std::abs(a.getValue(row, i) -
                                                       b.getValue(row, size_t(found - b.columns.begin()))));
    }
    return difference / largest;
}

bool isDetermined(const std::string& dataset) {
    constexpr double Near = 0.1, Violent = 50;  // a scaled singular value; J
    const Mechanism mechanism = buildOrFail(dataset, {Formulation::Constraints});
    const SimTK::State given = mechanism.makeGivenState();
    mechanism.getSystem().realize(given, SimTK::Stage::Position);
    const ConstraintCount count = countFreedoms(mechanism.getMatter(), given);
    if (count.getNumRedundant() > 0 || count.getDegreesOfFreedom() == 0 || count.smallestKept < Near)
        return false;
    return mechanism.calcKineticEnergy(assemble(mechanism).state) < Violent;
}

}  // namespace jprim::testing
