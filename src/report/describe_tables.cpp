// SPDX-License-Identifier: Apache-2.0
// Requests, reactions, energies and what parts do. What matters least is left out first where it is too much for a file.
#include <algorithm>
#include <functional>

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

/// Every stride-th row.
template <class T>
std::vector<T> collect(const Selection& s, size_t stride) {
    const size_t rows = s.table.getNumRows(), width = s.table.columns.size();
    std::vector<T> values;
    values.reserve(s.getNumValues() / stride + s.columns.size());
    for (const size_t column : s.columns)
        for (size_t row = 0; row < rows; row += stride)
            values.push_back(T(s.table.values[row * width + column]));
    return values;
}

/// Adds tables while there is room.
class TableWriter {
public:
    TableWriter(const Dataset& dataset, size_t bytes, ReportData& data, std::vector<std::string>& omitted)
        : m_units(findUnitNames(dataset)), m_left(bytes), m_data(data), m_omitted(omitted) {}

    bool fits(const Selection& s) const { return s.getNumValues() * sizeof(double) <= m_left; }

    void add(const Selection& s) {
        m_left -= std::min(m_left, s.getNumValues() * sizeof(double));
        add(s, 1, m_data.addArray(collect<double>(s, 1), {s.columns.size(), s.table.getNumRows()}));
    }

    /// With fewer digits where it would not fit, and with fewer rows where that is too much too.
    void addAsFits(const Selection& s) {
        if (fits(s)) return add(s);
        const size_t bytes = s.getNumValues() * sizeof(float);
        const size_t stride = 1 + (bytes - 1) / std::max<size_t>(m_left, 1);
        const size_t used = std::min(stride, std::max<size_t>(s.table.getNumRows() / FewestRows, 1));
        m_left -= std::min(m_left, bytes / used);
        const size_t rows = (s.table.getNumRows() + used - 1) / used;
        add(s, used, m_data.addArray(collect<float>(s, used), {s.columns.size(), rows}));
        m_omitted.push_back(fmt::format("digits of {0} beyond the seventh: see {0}.csv", s.name));
        if (used > 1)
            m_omitted.push_back(
                fmt::format("all but every {}th row of {}, and with them perhaps largest values: see {}.csv",
                            used, s.name, s.name));
    }

    const Json& getTables() const { return m_tables; }

private:
    static constexpr size_t FewestRows = 100;

    void add(const Selection& s, size_t stride, Json data) {
        Json columns = Json::array();
        for (const size_t k : s.columns) columns.push_back(makeColumn(s.descriptions[k]));
        const std::vector<double> times = collect<double>({"time", s.table, s.descriptions, {0}}, stride);
        m_tables.push_back({{"name", s.name},
                            {"columns", columns},
                            {"time", m_data.addArray(times, {times.size()})},
                            {"data", std::move(data)}});
    }

    Json makeColumn(const ColumnDescription& column) const {
        return {{"name", column.name},
                {"unit", m_units.getName(column.dimension)},
                {"element", column.element.empty() ? Json(nullptr) : Json(column.element)}};
    }

    UnitNames m_units;
    size_t m_left;
    ReportData& m_data;
    std::vector<std::string>& m_omitted;
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
    TableWriter writer(dataset, bytes, data, omitted);
    writer.addAsFits(select("requests", results.requests, columns.requests, all));
    writer.add(select("energy", results.parts, columns.parts, isEnergy));

    const Selection reactions = select("reactions", results.reactions, columns.reactions, all);
    if (writer.fits(reactions)) {
        writer.add(reactions);
    } else {
        omitted.push_back("reactions on markers J: see reactions.csv");
        writer.addAsFits(select("reactions", results.reactions, columns.reactions,
                                [](const ColumnDescription& c) { return !isOnJ(c); }));
    }
    const Selection parts = select("parts", results.parts, columns.parts, std::not_fn(isEnergy));
    if (writer.fits(parts))
        writer.add(parts);
    else
        omitted.push_back("velocities of parts: see parts.csv");
    return writer.getTables();
}

}  // namespace jprim
