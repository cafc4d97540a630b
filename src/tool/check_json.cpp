// SPDX-License-Identifier: Apache-2.0
// What formatText() says, for machines. Angles are in radians, lengths in the dataset's unit.
#include <nlohmann/json.hpp>

#include "base/format.h"
#include "tool/check_report.h"

namespace jprim::tool {

using Json = nlohmann::ordered_json;
using SimTK::Real;

namespace {

Json makeViolation(const Violation& v, const UnitSystem& units) {
    return {{"length", v.length / units.length}, {"angle", v.angle}, {"element", v.element}};
}

const char* getUnitWord(Dimension dimension) {
    return dimension == Dimension::Length ? "length" : "rad";
}

Json makeMissed(const std::vector<MissedCoordinate>& missed, const UnitSystem& units) {
    Json list = Json::array();
    for (const MissedCoordinate& m : missed)
        list.push_back({{"element", m.element},
                        {"coordinate", m.coordinate},
                        {"amount", m.amount / units.getDisplacement(m.dimension)},
                        {"unit", getUnitWord(m.dimension)}});
    return list;
}

Json makeEquation(const ConstraintEquation& equation) {
    return {{"element", equation.element},
            {"equation", equation.words},
            {"level", getEquationKind(equation.level)}};
}

// Those of reading and building, then why it cannot be assembled.
Json makeMessages(const CheckReport& report) {
    Json messages = Json::array();
    for (const Diagnostic& diagnostic : report.model.diagnostics)
        messages.push_back({{"severity", diagnostic.severity == Severity::Error ? "error" : "warning"},
                            {"line", diagnostic.where.line},
                            {"column", diagnostic.where.column},
                            {"message", diagnostic.message}});
    if (report.failure)
        messages.push_back(
            {{"severity", "error"}, {"line", 0}, {"column", 0}, {"message", report.failure->message}});
    return messages;
}

void addCounts(const CheckReport& report, Json& json) {
    const Dataset& d = report.model.dataset;
    json["statements"] = {
        {"built", d.counts.built}, {"ignored", d.counts.ignored}, {"errors", d.counts.errors}};
    json["parts"] = d.parts.size();
    json["flexible_bodies"] = d.flexBodies.size();
    json["markers"] = d.markers.size();
    json["jprims"] = d.jprims.size();
    json["joints"] = d.joints.size();
    json["elements"] = Json::object();
    for (const auto& [kind, types] : report.elements) json["elements"][kind] = types;
    json["requests"] = d.requests.size();
}

void addTree(const TreeReport& tree, Json& json) {
    json["tree"] = Json::array();
    for (const TreeReport::Branch& branch : tree.branches)
        json["tree"].push_back({{"part", branch.part},
                                {"parent", branch.parent},
                                {"mobilizer", branch.mobilizer},
                                {"elements", branch.elements}});
    json["solved_as_equations"] = tree.equations;
}

void addFreedoms(const ConstraintReport& c, Json& json) {
    json["degrees_of_freedom"] = c.getDegreesOfFreedom();
    json["redundant_equations"] = c.getNumRedundant();
    json["rank_decided_between"] = {c.smallestKept, c.largestDropped};
    json["singular_position"] = c.isSingularPosition();
    json["degrees_of_freedom_nearby"] = c.freedomsNearby;
    Json redundant = Json::array();
    for (const RedundantEquation& r : c.redundant) {
        Json entry = makeEquation(c.equations[size_t(r.equation)]);
        entry["only_here"] = r.onlyHere;
        entry["follows_from"] = Json::array();
        for (const int k : r.dependsOn) entry["follows_from"].push_back(makeEquation(c.equations[size_t(k)]));
        redundant.push_back(entry);
    }
    json["redundant"] = redundant;
}

void addAssembly(const AssembledState& assembled, const UnitSystem& units, Json& json) {
    json["violation_after_assembly"] = makeViolation(assembled.after, units);
    json["yielded"] = makeMissed(assembled.yielded, units);
    json["moved"] = Json::array();
    for (const MovedPart& part : assembled.moved)
        json["moved"].push_back(
            {{"part", part.part}, {"distance", part.distance / units.length}, {"angle", part.angle}});
}

void addFailure(const AssemblyFailure& failure, const UnitSystem& units, Json& json) {
    json["least_violation"] = makeViolation(failure.left, units);
    json["missed"] = makeMissed(failure.missed, units);
    json["conflicts"] = Json::array();
    for (const Conflict& conflict : failure.conflicts.conflicts) {
        Json equations = Json::array();
        for (size_t k = 0; k < conflict.equations.size(); ++k) {
            const ConstraintEquation& equation = failure.conflicts.equations[size_t(conflict.equations[k])];
            Json entry = makeEquation(equation);
            entry["error"] = conflict.errors[k] / units.getDisplacement(equation.dimension);
            entry["unit"] = getUnitWord(equation.dimension);
            equations.push_back(entry);
        }
        json["conflicts"].push_back(equations);
    }
    json["flipped"] = Json::array();
    for (const FlippedAxes& axes : failure.flipped)
        json["flipped"].push_back({{"element", axes.element}, {"axes", axes.axes}, {"angle", axes.angle}});
}

}  // namespace

void printJson(const CheckReport& report) {
    Json json = {{"usable", report.isUsable()}};
    if (!report.isUsable()) json["messages"] = makeMessages(report);
    if (report.model.mechanism) {
        const UnitSystem& units = report.model.mechanism->getUnits();
        addCounts(report, json);
        if (report.tree) addTree(*report.tree, json);
        json["equations"] = report.constraints.numEquations;
        json["gruebler_count"] = report.constraints.getGrueblerCount();
        if (report.assembled) addFreedoms(report.constraints, json);
        json["violation_given"] = makeViolation(report.given, units);
        if (report.assembled) addAssembly(*report.assembled, units, json);
        if (report.failure) addFailure(*report.failure, units, json);
    }
    // Names and messages repeat the dataset's bytes, which need not be UTF-8.
    fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

}  // namespace jprim::tool
