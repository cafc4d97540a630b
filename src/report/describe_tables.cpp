// SPDX-License-Identifier: Apache-2.0
// Requests, reactions, energies and what parts do. What matters least is left out first where it is too much for a file.
#include <algorithm>
#include <numeric>

#include "base/format.h"
#include "jprim/base/error.h"
#include "jprim/simulation/describe_columns.h"
#include "report/describe.h"
#include "report/unit_names.h"

namespace jprim {

namespace {

using Descriptions = std::vector<ColumnDescription>;

/// Some of the columns of a table of results.
struct Selection {
    const char* name;
    const Table& table;
    const Descriptions& descriptions;
    std::vector<size_t> columns;

    size_t getNumValues() const { return table.getNumRows() * columns.size(); }
};

template <class Wanted>
Selection select(const char* name, const Table& table, const Descriptions& descriptions, Wanted wanted) {
    Selection selection{name, table, descriptions, {}};
    for (size_t k = 1; k < descriptions.size(); ++k)
        if (wanted(descriptions[k])) selection.columns.push_back(k);
    return selection;
}

void checkColumns(const Table& table, const Descriptions& descriptions) {
    const bool same =
        std::equal(table.columns.begin(), table.columns.end(), descriptions.begin(), descriptions.end(),
                   [](const std::string& name, const ColumnDescription& d) { return name == d.name; });
    if (!same) throw Error("results", "have other columns than the model; they are not of this model");
}

bool isOnJ(const ColumnDescription& column) {
    return column.name.rfind(column.element + ".J.", 0) == 0;
}

template <class T>
std::vector<T> collect(const Selection& s) {
    const size_t rows = s.table.getNumRows(), width = s.table.columns.size();
    std::vector<T> values;
    values.reserve(s.getNumValues());
    for (const size_t column : s.columns)
        for (size_t row = 0; row < rows; ++row) values.push_back(T(s.table.values[row * width + column]));
    return values;
}

/// Adds tables while there is room.
class TableWriter {
public:
    TableWriter(const Dataset& dataset, size_t bytes, ReportData& data)
        : m_units(findUnitNames(dataset)), m_left(bytes), m_data(data) {}

    bool fits(const Selection& s, size_t bytesOfNumber) const {
        return s.getNumValues() * bytesOfNumber <= m_left;
    }

    void add(const Selection& s, bool inFull) {
        m_left -= std::min(m_left, s.getNumValues() * (inFull ? 8 : 4));
        const std::vector<size_t> shape = {s.columns.size(), s.table.getNumRows()};
        Json columns = Json::array();
        for (const size_t k : s.columns) columns.push_back(makeColumn(s.descriptions[k]));
        const Selection time{"time", s.table, s.descriptions, {0}};
        m_tables.push_back({{"name", s.name},
                            {"columns", columns},
                            {"time", m_data.addArray(collect<double>(time), {s.table.getNumRows()})},
                            {"data", inFull ? m_data.addArray(collect<double>(s), shape)
                                            : m_data.addArray(collect<float>(s), shape)}});
    }

    const Json& getTables() const { return m_tables; }

private:
    Json makeColumn(const ColumnDescription& column) const {
        return {{"name", column.name},
                {"unit", m_units.getName(column.dimension)},
                {"element", column.element.empty() ? Json(nullptr) : Json(column.element)}};
    }

    UnitNames m_units;
    size_t m_left;
    ReportData& m_data;
    Json m_tables = Json::array();
};

}  // namespace

Json describeTables(const Dataset& dataset, const Mechanism& mechanism, const Results& results, size_t bytes,
                    ReportData& data, std::vector<std::string>& omitted) {
    const ColumnDescriptions columns = describeColumns(mechanism);
    checkColumns(results.requests, columns.requests);
    checkColumns(results.reactions, columns.reactions);
    checkColumns(results.parts, columns.parts);
    const auto all = [](const ColumnDescription&) { return true; };
    const auto isEnergy = [](const ColumnDescription& c) { return c.element.empty(); };
    TableWriter writer(dataset, bytes, data);
    writer.add(select("requests", results.requests, columns.requests, all), true);
    writer.add(select("energy", results.parts, columns.parts, isEnergy), true);

    const Selection reactions = select("reactions", results.reactions, columns.reactions, all);
    const Selection onI = select("reactions", results.reactions, columns.reactions,
                                 [](const ColumnDescription& c) { return !isOnJ(c); });
    const bool isComplete = writer.fits(reactions, 8), isSingle = !isComplete && !writer.fits(onI, 8);
    writer.add(isComplete ? reactions : onI, !isSingle);
    if (!isComplete) omitted.push_back("reactions on markers J: see reactions.csv");
    if (isSingle) omitted.push_back("digits of reactions beyond the seventh: see reactions.csv");

    const Selection parts = select("parts", results.parts, columns.parts, std::not_fn(isEnergy));
    if (writer.fits(parts, 8))
        writer.add(parts, true);
    else
        omitted.push_back("velocities of parts: see parts.csv");
    return writer.getTables();
}

}  // namespace jprim
