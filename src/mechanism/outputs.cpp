// SPDX-License-Identifier: Apache-2.0
#include "mechanism/outputs.h"

#include <algorithm>

#include "base/format.h"
#include "mechanism/control/control_variables.h"

namespace jprim {

using SimTK::Real;

FunctionContext makeFunctionContext(const Dataset& dataset, const UnitSystem& units, Reporter& reporter) {
    FunctionContext functions;
    functions.units = units;
    for (const MarkerStatement& marker : dataset.markers)
        if (marker.floating) functions.floatingMarkers.insert(marker.id);
    for (const SplineStatement& s : dataset.splines) {
        const std::string name = fmt::format("SPLINE/{}", s.id);
        reporter.attempt(name, s.where, [&] {
            std::vector<Real> z;
            std::vector<std::vector<Real>> curves;
            for (const auto& [parameter, values] : s.curves) {
                z.push_back(parameter);
                curves.push_back(values);
            }
            functions.splines.emplace(s.id, InterpolatingSpline(name, s.x, z, curves));
        });
    }
    for (const VariableStatement& s : dataset.variables) functions.variables[s.id] = &s;
    functions.control =
        planControl(dataset, [&reporter](const SourcePosition& where, const std::string& message) {
            reporter.addError(where, message);
        });
    return functions;
}

// The system takes the element over.
ControlVariables* addControlVariables(const ControlPlan& plan, MechanismContents& contents) {
    const bool evaluates =
        std::any_of(plan.evaluates.begin(), plan.evaluates.end(), [](bool e) { return e; });
    if (plan.states.empty() && !evaluates) return nullptr;
    std::vector<Real> initial;
    for (const PlannedState& state : plan.states) initial.push_back(state.initial);
    auto* variables =
        new ControlVariables(contents.forces, initial, int(plan.evaluates.size()), contents.units.time);
    SimTK::Force::Custom(contents.forces, variables);
    for (size_t k = 0; k < plan.states.size(); ++k) {
        const PlannedState& state = plan.states[k];
        if (!state.diff || !state.diff->implicit) continue;
        auto* rate =
            new ImplicitRate(contents.forces, state.name, state.diff->ic.size() > 1 ? state.diff->ic[1] : 0);
        SimTK::Force::Custom(contents.forces, rate);
        variables->setImplicitRate(k, rate);
    }
    return variables;
}

std::vector<MechanismState> makeStates(const ElementContext& context, Reporter& reporter) {
    std::vector<MechanismState> states;
    const ControlPlan& plan = context.functions.control;
    for (size_t k = 0; k < plan.states.size(); ++k) {
        const PlannedState& state = plan.states[k];
        reporter.attempt(state.name, state.where, [&] {
            if (state.diff && state.diff->implicit) {
                int unknown = -1;
                const Expression equation = context.write(
                    FunctionUse::Output, [&](FunctionWriter& w) { return w.equation(plan, k, unknown); });
                context.contents.control->getImplicitRate(k)->setEquation(equation, unknown);
            }
            const Expression rate =
                context.write(FunctionUse::Output, [&](FunctionWriter& w) { return w.rate(plan, k); });
            states.push_back(
                {state.name, ExpressionMeasure(context.contents.forces, rate), state.staticHold});
        });
    }
    return states;
}

void checkVariables(const ElementContext& context, Reporter& reporter) {
    for (const VariableStatement& s : context.dataset.variables)
        reporter.attempt(fmt::format("VARIABLE/{}", s.id), s.where, [&] {
            static_cast<void>(
                context.write(FunctionUse::Output, [&s](FunctionWriter& w) { return w.scalar(s.function); }));
        });
}

std::vector<MechanismRequest> makeRequests(const ElementContext& context, Reporter& reporter) {
    std::vector<MechanismRequest> requests;
    for (const RequestStatement& s : context.dataset.requests) {
        MechanismRequest request;
        request.id = s.id;
        request.type = s.type;
        request.resultsName = s.resultsName;
        request.cnames = s.cnames;
        for (const auto& [column, function] : s.expressions)
            reporter.attempt(fmt::format("REQUEST/{}", s.id), s.where,
                             [&, number = column, &text = function] {
                                 request.functions.emplace_back(number, context.makeMeasure(text));
                             });
        if (s.type != RequestType::Expressions) {
            request.I = context.getMarker(s.i);
            request.J = context.getMarker(s.j);
            request.rm = context.getMarker(s.rm);
        }
        if (s.type == RequestType::Force) request.loads = context.functions.elements.findLoads(s.i, s.j);
        requests.push_back(request);
    }
    return requests;
}

std::vector<MechanismSensor> makeSensors(const ElementContext& context, Reporter& reporter) {
    std::vector<MechanismSensor> sensors;
    for (const SensorStatement& s : context.dataset.sensors) {
        const ElementId id{ElementKind::Sensor, s.id};
        reporter.attempt(id.getText(), s.where, [&] {
            sensors.push_back({id, context.makeMeasure(s.function), s.value, s.error, s.comparison, s.halt,
                               s.halt || s.endsCommand, std::nullopt});
            if (s.evaluate) sensors.back().evaluate = context.makeMeasure(*s.evaluate);
        });
    }
    return sensors;
}

}  // namespace jprim
