// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_CONTROL_LINEAR_SYSTEMS_H_
#define JPRIM_SRC_MECHANISM_CONTROL_LINEAR_SYSTEMS_H_

#include <functional>
#include <string>
#include <vector>

#include "jprim/dataset/dataset.h"

namespace jprim {

/// Row by row; of no rows and columns if there is none.
struct Coefficients {
    int rows = 0, columns = 0;
    std::vector<double> values;

    double get(int row, int column) const { return values[size_t(row * columns + column)]; }
};

/// dx/dt = A x + B u, y = C x + D u: what an LSE or TFSISO says.
struct LinearSystem {
    SourcePosition where;
    std::string name;         ///< "LSE/3"
    int x = 0, u = 0, y = 0;  ///< ARRAYs; 0 if there is none
    int numStates = 0, numOutputs = 0;
    Coefficients A, B, C, D;
    std::vector<int> inputs;      ///< VARIABLEs
    std::vector<double> initial;  ///< states
    bool staticHold = false;
};

using ReportMistake = std::function<void(const SourcePosition&, const std::string&)>;

/// All systems in which no mistake is found. What names a statement with errors is left out without a word.
std::vector<LinearSystem> makeLinearSystems(const Dataset& dataset, const ReportMistake& report);

}  // namespace jprim

#endif
