// SPDX-License-Identifier: Apache-2.0
// The part of MechanismBuilder that makes what is only looked at: functions, requests, sensors.
#include "base/format.h"
#include "build/mechanism_builder.h"

namespace jprim {

using SimTK::Real;

// Mistakes in a variable or spline are reported here, at its statement; every function that uses it fails too.
void MechanismBuilder::prepareFunctions() {
    m_functions.units = m_mechanism.m_units;
    for (const SplineStatement& s : m_dataset.splines) {
        const std::string name = fmt::format("SPLINE/{}", s.id);
        attempt(name, s.where, [&] {
            std::vector<Real> z;
            std::vector<std::vector<Real>> curves;
            for (const auto& [parameter, values] : s.curves) {
                z.push_back(parameter);
                curves.push_back(values);
            }
            m_functions.splines.emplace(s.id, InterpolatingSpline(name, s.x, z, curves));
        });
    }
    for (const VariableStatement& s : m_dataset.variables) m_functions.variables[s.id] = &s;
}

// Variables that nothing uses are checked as well; loads of elements are known by then.
void MechanismBuilder::checkVariables() {
    for (const VariableStatement& s : m_dataset.variables)
        attempt(fmt::format("VARIABLE/{}", s.id), s.where, [&] {
            write(FunctionUse::Output, [&s](FunctionWriter& w) { return w.scalar(s.function); });
        });
}

void MechanismBuilder::addLoadElement(const LoadElement& element) {
    m_mechanism.m_loadElements.push_back(element);
    m_functions.elements.push_back(element);
}

ExpressionMeasure MechanismBuilder::makeMeasure(const ExpressionText& function) {
    const Expression f =
        write(FunctionUse::Output, [&function](FunctionWriter& w) { return w.scalar(function); });
    return ExpressionMeasure(m_mechanism.m_bodies->forces, f);
}

void MechanismBuilder::addRequests() {
    for (const RequestStatement& s : m_dataset.requests) {
        MechanismRequest request;
        request.id = s.id;
        request.type = s.type;
        request.resultsName = s.resultsName;
        request.cnames = s.cnames;
        for (const auto& [column, function] : s.expressions)
            attempt(fmt::format("REQUEST/{}", s.id), s.where, [&, number = column, &text = function] {
                request.functions.emplace_back(number, makeMeasure(text));
            });
        if (s.type != RequestType::Expressions) {
            request.I = m_mechanism.getMarker(s.i);
            request.J = m_mechanism.getMarker(s.j);
            request.rm = m_mechanism.getMarker(s.rm);
        }
        if (s.type == RequestType::Force)
            for (const LoadElement& element : m_mechanism.m_loadElements) {
                if (element.i == s.i && element.j == s.j) request.loads.push_back(element.onI);
                if (element.j == s.i && element.i == s.j && element.onJ) request.loads.push_back(element.onJ);
            }
        m_mechanism.m_requests.push_back(request);
    }
}

void MechanismBuilder::addSensors() {
    for (const SensorStatement& s : m_dataset.sensors) {
        const std::string name = fmt::format("SENSOR/{}", s.id);
        attempt(name, s.where, [&] {
            m_mechanism.m_sensors.push_back({name, makeMeasure(s.function), s.value, s.error, s.comparison,
                                             s.halt, s.halt || s.endsCommand});
        });
    }
}

}  // namespace jprim
