// SPDX-License-Identifier: Apache-2.0
#include "jprim/simulation/run_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "jprim/base/error.h"

namespace jprim {

using SimTK::State;

namespace {

void append(const Table& added, bool withFirstRow, Table& table) {
    table.columns = added.columns;
    const size_t width = added.columns.size(),
                 skipped = withFirstRow ? 0 : std::min(width, added.values.size());
    table.values.insert(table.values.end(), added.values.begin() + std::ptrdiff_t(skipped),
                        added.values.end());
}

// The output times of a command that starts at `start`.
void chooseTimes(const SimulateCommand& command, double start, SimulationOptions& options) {
    options.end = command.end ? *command.end : start + *command.duration;
    if (!(options.end > start))
        throw Error("SIMULATE",
                    fmt::format("END={} is not later than the present time {}", options.end, start));
    const double steps = command.steps ? *command.steps : std::round((options.end - start) / *command.dtout);
    if (command.dtout &&
        (!(steps >= 1 && steps <= 1e9) ||
         std::abs(steps * *command.dtout - (options.end - start)) > 1e-9 * std::abs(options.end)))
        throw Error("SIMULATE", fmt::format("the time from {} to {} is not a multiple of DTOUT={}", start,
                                            options.end, *command.dtout));
    options.steps = int(steps);
}

class CommandRun {
public:
    CommandRun(const Mechanism& mechanism, const SimulationOptions& options)
        : m_mechanism(mechanism), m_options(options) {}

    CommandsOutcome run(const std::vector<Command>& commands) {
        for (const Command& command : commands) {
            m_outcome.where = std::visit([](const auto& c) { return c.where; }, command);
            try {
                std::visit([this](const auto& c) { execute(c); }, command);
            } catch (const std::exception& exception) {
                m_outcome.failure = exception.what();
            }
            if (!m_outcome.failure.empty() || m_halted) break;
        }
        return std::move(m_outcome);
    }

private:
    void execute(const ActivateCommand& command) {
        start();
        for (const IdRange& range : command.ids)
            for (const auto& [id, name] : findElements(command.kind, range))
                switchElement(name, command.active);
        m_switched = true;
    }

    void execute(const SimulateCommand& command) {
        start();
        if (m_switched) m_state = reassemble(m_mechanism, *m_state).state;
        const double time = m_state->getTime() / m_mechanism.getUnits().time;
        SimulationOptions options = m_options;
        options.kind = getKind(command.analysis);
        const bool isMoment = !command.end && !command.duration;
        if (isMoment)
            options.steps = 0;
        else
            chooseTimes(command, time, options);
        AssembledState initial;
        initial.state = *m_state;
        SimulationOutcome outcome = simulate(m_mechanism, initial, options);
        const bool isFirst = m_outcome.summaries.empty();
        for (const auto table : {&Results::requests, &Results::reactions, &Results::parts})
            append(outcome.results.*table, isFirst || m_switched || isMoment, m_outcome.results.*table);
        m_switched = false;
        m_state = outcome.finalState;
        m_outcome.failure = outcome.failure;
        m_halted = outcome.summary.isHalted;
        m_outcome.summaries.push_back({fmt::format("SIMULATE/{}", getAdamsName(command.analysis)), time,
                                       m_state->getTime() / m_mechanism.getUnits().time, outcome.summary});
    }

    static SimulationKind getKind(Analysis analysis) {
        switch (analysis) {
            case Analysis::Dynamics: return SimulationKind::Dynamics;
            case Analysis::Kinematics: return SimulationKind::Kinematics;
            case Analysis::Statics: return SimulationKind::Statics;
            default: return SimulationKind::Automatic;
        }
    }

    void start() {
        if (m_state) return;
        const AssembledState initial = assemble(m_mechanism);
        m_outcome.yielded = initial.yielded;
        m_state = initial.state;
    }

    // (id, name) of the elements of a kind in a range; a single id must exist.
    std::vector<std::pair<int, std::string>> findElements(ElementKind kind, const IdRange& range) const {
        const std::string prefix = std::string(getAdamsName(kind)) + "/";
        std::vector<std::pair<int, std::string>> found;
        for (const std::string& name : m_mechanism.getSwitchableElements()) {
            if (name.compare(0, prefix.size(), prefix) != 0) continue;
            const int id = std::stoi(name.substr(prefix.size()));
            if (range.first <= id && id <= range.last) found.emplace_back(id, name);
        }
        if (found.empty() && range.first == range.last)
            throw Error(prefix + std::to_string(range.first), "does not exist in this model");
        return found;
    }

    void switchElement(const std::string& name, bool active) {
        const SimTK::Constraint constraint = m_mechanism.getConstraint(name);
        if (active)
            constraint.enable(*m_state);
        else
            constraint.disable(*m_state);
    }

    const Mechanism& m_mechanism;
    const SimulationOptions& m_options;
    CommandsOutcome m_outcome;
    std::optional<State> m_state;
    bool m_switched = false;
    bool m_halted = false;
};

}  // namespace

CommandsOutcome runCommands(const Mechanism& mechanism, const std::vector<Command>& commands,
                            const SimulationOptions& options) {
    return CommandRun(mechanism, options).run(commands);
}

}  // namespace jprim
