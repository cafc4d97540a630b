// SPDX-License-Identifier: Apache-2.0
#include "jprim/mechanism/find_mistakes.h"

#include <set>

#include "base/format.h"
#include "base/sort_diagnostics.h"
#include "jprim/base/error.h"
#include "mechanism/elements/elements.h"
#include "mechanism/frames.h"
#include "mechanism/function_writer.h"
#include "mechanism/load_modes.h"

namespace jprim {
namespace {

// The statements with this keyword that have errors.
std::set<int> findFaultyIds(const Dataset& dataset, const char* keyword) {
    const auto found = dataset.faulty.find(keyword);
    return found == dataset.faulty.end() ? std::set<int>() : found->second;
}

// Looks at all that buildMechanism() finds without mechanics, in the same order, so that functions know the same elements.
class MistakeSearch {
public:
    MistakeSearch(const Dataset& dataset, Diagnostics& diagnostics)
        : m_dataset(dataset), m_diagnostics(diagnostics) {
        for (const MarkerStatement& marker : dataset.markers) m_markers.insert(marker.id);
        for (const int id : findFaultyIds(dataset, "MARKER")) m_markers.insert(id);
        for (const MarkerStatement& marker : dataset.markers)
            if (marker.floating) m_functions.floatingMarkers.insert(marker.id);
    }

    void run() {
        checkModes();
        checkFrames();
        prepareFunctions();
        addLoads(ElementKind::Jprim, m_dataset.jprims);
        addLoads(ElementKind::Joint, m_dataset.joints);
        checkElements(ElementKind::Gcon, m_dataset.gcons, FunctionUse::Equation);
        checkElements(ElementKind::Motion, m_dataset.motions, FunctionUse::OfTime);
        checkForces();
        addFaultyLoads();
        checkFunctions("VARIABLE", m_dataset.variables, FunctionUse::Output);
        checkFunctions("DIFF", m_dataset.diffs, FunctionUse::Output);
        for (const RequestStatement& request : m_dataset.requests)
            for (const auto& [number, function] : request.expressions)
                check(fmt::format("REQUEST/{}", request.id), function, FunctionUse::Output);
        checkFunctions("SENSOR", m_dataset.sensors, FunctionUse::Output);
        for (const SensorStatement& sensor : m_dataset.sensors)
            if (sensor.evaluate)
                check(fmt::format("SENSOR/{}", sensor.id), *sensor.evaluate, FunctionUse::Output);
    }

private:
    void report(const SourcePosition& where, const std::string& message) {
        m_diagnostics.push_back({Severity::Error, where, message});
    }

    void checkModes() {
        const ModesOfBodies modes = loadModes(
            m_dataset, [this](const SourcePosition& w, const std::string& message) { report(w, message); });
        for (const MarkerStatement& marker : m_dataset.markers) {
            const auto body = modes.find(marker.flexBody);
            if (body == modes.end() || marker.node == 0) continue;
            try {
                body->second.getNode(marker.node);
            } catch (const Error& error) {
                report(marker.where, fmt::format("MARKER/{}: {}", marker.id, error.what()));
            }
        }
    }

    void checkFrame(const std::string& name, const SourcePosition& where, const FrameStatement& frame) {
        std::string problem;
        makeFrame(frame, 1, problem);
        if (!problem.empty()) report(where, name + ": " + problem);
    }

    void checkFrames() {
        const auto checkBodies = [this](const char* keyword, const auto& bodies) {
            for (const auto& b : bodies)
                checkFrame(fmt::format("{}/{}", keyword, b.id), b.where, {b.qg, b.reuler, b.zg, b.xg});
        };
        checkBodies("PART", m_dataset.parts);
        checkBodies("POINT_MASS", m_dataset.pointMasses);
        checkBodies("FLEX_BODY", m_dataset.flexBodies);
        for (const MarkerStatement& m : m_dataset.markers)
            if (m.qp || m.node == 0)
                checkFrame(fmt::format("MARKER/{}", m.id), m.where, {m.qp, m.reuler, m.zp, m.xp, m.usexp});
    }

    // In place of what has errors stands something that may be used in every function.
    void prepareFunctions() {
        m_anyVariable.function.text = "TIME";
        for (const int id : findFaultyIds(m_dataset, "VARIABLE")) m_functions.variables[id] = &m_anyVariable;
        for (const VariableStatement& variable : m_dataset.variables)
            m_functions.variables[variable.id] = &variable;
        const std::vector<double> x = {0, 1, 2, 3};
        const InterpolatingSpline any("", x, {0}, {x});
        for (const int id : findFaultyIds(m_dataset, "SPLINE")) m_functions.splines.emplace(id, any);
        for (const SplineStatement& spline : m_dataset.splines) m_functions.splines.emplace(spline.id, any);
        m_functions.control = planControl(
            m_dataset, [this](const SourcePosition& w, const std::string& message) { report(w, message); });
    }

    void addFaultyLoads() {
        for (const auto& [keyword, ids] : m_dataset.faulty)
            if (const std::optional<ElementKind> kind = findElementKind(keyword))
                for (const int id : ids) m_functions.addUnknownLoad({*kind, id});
    }

    template <class Statements>
    void addLoads(ElementKind kind, const Statements& statements) {
        for (const auto& s : statements) m_functions.addUnknownLoad({kind, s.id});
    }

    template <class Statements>
    void checkFunctions(const char* keyword, const Statements& statements, FunctionUse use) {
        for (const auto& s : statements) check(fmt::format("{}/{}", keyword, s.id), s.function, use);
    }

    template <class Statements>
    void checkElements(ElementKind kind, const Statements& statements, FunctionUse use) {
        checkFunctions(getAdamsName(kind), statements, use);
        addLoads(kind, statements);
    }

    void checkForces() {
        checkElements(ElementKind::Sforce, m_dataset.sforces, FunctionUse::Force);
        for (const VectorForceStatement& force : m_dataset.vectorForces) {
            const ElementId id = getElementId(force);
            const std::string name = id.getText();
            for (const auto& component : force.components)
                if (component) check(name, *component, FunctionUse::Force);
            for (const auto& vector : {force.fxyz, force.txyz})
                if (vector) check(name, *vector, FunctionUse::Force, true);
            m_functions.addUnknownLoad(id);
        }
        addLoads(ElementKind::Springdamper, m_dataset.springdampers);
        addLoads(ElementKind::Bushing, m_dataset.bushings);
    }

    void check(const std::string& name, const ExpressionText& function, FunctionUse use,
               bool isVector = false) {
        const MarkerFrames::FindMarker find = [this](int id) {
            const bool isFixed = m_markers.count(id) > 0 && m_functions.floatingMarkers.count(id) == 0;
            return isFixed ? &m_anyMarker : nullptr;
        };
        try {
            FunctionWriter writer(find, m_functions, use);
            isVector ? writer.vector(function) : writer.scalar(function);
        } catch (const FunctionError& error) {
            report(error.where, name + ": " + error.what());
        }
    }

    const Dataset& m_dataset;
    Diagnostics& m_diagnostics;
    FunctionContext m_functions;
    std::set<int> m_markers;
    const Marker m_anyMarker;
    VariableStatement m_anyVariable;
};

}  // namespace

void findMistakes(const Dataset& dataset, Diagnostics& diagnostics) {
    MistakeSearch(dataset, diagnostics).run();
    sortByPosition(0, diagnostics);
}

}  // namespace jprim
