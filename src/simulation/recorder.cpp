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

Recorder::Recorder(const Mechanism& mechanism) : m_mechanism(mechanism) {
    const double second = m_mechanism.getUnits().time;
    for (Table* table : {&m_results.requests, &m_results.reactions, &m_results.parts})
        addGroup(*table, "", {{"time", second}}, [](const State& s, double* out) { *out = s.getTime(); });
    for (const MechanismRequest& request : m_mechanism.getRequests()) addRequest(request);
    for (const LoadElement& element : m_mechanism.getLoadElements()) addReactions(element);
    for (const MechanismPart& part : m_mechanism.getParts()) {
        if (part.ground) continue;
        addPart(part);
        addModes(part);
    }
    addEnergy();
}

void Recorder::addGroup(Table& table, const std::string& prefix, const std::vector<Column>& columns,
                        std::function<void(const State&, double*)> calcInSI) {
    Group group{&table, {}, std::move(calcInSI)};
    for (const Column& column : columns) {
        table.columns.push_back(prefix + column.name);
        group.unitsInSI.push_back(column.unitInSI);
    }
    m_groups.push_back(std::move(group));
}

void Recorder::record(const State& state) {
    for (const Group& group : m_groups) {
        std::vector<double>& values = group.table->values;
        const size_t first = values.size();
        values.resize(first + group.unitsInSI.size());
        group.calcInSI(state, &values[first]);
        for (size_t k = 0; k < group.unitsInSI.size(); ++k) values[first + k] /= group.unitsInSI[k];
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

}  // namespace

// By RESULTS_NAME and CNAMES where they are given. Requests may share the one and repeat the others; a name that is
// taken gives way to the one that the component has without them.
std::string Recorder::nameComponent(const MechanismRequest& request, int component,
                                    const std::string& usual) {
    const bool isNamed =
        size_t(component) <= request.cnames.size() && !request.cnames[size_t(component) - 1].empty();
    const std::string plain = fmt::format("R{}", request.id);
    std::string name = (request.resultsName.empty() ? plain : request.resultsName) + "." +
                       (isNamed ? request.cnames[size_t(component) - 1] : usual);
    if (m_requestColumns.count(name) > 0) name = plain + "." + usual;
    while (!m_requestColumns.insert(name).second) name += '_';
    return name;
}

void Recorder::addRequest(const MechanismRequest& request) {
    const UnitSystem& u = m_mechanism.getUnits();
    // The first four columns are linear, the others angular. Seven lack the angular magnitude.
    const auto add = [&](const std::vector<const char*>& names, double linear, double angular, auto calc) {
        std::vector<Column> columns;
        for (const char* usual : names) {
            const int k = int(columns.size()), missing = names.size() == 7 && k >= 4 ? 1 : 0;
            columns.push_back({nameComponent(request, k + missing + 1, usual), k < 4 ? linear : angular});
        }
        addGroup(m_results.requests, "", columns,
                 [calc, request](const State& s, double* out) { calc(request, s, out); });
    };
    switch (request.type) {
        case RequestType::Displacement:
            return add({"MAG", "X", "Y", "Z", "PSI", "THETA", "PHI"}, u.length, 1, calcDisplacement);
        case RequestType::Velocity:
            return add({"VM", "VX", "VY", "VZ", "WM", "WX", "WY", "WZ"}, u.getVelocity(),
                       u.getAngularVelocity(), calcVelocity);
        case RequestType::Acceleration:
            return add({"ACCM", "ACCX", "ACCY", "ACCZ", "WDTM", "WDTX", "WDTY", "WDTZ"}, u.getAcceleration(),
                       u.getAngularAcceleration(), calcAcceleration);
        case RequestType::Force:
            return add({"FM", "FX", "FY", "FZ", "TM", "TX", "TY", "TZ"}, u.force, u.getMoment(), calcForce);
        case RequestType::Expressions: addFunctions(request);
    }
}

// Functions give their values in the dataset's units already.
void Recorder::addFunctions(const MechanismRequest& request) {
    for (const auto& [number, function] : request.functions)
        addGroup(m_results.requests, "", {{nameComponent(request, number, fmt::format("F{}", number)), 1}},
                 [f = function](const State& s, double* out) { *out = f.calcValue(s); });
}

//----------------------------------------------------------------------------- reactions, parts, energy
void Recorder::addReactions(const LoadElement& element) {
    if (!element.isConstraint) return;
    const double F = m_mechanism.getUnits().force, M = m_mechanism.getUnits().getMoment();
    const auto add = [&](const char* side, const LoadFunction& load) {
        if (!load) return;
        addGroup(m_results.reactions, element.name + side,
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
    const UnitSystem& u = m_mechanism.getUnits();
    const double L = u.length, V = u.getVelocity(), W = u.getAngularVelocity();
    addGroup(m_results.parts, part.name + ".",
             {{"X", L},
              {"Y", L},
              {"Z", L},
              {"E0", 1},
              {"E1", 1},
              {"E2", 1},
              {"E3", 1},
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
        columns.push_back({fmt::format("Q{}", k), std::sqrt(u.mass) * u.length});
    addGroup(m_results.parts, part.name + ".", columns, [body = *part.flexible](const State& s, double* out) {
        const SimTK::Vector q = body.getModalCoordinates(s);
        std::copy(&q[0], &q[0] + q.size(), out);
    });
}

void Recorder::addEnergy() {
    const double E = m_mechanism.getUnits().getEnergy();
    addGroup(m_results.parts, "energy.", {{"kinetic", E}, {"potential", E}, {"total", E}},
             [&mechanism = m_mechanism](const State& s, double* out) {
                 out[0] = mechanism.calcKineticEnergy(s);
                 out[1] = mechanism.getSystem().calcPotentialEnergy(s);
                 out[2] = out[0] + out[1];
             });
}

}  // namespace jprim
