// SPDX-License-Identifier: Apache-2.0
#include "jprim/results/results.h"

#include <algorithm>

#include "jprim/base/error.h"
#include "jprim/results/csv_files.h"

namespace jprim {

std::vector<double> Table::getColumn(const std::string& name) const {
    const auto found = std::find(columns.begin(), columns.end(), name);
    if (found == columns.end()) throw Error(name, "is not a column of the results");
    std::vector<double> column;
    for (size_t k = size_t(found - columns.begin()); k < values.size(); k += columns.size())
        column.push_back(values[k]);
    return column;
}

void ResultMemory::begin(const ResultColumns& columns) {
    m_results.requests.columns = columns.requests;
    m_results.reactions.columns = columns.reactions;
    m_results.parts.columns = columns.parts;
}

void ResultMemory::add(const ResultRow& row) {
    const auto append = [](const std::vector<double>& added, Table& table) {
        table.values.insert(table.values.end(), added.begin(), added.end());
    };
    append(row.requests, m_results.requests);
    append(row.reactions, m_results.reactions);
    append(row.parts, m_results.parts);
}

namespace {

std::vector<double> getRow(const Table& table, size_t row) {
    const auto begin = table.values.begin() + std::ptrdiff_t(row * table.columns.size());
    return {begin, begin + std::ptrdiff_t(table.columns.size())};
}

}  // namespace

void writeResults(const Results& results, const std::string& folder) {
    CsvFiles files(folder);
    files.begin({results.requests.columns, results.reactions.columns, results.parts.columns});
    for (size_t row = 0; row < results.parts.getNumRows(); ++row)
        files.add(
            {getRow(results.requests, row), getRow(results.reactions, row), getRow(results.parts, row)});
}

}  // namespace jprim
