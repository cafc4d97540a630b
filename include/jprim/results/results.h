// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_RESULTS_RESULTS_H_
#define JPRIM_RESULTS_RESULTS_H_

#include <string>
#include <vector>

#include "jprim/results/result_sink.h"

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

/// What a simulation recorded at its output times, in memory.
struct Results {
    Table requests;
    Table reactions;
    Table parts;
};

/// Fills Results, which must outlive it.
class ResultMemory final : public ResultSink {
public:
    explicit ResultMemory(Results& results) : m_results(results) {}

    void begin(const ResultColumns& columns) override;
    void add(const ResultRow& row) override;

private:
    Results& m_results;
};

/// Writes what is in memory as CsvFiles do. @throws Error if a file cannot be written
void writeResults(const Results& results, const std::string& folder);

}  // namespace jprim

#endif
