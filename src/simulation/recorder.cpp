// SPDX-License-Identifier: Apache-2.0
#include "simulation/recorder.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "jprim/marker/angles.h"

namespace jprim {

using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

namespace {

double* put(const Vec3& v, double* out) {
    for (int k = 0; k < 3; ++k) *out++ = v[k];
    return out;
}

double* putWithMagnitude(const Vec3& v, double* out) {
    *out++ = v.norm();
    return put(v, out);
}

// [linear, angular], each led by its magnitude, in the axes of a marker.
void putInAxes(const SpatialVec& inGround, const State& state, const Marker& axes, double* out) {
    const Rotation R_GR = axes.findPoseInGround(state).R();
    out = putWithMagnitude(~R_GR * inGround[1], out);
    putWithMagnitude(~R_GR * inGround[0], out);
}

}  // namespace

Recorder::Units::Units(const UnitSystem& u)
    : time{"time", u.time},
      length{"length", u.length},
      velocity{"length/time", u.getVelocity()},
      acceleration{"length/time^2", u.getAcceleration()},
      angle{"rad", 1},
      angularVelocity{"rad/time", u.getAngularVelocity()},
      angularAcceleration{"rad/time^2", u.getAngularAcceleration()},
      force{"force", u.force},
      moment{"force length", u.getMoment()} {}

Recorder::Recorder(const Mechanism& mechanism, ResultSink& sink)
    : m_mechanism(mechanism), m_sink(sink), m_units(mechanism.getUnits()) {
    for (const Table* table : {&m_requests, &m_reactions, &m_parts})
        addGroup(*table, "", "", {{"time", m_units.time}},
                 [](const State& s, double* out) { *out = s.getTime(); });
    addRequests();
    for (const Element& element : m_mechanism.getElements()) addReactions(element);
    for (const MechanismPart& part : m_mechanism.getParts()) {
        if (part.ground) continue;
        addPart(part);
        addModes(part);
    }
    addEnergy();
    addErrors();
    m_signs = EulerSigns(m_columns.parts);
    m_sink.begin(m_columns);
}

void Recorder::addGroup(const Table& table, const std::string& element, const std::string& prefix,
                        const std::vector<Column>& columns,
                        std::function<void(const State&, double*)> calcInSI) {
    Group group{table, table.row.size(), {}, std::move(calcInSI), {}};
    for (const Column& column : columns) {
        table.columns.push_back(prefix + column.name);
        table.row.push_back(0);
        table.descriptions.push_back({table.columns.back(), column.unit.dimension, element});
        group.unitsInSI.push_back(column.unit.inSI);
    }
    m_groups.push_back(std::move(group));
}

void Recorder::record(const State& state, const Violation& violation) {
    m_violation = violation;
    for (Group& group : m_groups) {
        double* const values = group.table.row.data() + group.first;
        group.calcInSI(state, values);
        for (size_t k = 0; k < group.unitsInSI.size(); ++k) values[k] /= group.unitsInSI[k];
        watch(group);
    }
    m_signs.makeContinuous(m_row.parts);
    m_sink.add(m_row);
}

// Once for each request: one value that is none mostly brings others.
void Recorder::watch(Group& group) {
    if (group.request.empty()) return;
    const std::vector<double>& row = group.table.row;
    for (size_t k = group.first; k < group.first + group.unitsInSI.size(); ++k) {
        if (std::isfinite(row[k])) continue;
        m_notFinite.push_back({group.request, group.table.columns[k], row[k], row[0]});
        group.request.clear();
        return;
    }
}

//-------------------------------------------------------------------------------------------- requests
namespace {

void calcDisplacement(const MechanismRequest& r, const State& s, double* out) {
    const Transform X_GI = r.I.findPoseInGround(s), X_GJ = r.J.findPoseInGround(s);
    out = putWithMagnitude(~r.rm.findPoseInGround(s).R() * (X_GI.p() - X_GJ.p()), out);
    put(calcAngles313(~X_GJ.R() * X_GI.R()), out);
}

void calcVelocity(const MechanismRequest& r, const State& s, double* out) {
    putInAxes(r.I.findVelocityInGround(s) - r.J.findVelocityInGround(s), s, r.rm, out);
}

void calcAcceleration(const MechanismRequest& r, const State& s, double* out) {
    putInAxes(r.I.findAccelerationInGround(s) - r.J.findAccelerationInGround(s), s, r.rm, out);
}

void calcForce(const MechanismRequest& r, const State& s, double* out) {
    SpatialVec sum(Vec3(0), Vec3(0));
    for (const LoadFunction& load : r.loads) sum += load(s);
    putInAxes(sum, s, r.rm, out);
}

// In the dataset's units already.
void calcFunctions(const MechanismRequest& r, const State& s, double* out) {
    for (const auto& [number, function] : r.functions) *out++ = function.calcValue(s);
}

// Of each component that the request has, its number and its name where the dataset gives none.
std::vector<std::pair<int, std::string>> listComponents(const MechanismRequest& request) {
    std::vector<std::pair<int, std::string>> components;
    const auto add = [&components](std::initializer_list<const char*> names) {
        int number = 0;
        for (const char* name : names)
            if (++number; *name) components.emplace_back(number, name);
    };
    switch (request.type) {
        case RequestType::Displacement: add({"MAG", "X", "Y", "Z", "", "PSI", "THETA", "PHI"}); break;
        case RequestType::Velocity: add({"VM", "VX", "VY", "VZ", "WM", "WX", "WY", "WZ"}); break;
        case RequestType::Acceleration:
            add({"ACCM", "ACCX", "ACCY", "ACCZ", "WDTM", "WDTX", "WDTY", "WDTZ"});
            break;
        case RequestType::Force: add({"FM", "FX", "FY", "FZ", "TM", "TX", "TY", "TZ"}); break;
        case RequestType::Expressions:
            for (const auto& [number, function] : request.functions)
                components.emplace_back(number, fmt::format("F{}", number));
    }
    return components;
}

std::string makePlainName(const MechanismRequest& request, const std::string& usual) {
    return fmt::format("R{}.{}", request.id, usual);
}

}  // namespace

// By RESULTS_NAME and CNAMES where they are given. Requests may share the one and repeat the others; a name that is
// taken, or that another component has without them, gives way to the plain one.
std::vector<std::string> Recorder::nameComponents(const MechanismRequest& request) {
    std::vector<std::string> names;
    for (const auto& [number, usual] : listComponents(request)) {
        const bool isNamed =
            size_t(number) <= request.cnames.size() && !request.cnames[size_t(number) - 1].empty();
        const std::string plain = makePlainName(request, usual);
        std::string name =
            (request.resultsName.empty() ? fmt::format("R{}", request.id) : request.resultsName) + "." +
            (isNamed ? request.cnames[size_t(number) - 1] : usual);
        if (m_requestColumns.count(name) > 0) name = plain;
        m_requestColumns.insert(name);
        names.push_back(name);
    }
    return names;
}

void Recorder::addRequests() {
    for (const MechanismRequest& request : m_mechanism.getRequests())
        for (const auto& [number, usual] : listComponents(request))
            m_requestColumns.insert(makePlainName(request, usual));
    for (const MechanismRequest& request : m_mechanism.getRequests()) {
        addRequest(request);
        m_groups.back().request = fmt::format("REQUEST/{}", request.id);
    }
}

void Recorder::addRequest(const MechanismRequest& request) {
    const Units& u = m_units;
    // The first four columns are linear, the others angular.
    const auto add = [&](const Unit& linear, const Unit& angular, auto calc) {
        std::vector<Column> columns;
        for (const std::string& name : nameComponents(request))
            columns.push_back({name, columns.size() < 4 ? linear : angular});
        addGroup(m_requests, fmt::format("REQUEST/{}", request.id), "", columns,
                 [calc, request](const State& s, double* out) { calc(request, s, out); });
    };
    switch (request.type) {
        case RequestType::Displacement: return add(u.length, u.angle, calcDisplacement);
        case RequestType::Velocity: return add(u.velocity, u.angularVelocity, calcVelocity);
        case RequestType::Acceleration: return add(u.acceleration, u.angularAcceleration, calcAcceleration);
        case RequestType::Force: return add(u.force, u.moment, calcForce);
        case RequestType::Expressions: return add(Plain, Plain, calcFunctions);
    }
}

//----------------------------------------------------------------------------- reactions, parts, energy
void Recorder::addReactions(const Element& element) {
    if (element.isForce()) return;
    const Unit F = m_units.force, M = m_units.moment;
    const auto add = [&](const char* side, const LoadFunction& load) {
        if (!load) return;
        addGroup(m_reactions, element.getName(), element.getName() + side,
                 {{"FX", F}, {"FY", F}, {"FZ", F}, {"TX", M}, {"TY", M}, {"TZ", M}},
                 [load](const State& s, double* out) {
                     const SpatialVec onMarker = load(s);
                     put(onMarker[0], put(onMarker[1], out));
                 });
    };
    add(".I.", element.onI);
    add(".J.", element.onJ);
}

void Recorder::addPart(const MechanismPart& part) {
    const Unit L = m_units.length, V = m_units.velocity, W = m_units.angularVelocity;
    addGroup(m_parts, part.name, part.name + ".",
             {{"X", L},
              {"Y", L},
              {"Z", L},
              {"E0", Plain},
              {"E1", Plain},
              {"E2", Plain},
              {"E3", Plain},
              {"VX", V},
              {"VY", V},
              {"VZ", V},
              {"WX", W},
              {"WY", W},
              {"WZ", W}},
             [cm = part.cm](const State& s, double* out) {
                 const Transform X_GC = cm.findPoseInGround(s);
                 out = put(X_GC.p(), out);
                 const SimTK::Quaternion q = X_GC.R().convertRotationToQuaternion();
                 for (int k = 0; k < 4; ++k) *out++ = q[k];
                 const SpatialVec V_GC = cm.findVelocityInGround(s);
                 put(V_GC[0], put(V_GC[1], out));
             });
}

void Recorder::addModes(const MechanismPart& part) {
    if (!part.flexible) return;
    const UnitSystem& u = m_mechanism.getUnits();
    std::vector<Column> columns;
    for (int k = 1; k <= part.flexible->getNumModes(); ++k)
        columns.push_back({fmt::format("Q{}", k), {"mass^(1/2) length", std::sqrt(u.mass) * u.length}});
    addGroup(m_parts, part.name, part.name + ".", columns,
             [body = *part.flexible](const State& s, double* out) {
                 const SimTK::Vector q = body.getModalCoordinates(s);
                 std::copy(&q[0], &q[0] + q.size(), out);
             });
}

void Recorder::addEnergy() {
    const Unit E = m_units.moment;
    addGroup(m_parts, "", "energy.", {{"kinetic", E}, {"potential", E}, {"total", E}},
             [&mechanism = m_mechanism](const State& s, double* out) {
                 out[0] = mechanism.calcKineticEnergy(s);
                 out[1] = mechanism.getSystem().calcPotentialEnergy(s);
                 out[2] = out[0] + out[1];
             });
}

void Recorder::addErrors() {
    addGroup(m_parts, "", "error.", {{"length", m_units.length}, {"angle", m_units.angle}},
             [this](const State&, double* out) {
                 out[0] = m_violation.length;
                 out[1] = m_violation.angle;
             });
}

ColumnDescriptions describeColumns(const Mechanism& mechanism) {
    class Nowhere final : public ResultSink {
    public:
        void begin(const ResultColumns&) override {}
        void add(const ResultRow&) override {}
    };
    Nowhere nowhere;
    return Recorder(mechanism, nowhere).getDescriptions();
}

}  // namespace jprim
