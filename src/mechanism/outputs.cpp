// SPDX-License-Identifier: Apache-2.0
#include "mechanism/outputs.h"

#include "base/format.h"

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
    return functions;
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
                               s.halt || s.endsCommand});
        });
    }
    return sensors;
}

}  // namespace jprim
