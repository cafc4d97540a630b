// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_RECORDER_H_
#define JPRIM_SRC_SIMULATION_RECORDER_H_

#include <functional>
#include <string>
#include <unordered_set>
#include <vector>

#include "jprim/mechanism/mechanism.h"
#include "jprim/results/result_sink.h"
#include "jprim/simulation/describe_columns.h"
#include "jprim/simulation/simulate.h"
#include "simulation/euler_signs.h"

namespace jprim {

/// Makes rows of results from States. Each column's name, unit and value are declared together.
class Recorder {
public:
    /// The mechanism and the sink must outlive the recorder.
    Recorder(const Mechanism& mechanism, ResultSink& sink);
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// Adds a row. Requires Stage::Acceleration.
    void record(const SimTK::State& state, const Violation& violation);

    /// The first of each request.
    const std::vector<NotFinite>& getNotFinite() const { return m_notFinite; }
    const ColumnDescriptions& getDescriptions() const { return m_descriptions; }

private:
    struct Table {
        std::vector<std::string>& columns;
        std::vector<double>& row;
        std::vector<ColumnDescription>& descriptions;
    };

    struct Unit {
        const char* dimension;
        double inSI;
    };
    static constexpr Unit Plain{"", 1};

    /// Columns of a table that are computed together.
    struct Group {
        Table table;
        size_t first;
        std::vector<double> unitsInSI;  // of each column
        std::function<void(const SimTK::State&, double*)> calcInSI;
        std::string request;  // "REQUEST/3", while all its values are numbers
    };

    struct Column {
        std::string name;
        Unit unit;
    };

    struct Units {
        explicit Units(const UnitSystem& u);
        Unit time, length, velocity, acceleration, angle, angularVelocity, angularAcceleration, force, moment;
    };

    // Columns whose names begin with the prefix, of an element "JOINT/3" or of none.
    void addGroup(const Table& table, const std::string& element, const std::string& prefix,
                  const std::vector<Column>& columns,
                  std::function<void(const SimTK::State&, double*)> calcInSI);
    void watch(Group& group);
    void addRequests();
    void addRequest(const MechanismRequest& request);
    std::vector<std::string> nameComponents(const MechanismRequest& request);
    void addReactions(const Element& element);
    void addPart(const MechanismPart& part);
    void addModes(const MechanismPart& part);
    void addEnergy();
    void addErrors();

    const Mechanism& m_mechanism;
    ResultSink& m_sink;
    const Units m_units;
    ResultColumns m_columns;
    ResultRow m_row;
    ColumnDescriptions m_descriptions;
    const Table m_requests{m_columns.requests, m_row.requests, m_descriptions.requests},
        m_reactions{m_columns.reactions, m_row.reactions, m_descriptions.reactions},
        m_parts{m_columns.parts, m_row.parts, m_descriptions.parts};
    std::vector<Group> m_groups;
    std::unordered_set<std::string> m_requestColumns;  // names taken so far, and all plain ones
    std::vector<NotFinite> m_notFinite;
    EulerSigns m_signs;
    Violation m_violation;  // in the row that is made
};

}  // namespace jprim

#endif
