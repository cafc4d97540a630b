// SPDX-License-Identifier: Apache-2.0
#include "jprim/simulation/run_commands.h"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "base/format.h"
#include "jprim/base/error.h"
#include "simulation/euler_signs.h"

namespace jprim {

using SimTK::State;

namespace {

/// Rows of one command after those of another.
class ContinuedSink final : public ResultSink {
public:
    explicit ContinuedSink(ResultSink& target) : m_target(target) {}

    /// Before each command: whether its first row is another than the last one before.
    void continueWith(bool withFirstRow) { m_skips = !withFirstRow; }

    void begin(const ResultColumns& columns) override {
        if (std::exchange(m_hasBegun, true)) return;
        m_signs = EulerSigns(columns.parts);
        m_target.begin(columns);
    }
    void add(const ResultRow& row) override {
        ResultRow continued = row;
        m_signs.makeContinuous(continued.parts);
        if (!std::exchange(m_skips, false)) m_target.add(continued);
    }

private:
    ResultSink& m_target;
    EulerSigns m_signs;
    bool m_hasBegun = false, m_skips = false;
};

bool isMoment(const SimulateCommand& command) {
    return !command.end && !command.duration;
}

// END counts from the beginning of all, not from where the command starts.
double findEnd(const SimulateCommand& command, double start) {
    const double end = command.end ? *command.end : start + *command.duration;
    if (end > start) return end;
    throw Error(
        "SIMULATE",
        fmt::format("END is {}, but the time reached is {}; give a later time, or a DURATION", end, start));
}

// The output times of a command that starts at `start`.
void chooseTimes(const SimulateCommand& command, double start, SimulationOptions& options) {
    options.steps = isMoment(command) ? 0 : command.steps.value_or(1);
    options.outputStep = command.dtout;
    if (!isMoment(command)) options.end = findEnd(command, start);
}

// The elements of a kind in a range.
std::vector<ElementId> findElements(const Mechanism& mechanism, ElementKind kind, const IdRange& range) {
    std::vector<ElementId> found;
    const auto add = [&](const ElementId& id) {
        if (id.kind == kind && range.first <= id.number && id.number <= range.last) found.push_back(id);
    };
    for (const Element& element : mechanism.getElements()) add(element.id);
    for (const MechanismSensor& sensor : mechanism.getSensors()) add(sensor.id);
    return found;
}

void checkSwitched(const Mechanism& mechanism, const ActivateCommand& command, Diagnostics& diagnostics) {
    const char* const kind = getAdamsName(command.kind);
    for (const auto& [first, last] : command.ids) {
        if (!findElements(mechanism, command.kind, {first, last}).empty()) continue;
        if (first == last)
            diagnostics.push_back({Severity::Error, command.where,
                                   fmt::format("{}/{} does not exist in this model", kind, first)});
        else
            diagnostics.push_back({Severity::Warning, command.where,
                                   fmt::format("this model has no {} from {} to {}", kind, first, last)});
    }
}

class CommandRun {
public:
    CommandRun(const Mechanism& mechanism, const SimulationOptions& options, ResultSink& sink)
        : m_mechanism(mechanism),
          m_options(options),
          m_sink(sink),
          m_sensors(mechanism.getSensors().size(), SensorState::Armed) {}

    CommandsOutcome run(const std::vector<Command>& commands) {
        double time = 0;
        forEach(commands, [this](const Command& command) { requireElements(command); });
        forEach(commands, [&](const Command& command) { time = foresee(command, time); });
        forEach(commands, [this](const Command& command) {
            std::visit([this](const auto& c) { execute(c); }, command);
        });
        return std::move(m_outcome);
    }

private:
    // Up to the first that fails.
    template <class Do>
    void forEach(const std::vector<Command>& commands, const Do& doIt) {
        for (const Command& command : commands) {
            if (!m_outcome.failure.empty() || m_halted) return;
            m_outcome.where = std::visit([](const auto& c) { return c.where; }, command);
            try {
                doIt(command);
            } catch (const std::exception& exception) {
                m_outcome.failure = exception.what();
            }
        }
    }

    void requireElements(const Command& command) const {
        const auto* const activate = std::get_if<ActivateCommand>(&command);
        Diagnostics diagnostics;
        if (activate) checkSwitched(m_mechanism, *activate, diagnostics);
        if (hasErrors(diagnostics)) throw std::runtime_error(diagnostics.front().message);
    }

    // Where the command ends, given where it starts. Before a long run is the time to learn that an END is too early;
    // but where sensors may end commands, nobody knows.
    double foresee(const Command& command, double start) const {
        const auto* const simulate = std::get_if<SimulateCommand>(&command);
        const bool isKnown = simulate && !isMoment(*simulate) && m_mechanism.getSensors().empty();
        return isKnown ? findEnd(*simulate, start) : start;
    }

    void execute(const ActivateCommand& command) {
        for (const IdRange& range : command.ids)
            for (const ElementId& id : findElements(m_mechanism, command.kind, range)) {
                if (command.kind == ElementKind::Sensor)
                    switchSensor(id, command.active);
                else
                    switchElement(id, command.active);
            }
        m_switched = m_switched || command.kind != ElementKind::Sensor;
    }

    void execute(const SimulateCommand& command) {
        if (!m_state)
            start();
        else if (m_switched)
            m_state = reassemble(m_mechanism, *m_state).state;
        const double time = m_state->getTime() / m_mechanism.getUnits().time;
        SimulationOptions options = m_options;
        options.kind = getKind(command.analysis);
        options.sensors = m_sensors;
        chooseTimes(command, time, options);
        AssembledState initial;
        initial.state = *m_state;
        m_sink.continueWith(m_outcome.summaries.empty() || m_switched || isMoment(command));
        const SimulationOutcome outcome = simulate(m_mechanism, initial, options, m_sink);
        m_switched = false;
        m_state = outcome.finalState;
        m_sensors = outcome.sensors;
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

    // What has been switched off so far need not be met.
    void start() {
        const AssembledState initial = assemble(m_mechanism, m_switchedOff);
        m_outcome.yielded = initial.yielded;
        m_state = initial.state;
    }

    void switchElement(const ElementId& id, bool active) {
        const Element& element = m_mechanism.getElement(id);
        element.requireSwitchable();
        if (active)
            m_switchedOff.erase(id);
        else
            m_switchedOff.insert(id);
        if (!m_state) return;
        if (active)
            element.enable(*m_state);
        else
            element.disable(*m_state);
    }

    // One that is switched on is armed, whether it has fired before or not.
    void switchSensor(const ElementId& id, bool active) {
        const std::vector<MechanismSensor>& sensors = m_mechanism.getSensors();
        for (size_t k = 0; k < sensors.size(); ++k)
            if (sensors[k].id == id) m_sensors[k] = active ? SensorState::Armed : SensorState::Off;
    }

    const Mechanism& m_mechanism;
    const SimulationOptions& m_options;
    ContinuedSink m_sink;
    CommandsOutcome m_outcome;
    std::vector<SensorState> m_sensors;
    std::set<ElementId> m_switchedOff;
    std::optional<State> m_state;  // from the first SIMULATE on
    bool m_switched = false;
    bool m_halted = false;
};

}  // namespace

void checkCommands(const Mechanism& mechanism, const std::vector<Command>& commands,
                   Diagnostics& diagnostics) {
    bool simulates = false;
    for (const Command& command : commands)
        if (const auto* const activate = std::get_if<ActivateCommand>(&command))
            checkSwitched(mechanism, *activate, diagnostics);
        else
            simulates = true;
    if (!simulates)
        diagnostics.push_back(
            {Severity::Error, {}, "there is no SIMULATE command, so nothing would be simulated"});
}

CommandsOutcome runCommands(const Mechanism& mechanism, const std::vector<Command>& commands,
                            const SimulationOptions& options, ResultSink& sink) {
    return CommandRun(mechanism, options, sink).run(commands);
}

CommandsOutcome runCommands(const Mechanism& mechanism, const std::vector<Command>& commands,
                            const SimulationOptions& options) {
    Results results;
    ResultMemory memory(results);
    CommandsOutcome outcome = runCommands(mechanism, commands, options, memory);
    outcome.results = std::move(results);
    return outcome;
}

}  // namespace jprim
