// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_RECORDER_H_
#define JPRIM_SRC_SIMULATION_RECORDER_H_

#include <functional>
#include <string>
#include <unordered_set>
#include <vector>

#include "jprim/build/mechanism.h"
#include "jprim/simulation/simulate.h"

namespace jprim {

/// Fills the tables of Results from States. Each column's name, unit and value are declared together.
class Recorder {
public:
    /// The mechanism must outlive the recorder.
    explicit Recorder(const Mechanism& mechanism);

    /// Adds one row to each table. Requires Stage::Acceleration.
    void record(const SimTK::State& state);

    Results& updResults() { return m_results; }

    /// The first of each request.
    const std::vector<NotFinite>& getNotFinite() const { return m_notFinite; }

private:
    /// Columns that are computed together.
    struct Group {
        Table* table;
        std::vector<double> unitsInSI;  // of each column
        std::function<void(const SimTK::State&, double*)> calcInSI;
        std::string request;  // "REQUEST/3", while all its values are numbers
    };

    struct Column {
        std::string name;
        double unitInSI;
    };

    void addGroup(Table& table, const std::string& prefix, const std::vector<Column>& columns,
                  std::function<void(const SimTK::State&, double*)> calcInSI);
    void watch(Group& group, size_t first);
    void addRequests();
    void addRequest(const MechanismRequest& request);
    std::vector<std::string> nameComponents(const MechanismRequest& request);
    void addReactions(const LoadElement& element);
    void addPart(const MechanismPart& part);
    void addModes(const MechanismPart& part);
    void addEnergy();

    const Mechanism& m_mechanism;
    Results m_results;
    std::vector<Group> m_groups;
    std::unordered_set<std::string> m_requestColumns;  // names taken so far, and all plain ones
    std::vector<NotFinite> m_notFinite;
};

}  // namespace jprim

#endif
