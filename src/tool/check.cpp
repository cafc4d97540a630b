// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <utility>

#include "base/format.h"
#include "simulation/equation_access.h"
#include "tool/check_report.h"

namespace jprim::tool {

using SimTK::Stage;
using SimTK::State;

namespace {

void countElements(CheckReport& report) {
    for (const Element& element : report.model.mechanism->getElements())
        if (!element.isForce()) ++report.elements[getAdamsName(element.id.kind)][element.type];
}

State getGivenState(const Mechanism& mechanism) {
    State state = mechanism.makeGivenState();
    mechanism.getSystem().realize(state, Stage::Position);
    return state;
}

AssemblyFailure diagnoseFailure(const Mechanism& mechanism, const State& given, const std::exception& error) {
    const ElementNames names = mechanism.getElementNames();
    AssemblyFailure failure{error.what(), findConflicts(mechanism.getMatter(), given, names), {}, {}, {}};
    const auto* assembly = dynamic_cast<const AssemblyError*>(&error);
    if (assembly) failure.missed = assembly->getMissed();
    const State nearest = failure.missed.empty() ? failure.conflicts.state : assembly->getNearest();
    mechanism.getSystem().realize(nearest, Stage::Position);
    failure.left = calcViolation(mechanism, nearest);
    failure.flipped = findFlippedAxes(mechanism.getMatter(), nearest, names);
    return failure;
}

// Fills in everything that follows from the model.
void diagnose(CheckReport& report) {
    const Mechanism& mechanism = *report.model.mechanism;
    countElements(report);
    const State given = getGivenState(mechanism);
    report.given = calcViolation(mechanism, given);
    try {
        report.assembled = assemble(mechanism);
        State all = report.assembled->state;
        restoreDroppedEquations(mechanism, all);
        mechanism.getSystem().realize(all, Stage::Position);
        report.constraints = analyzeConstraints(mechanism.getMatter(), all, mechanism.getElementNames());
    } catch (const std::exception& error) {
        report.failure = diagnoseFailure(mechanism, given, error);
        report.constraints.numMobilities = given.getNU();
        report.constraints.numEquations = int(findEquations(mechanism.getMatter(), given).size());
    }
}

TreeReport makeTree(const Dataset& dataset) {
    Diagnostics known;  // those of the mechanism with all equations are the same
    const std::optional<Mechanism> mechanism = buildMechanism(dataset, known, {Formulation::Tree});
    TreeReport tree;
    if (!mechanism) return tree;
    const std::vector<MechanismPart>& parts = mechanism->getParts();
    for (const MechanismPart& part : parts) {
        if (part.ground) continue;
        const Attachment& a = part.attachment;
        const std::string parent = a.parent < 0 ? "ground" : parts[size_t(a.parent)].name;
        std::vector<std::string> elements;
        for (const ElementId& id : a.elements) elements.push_back(id.getText());
        tree.branches.push_back({part.name, parent, a.mobilizer, elements});
    }
    for (const Element& element : mechanism->getElements())
        if (!element.type.empty() && !element.inTree)
            tree.equations.push_back(element.getName() + " " + element.type);
    return tree;
}

}  // namespace

CheckReport makeCheckReport(Model model, Formulation formulation) {
    CheckReport report;
    report.model = std::move(model);
    if (!report.model.mechanism) return report;
    diagnose(report);
    if (formulation == Formulation::Tree) report.tree = makeTree(report.model.dataset);
    return report;
}

ExitCode check(const CheckArguments& arguments) {
    const CheckReport report =
        makeCheckReport(loadModel(arguments.model, Formulation::Constraints), arguments.formulation);
    if (report.failure) printError(arguments.model, report.failure->message);
    if (report.assembled)
        for (const Diagnostic& yielded : listYielded(*report.model.mechanism, report.assembled->yielded))
            fmt::print(stderr, "{}\n", formatDiagnostic(arguments.model, yielded));
    if (arguments.json)
        printJson(report);
    else if (report.model.mechanism)
        for (const std::string& line : formatText(report)) fmt::print("{}\n", line);
    return report.isUsable() ? Done : DatasetHasErrors;
}

}  // namespace jprim::tool
