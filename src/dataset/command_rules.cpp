// SPDX-License-Identifier: Apache-2.0
#include "dataset/command_rules.h"

#include <cmath>

#include "base/format.h"
#include "dataset/body_arguments.h"
#include "dataset/connection_arguments.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using V = ArgumentValue;

//------------------------------------------------------------------------------------------------- FILE
struct FileArguments {
    std::string model;
    std::string output;
};

void readFile(StatementReader& reader, CommandState& commands) {
    using F = FileArguments;
    static const ArgumentTable<F> table = {
        {ArgumentRule("MODEL", Kind::Text).required(), [](F& f, const V& v) { f.model = v.text; }},
        {{"OUTPUT_PREFIX", Kind::Text}, [](F& f, const V& v) { f.output = v.text; }},
        {{"COMMAND", Kind::Unsupported}, nullptr}};
    FileArguments names;
    const bool good = reader.readArguments(table, names);
    if (good && names.model.empty()) reader.addError(reader.getOffset("MODEL"), "MODEL of FILE is empty");
    if (commands.modelLine != 0)
        reader.addError(0, fmt::format("the model is already named in line {}; a command file has one",
                                       commands.modelLine));
    else
        commands.modelLine = reader.getPosition().line;
    if (reader.hasErrors()) return;
    commands.file.model = names.model;
    commands.file.output = names.output;
}

//--------------------------------------------------------------------------------------------- SIMULATE
// The statement, with the number of steps not yet understood.
struct SimulateArguments : SimulateCommand {
    std::optional<double> count;
};

constexpr std::size_t FirstLevelRow = 5;
constexpr int LevelGroup = 1;
constexpr double MostSteps = 1e9;

const ArgumentTable<SimulateArguments>& getSimulateTable() {
    using S = SimulateArguments;
    const auto setAnalysis = [](S& s, const V& v) { s.analysis = static_cast<Analysis>(v.row); };
    const auto setLevel = [](S& s, const V& v) { s.level = static_cast<MotionLevel>(v.row - FirstLevelRow); };
    const auto analysis = [](std::string_view name, std::size_t minimum) {
        return ArgumentRule(name, Kind::Choice, minimum).required();
    };
    static const ArgumentTable<S> table = {
        // In the order of Analysis, then of MotionLevel.
        {analysis("DYNAMICS", 2), setAnalysis},
        {analysis("KINEMATICS", 1), setAnalysis},
        {analysis("STATICS", 3), setAnalysis},
        {analysis("TRANSIENT", 1), setAnalysis},
        {analysis("INITIAL_CONDITIONS", 1), setAnalysis},
        {ArgumentRule("DISPLACEMENT", Kind::Choice, 2).in(LevelGroup), setLevel},
        {ArgumentRule("VELOCITY", Kind::Choice).in(LevelGroup), setLevel},
        {ArgumentRule("ACCELERATION", Kind::Choice).in(LevelGroup), setLevel},
        {{"END", Kind::Real}, [](S& s, const V& v) { s.end = v.getNumber(); }},
        {{"DURATION", Kind::Real, 2}, [](S& s, const V& v) { s.duration = v.getNumber(); }},
        {{"STEPS", Kind::Real, 3}, [](S& s, const V& v) { s.count = v.getNumber(); }},
        {{"DTOUT", Kind::Real, 2}, [](S& s, const V& v) { s.dtout = v.getNumber(); }}};
    return table;
}

void checkPositive(StatementReader& reader, const char* name, const std::optional<double>& value) {
    if (value && !(*value > 0))
        reader.addError(reader.getOffset(name), fmt::format("{} of {} is {}; it must be larger than 0", name,
                                                            reader.getName(), *value));
}

void checkOneOf(StatementReader& reader, const char* name, const char* other) {
    checkNotBoth(reader, name, other);
    if (!reader.has(name) && !reader.has(other))
        reader.addError(0, fmt::format("{} needs {}= or {}=", reader.getName(), name, other));
}

// Which arguments go with the analysis.
void checkForm(StatementReader& reader, const SimulateArguments& s) {
    constexpr const char* timeNames[] = {"END", "DURATION", "STEPS", "DTOUT"};
    const bool initial = s.analysis == Analysis::InitialConditions;
    bool timed = s.analysis != Analysis::Statics && !initial;
    for (const char* name : timeNames) {
        checkAllowed(reader, name, !initial, "DYNAMICS, KINEMATICS, STATICS and TRANSIENT");
        timed = timed || (reader.has(name) && !initial);
    }
    for (const char* name : {"DISPLACEMENT", "VELOCITY", "ACCELERATION"})
        checkAllowed(reader, name, initial, "INITIAL_CONDITIONS");
    if (!timed) return;
    checkOneOf(reader, "END", "DURATION");
    checkOneOf(reader, "STEPS", "DTOUT");
}

void understandSteps(StatementReader& reader, SimulateArguments& s) {
    if (!s.count) return;
    if (*s.count >= 1 && *s.count <= MostSteps && *s.count == std::floor(*s.count))
        s.steps = static_cast<int>(*s.count);
    else
        reader.addError(reader.getOffset("STEPS"),
                        fmt::format("STEPS of {} is {}; write a whole number from 1 to {}", reader.getName(),
                                    *s.count, MostSteps));
}

void readSimulate(StatementReader& reader, CommandState& commands) {
    SimulateArguments s;
    s.where = reader.getPosition();
    if (!reader.readArguments(getSimulateTable(), s)) return;
    checkForm(reader, s);
    checkPositive(reader, "END", s.end);
    checkPositive(reader, "DURATION", s.duration);
    checkPositive(reader, "DTOUT", s.dtout);
    understandSteps(reader, s);
    if (!reader.hasErrors()) commands.file.commands.emplace_back(static_cast<SimulateCommand>(s));
}

//------------------------------------------------------------------------------ ACTIVATE and DEACTIVATE
const ArgumentTable<ActivateCommand>& getActivateTable() {
    using A = ActivateCommand;
    const auto setKind = [](A& a, const V& v) { a.kind = static_cast<ElementKind>(v.row); };
    const auto kind = [](std::string_view name, std::size_t minimum) {
        return ArgumentRule(name, Kind::Choice, minimum).required();
    };
    static const ArgumentTable<A> table = {// In the order of ElementKind.
                                           {kind("JPRIM", 2), setKind},
                                           {kind("JOINT", 1), setKind},
                                           {kind("GCON", 2), setKind},
                                           {kind("MOTION", 1), setKind},
                                           {kind("SENSOR", 2), setKind},
                                           {ArgumentRule("ID", Kind::Id).of(1, NoLimit),
                                            [](A& a, const V& v) {
                                                for (const int id : v.ids) a.ids.push_back({id, id});
                                            }},
                                           {ArgumentRule("RANGE", Kind::Id).of(2),
                                            [](A& a, const V& v) {
                                                a.ids.push_back({v.ids[0], v.ids[1]});
                                            }},
                                           {{"BEAM", Kind::Unsupported, 2}, nullptr},
                                           {{"BUSHING", Kind::Unsupported, 2}, nullptr},
                                           {{"CLEARANCE", Kind::Unsupported, 2}, nullptr},
                                           {{"CONTACT", Kind::Unsupported, 3}, nullptr},
                                           {{"COUPLER", Kind::Unsupported, 3}, nullptr},
                                           {{"FIELD", Kind::Unsupported, 3}, nullptr},
                                           {{"FRICTION", Kind::Unsupported, 2}, nullptr},
                                           {{"GFORCE", Kind::Unsupported, 2}, nullptr},
                                           {{"NFORCE", Kind::Unsupported}, nullptr},
                                           {{"PTCV", Kind::Unsupported}, nullptr},
                                           {{"CVCV", Kind::Unsupported, 2}, nullptr},
                                           {{"SFORCE", Kind::Unsupported, 2}, nullptr},
                                           {{"SPRINGDAMPER", Kind::Unsupported, 2}, nullptr},
                                           {{"VFORCE", Kind::Unsupported, 2}, nullptr},
                                           {{"VTORQUE", Kind::Unsupported, 2}, nullptr}};
    return table;
}

void readSwitch(StatementReader& reader, CommandState& commands, bool active) {
    ActivateCommand command;
    command.where = reader.getPosition();
    command.active = active;
    if (!reader.readArguments(getActivateTable(), command)) return;
    if (command.ids.empty()) reader.addError(0, fmt::format("{} needs ID= or RANGE=", reader.getName()));
    for (const IdRange& range : command.ids)
        if (range.first > range.last)
            reader.addError(reader.getOffset("RANGE"),
                            fmt::format("RANGE of {} goes from {} down to {}; write the smaller id first",
                                        reader.getName(), range.first, range.last));
    if (!reader.hasErrors()) commands.file.commands.emplace_back(std::move(command));
}

void readActivate(StatementReader& reader, CommandState& commands) {
    readSwitch(reader, commands, true);
}

void readDeactivate(StatementReader& reader, CommandState& commands) {
    readSwitch(reader, commands, false);
}

}  // namespace

const std::vector<CommandRule>& getCommandRules() {
    static const std::vector<CommandRule> rules = {{"FILE", 3, readFile},
                                                   {"SIMULATE", 2, readSimulate},
                                                   {"ACTIVATE", 3, readActivate},
                                                   {"DEACTIVATE", 3, readDeactivate}};
    return rules;
}

const char* getAdamsName(ElementKind kind) {
    constexpr const char* names[] = {"JPRIM", "JOINT", "GCON", "MOTION", "SENSOR"};
    return names[static_cast<std::size_t>(kind)];
}

const char* getAdamsName(Analysis analysis) {
    constexpr const char* names[] = {"DYNAMICS", "KINEMATICS", "STATICS", "TRANSIENT", "INITIAL_CONDITIONS"};
    return names[static_cast<std::size_t>(analysis)];
}

}  // namespace jprim
