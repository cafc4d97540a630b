// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "jprim/analysis/constraint_report.h"
#include "jprim/base/error.h"
#include "jprim/simulation/assemble.h"
#include "tool/commands.h"

namespace jprim::tool {

namespace {

struct CheckReport {
    Model model;
    ConstraintReport constraints;
    AssembledState assembled;
};

void printText(const CheckReport& r) {
    const UnitSystem& units = r.model.mechanism->getUnits();
    const std::string length = getLengthName(r.model.dataset);
    const auto printViolation = [&](const char* when, const Violation& v) {
        fmt::print("constraint error {:<8}{:.3g} {}, {:.3g} rad{}\n", when, v.length / units.length, length,
                   v.angle, v.element.empty() ? "" : fmt::format(" (at {})", v.element));
    };
    const Dataset& d = r.model.dataset;
    fmt::print("statements              {} built, {} ignored by rule\n", d.counts.built, d.counts.ignored);
    fmt::print("parts                   {} (ground included)\n", d.parts.size());
    if (!d.flexBodies.empty()) fmt::print("flexible bodies         {}\n", d.flexBodies.size());
    fmt::print("markers                 {}\n", d.markers.size());
    fmt::print("JPRIM                   {}\n", d.jprims.size());
    fmt::print("JOINT                   {}\n", d.joints.size());
    fmt::print("requests                {}\n", d.requests.size());
    fmt::print("Gruebler count          {}\n", r.constraints.getGrueblerCount());
    fmt::print("degrees of freedom      {}\n", r.constraints.getDegreesOfFreedom());
    fmt::print("redundant equations     {}\n", r.constraints.getNumRedundant());
    printViolation("given", r.assembled.before);
    printViolation("after", r.assembled.after);
    for (const MovedPart& part : r.assembled.moved)
        fmt::print("moved by assembly       {} by {:.3g} {} and {:.3g} rad\n", part.part,
                   part.distance / units.length, length, part.angle);
}

void printJson(const CheckReport& r) {
    const UnitSystem& units = r.model.mechanism->getUnits();
    const auto violation = [&units](const Violation& v) {
        return nlohmann::ordered_json{
            {"length", v.length / units.length}, {"angle", v.angle}, {"element", v.element}};
    };
    nlohmann::ordered_json moved = nlohmann::ordered_json::array();
    for (const MovedPart& part : r.assembled.moved)
        moved.push_back(
            {{"part", part.part}, {"distance", part.distance / units.length}, {"angle", part.angle}});
    const Dataset& d = r.model.dataset;
    const nlohmann::ordered_json json = {
        {"usable", true},
        {"statements",
         {{"built", d.counts.built}, {"ignored", d.counts.ignored}, {"errors", d.counts.errors}}},
        {"parts", d.parts.size()},
        {"flexible_bodies", d.flexBodies.size()},
        {"markers", d.markers.size()},
        {"jprims", d.jprims.size()},
        {"joints", d.joints.size()},
        {"requests", d.requests.size()},
        {"gruebler_count", r.constraints.getGrueblerCount()},
        {"degrees_of_freedom", r.constraints.getDegreesOfFreedom()},
        {"redundant_equations", r.constraints.getNumRedundant()},
        {"violation_given", violation(r.assembled.before)},
        {"violation_after_assembly", violation(r.assembled.after)},
        {"moved", moved}};
    fmt::print("{}\n", json.dump(2));
}

// What went to standard error as text, once more for machines.
ExitCode printUnusable(const CheckArguments& arguments, const Model& model, const std::string& failure) {
    if (!arguments.json) return DatasetHasErrors;
    nlohmann::ordered_json messages = nlohmann::ordered_json::array();
    for (const Diagnostic& diagnostic : model.diagnostics)
        messages.push_back({{"severity", diagnostic.severity == Severity::Error ? "error" : "warning"},
                            {"line", diagnostic.where.line},
                            {"column", diagnostic.where.column},
                            {"message", diagnostic.message}});
    if (!failure.empty())
        messages.push_back({{"severity", "error"}, {"line", 0}, {"column", 0}, {"message", failure}});
    const nlohmann::ordered_json json = {{"usable", false}, {"messages", messages}};
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return DatasetHasErrors;
}

}  // namespace

ExitCode check(const CheckArguments& arguments) {
    CheckReport report;
    report.model = loadModel(arguments.model);
    if (!report.model.mechanism) return printUnusable(arguments, report.model, "");
    try {
        report.assembled = assemble(*report.model.mechanism);
    } catch (const std::exception& error) {
        printError(arguments.model, error.what());
        return printUnusable(arguments, report.model, error.what());
    }
    report.constraints = analyzeConstraints(report.model.mechanism->getMatter(), report.assembled.state);
    if (arguments.json)
        printJson(report);
    else
        printText(report);
    return Done;
}

}  // namespace jprim::tool
