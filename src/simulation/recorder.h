// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_RECORDER_H_
#define JPRIM_SRC_SIMULATION_RECORDER_H_

#include <functional>
#include <string>
#include <unordered_set>
#include <vector>

#include "jprim/mechanism/mechanism.h"
#include "jprim/results/result_sink.h"
#include "jprim/simulation/simulate.h"

namespace jprim {

/// Makes rows of results from States. Each column's name, unit and value are declared together.
class Recorder {
public:
    /// The mechanism and the sink must outlive the recorder.
    Recorder(const Mechanism& mechanism, ResultSink& sink);
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// Adds a row. Requires Stage::Acceleration.
    void record(const SimTK::State& state);

    /// The first of each request.
    const std::vector<NotFinite>& getNotFinite() const { return m_notFinite; }

private:
    struct Table {
        std::vector<std::string>& columns;
        std::vector<double>& row;
    };

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
        double unitInSI;
    };

    void addGroup(const Table& table, const std::string& prefix, const std::vector<Column>& columns,
                  std::function<void(const SimTK::State&, double*)> calcInSI);
    void watch(Group& group);
    void addRequests();
    void addRequest(const MechanismRequest& request);
    std::vector<std::string> nameComponents(const MechanismRequest& request);
    void addReactions(const Element& element);
    void addPart(const MechanismPart& part);
    void addModes(const MechanismPart& part);
    void addEnergy();

    const Mechanism& m_mechanism;
    ResultSink& m_sink;
    ResultColumns m_columns;
    ResultRow m_row;
    const Table m_requests{m_columns.requests, m_row.requests},
        m_reactions{m_columns.reactions, m_row.reactions}, m_parts{m_columns.parts, m_row.parts};
    std::vector<Group> m_groups;
    std::unordered_set<std::string> m_requestColumns;  // names taken so far, and all plain ones
    std::vector<NotFinite> m_notFinite;
};

}  // namespace jprim

#endif
