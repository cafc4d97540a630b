// SPDX-License-Identifier: Apache-2.0
#include "dataset/commands/command_rules.h"

#include <cmath>

#include "base/format.h"
#include "dataset/element_kinds.h"
#include "dataset/fields.h"

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
    static const FieldTable<F> fields = {field(ArgumentRule("MODEL", Kind::Text).required(), &F::model),
                                         field({"OUTPUT_PREFIX", Kind::Text}, &F::output),
                                         ArgumentRule("COMMAND", Kind::Unsupported)};
    FileArguments names;
    const bool good = reader.readArguments(fields, names);
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

constexpr int LevelGroup = 1;
constexpr double MostSteps = 1e9;

const SpellingTable<Analysis>& getAnalyses() {
    using A = Analysis;
    static const SpellingTable<A> analyses = {{A::Dynamics, "DYNAMICS", 2},
                                              {A::Kinematics, "KINEMATICS"},
                                              {A::Statics, "STATICS", 3},
                                              {A::Transient, "TRANSIENT"},
                                              {A::InitialConditions, "INITIAL_CONDITIONS"}};
    return analyses;
}

const FieldTable<SimulateArguments>& getSimulateFields() {
    using S = SimulateCommand;
    using L = KinematicLevel;
    static const SpellingTable<L> levels = {
        {L::Position, "DISPLACEMENT", 2}, {L::Velocity, "VELOCITY"}, {L::Acceleration, "ACCELERATION"}};
    static const FieldTable<SimulateArguments> fields = {
        choice(getAnalyses(), &S::analysis, true),
        choice(levels, &S::level, false, LevelGroup),
        field({"END", Kind::Real}, &S::end),
        field({"DURATION", Kind::Real, 2}, &S::duration),
        field({"STEPS", Kind::Real, 3}, &SimulateArguments::count),
        field({"DTOUT", Kind::Real, 2}, &S::dtout)};
    return fields;
}

void checkPositive(StatementReader& reader, const char* name, const std::optional<double>& value) {
    if (value && !(*value > 0))
        reader.addError(reader.getOffset(name), fmt::format("{} of {} is {}; it must be larger than 0", name,
                                                            reader.getName(), *value));
}

void checkOneOf(StatementReader& reader, const char* name, const char* other) {
    reader.checkNotBoth(name, other);
    if (!reader.has(name) && !reader.has(other))
        reader.addError(0, fmt::format("{} needs {}= or {}=", reader.getName(), name, other));
}

// Which arguments go with the analysis.
void checkForm(StatementReader& reader, const SimulateArguments& s) {
    constexpr const char* timeNames[] = {"END", "DURATION", "STEPS", "DTOUT"};
    const bool initial = s.analysis == Analysis::InitialConditions;
    bool timed = s.analysis != Analysis::Statics && !initial;
    for (const char* name : timeNames) {
        reader.checkAllowed(name, !initial, "DYNAMICS, KINEMATICS, STATICS and TRANSIENT");
        timed = timed || (reader.has(name) && !initial);
    }
    for (const char* name : {"DISPLACEMENT", "VELOCITY", "ACCELERATION"})
        reader.checkAllowed(name, initial, "INITIAL_CONDITIONS");
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
    if (!reader.readArguments(getSimulateFields(), s)) return;
    checkForm(reader, s);
    checkPositive(reader, "END", s.end);
    checkPositive(reader, "DURATION", s.duration);
    checkPositive(reader, "DTOUT", s.dtout);
    understandSteps(reader, s);
    if (!reader.hasErrors()) commands.file.commands.emplace_back(static_cast<SimulateCommand>(s));
}

//------------------------------------------------------------------------------ ACTIVATE and DEACTIVATE
std::vector<Field<ActivateCommand>> unsupportedFields() {
    constexpr Word names[] = {{"BEAM", 2},     {"CLEARANCE", 2}, {"CONTACT", 3}, {"FIELD", 3},
                              {"FRICTION", 2}, {"NFORCE"},       {"PTCV"},       {"CVCV", 2}};
    std::vector<Field<ActivateCommand>> fields;
    for (const Word& word : names)
        fields.emplace_back(ArgumentRule(word.name, Kind::Unsupported, word.minimum));
    return fields;
}

const FieldTable<ActivateCommand>& getActivateFields() {
    using A = ActivateCommand;
    const Field<A> ids(ArgumentRule("ID", Kind::Id).of(1, NoLimit), [](A& a, const V& given) {
        for (const int id : given.ids) a.ids.push_back({id, id});
    });
    const Field<A> range(ArgumentRule("RANGE", Kind::Id).of(2), [](A& a, const V& given) {
        a.ids.push_back({given.ids[0], given.ids[1]});
    });
    static const FieldTable<A> fields = {choice(getElementKinds(), &A::kind, true), ids, range,
                                         unsupportedFields()};
    return fields;
}

void readSwitch(StatementReader& reader, CommandState& commands, bool active) {
    ActivateCommand command;
    command.where = reader.getPosition();
    command.active = active;
    if (!reader.readArguments(getActivateFields(), command)) return;
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

const char* getAdamsName(Analysis analysis) {
    return getAnalyses().getName(analysis).data();
}

}  // namespace jprim
