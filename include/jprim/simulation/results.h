// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SIMULATION_RESULTS_H_
#define JPRIM_SIMULATION_RESULTS_H_

#include <string>
#include <vector>

namespace jprim {

/// Rows of numbers under named columns; the first column is the time. In the dataset's units, angles in
/// radians.
struct Table {
    std::vector<std::string> columns;
    std::vector<double> values;  ///< row after row

    size_t getNumRows() const { return columns.empty() ? 0 : values.size() / columns.size(); }
    double getValue(size_t row, size_t column) const { return values[row * columns.size() + column]; }
    /// The values of one column. @throws Error if there is no column of this name
    std::vector<double> getColumn(const std::string& name) const;
};

/// What a simulation recorded at its output times.
/// - requests, after `R<id>.` or RESULTS_NAME and a point, the name in CNAMES, and where there is none, or it is taken
///   already: for DISPLACEMENT MAG X Y Z PSI THETA PHI, for VELOCITY VM VX VY VZ WM WX WY WZ,
///   for ACCELERATION ACCM ACCX ACCY ACCZ WDTM WDTX WDTY WDTZ, for FORCE FM FX FY FZ TM TX TY TZ,
///   for functions F1 … F8
/// - reactions, after `JPRIM/<id>.I.` and `.J.` and likewise JOINT: FX FY FZ TX TY TZ, Ground axes, at the
///   marker
/// - parts, after `PART/<id>.`: X Y Z of the mass centre, E0 E1 E2 E3 of the CM marker, VX VY VZ WX WY WZ in
///   Ground; likewise after `FLEX_BODY/<id>.`, and the modal coordinates Q1 Q2 …; after `energy.`: kinetic
///   potential total
struct Results {
    Table requests;
    Table reactions;
    Table parts;
};

/// Writes requests.csv, reactions.csv and parts.csv into a folder, which is made if need be. Numbers carry
/// the digits that reproduce them exactly. @throws Error if a file cannot be written
void writeResults(const Results& results, const std::string& folder);

}  // namespace jprim

#endif
