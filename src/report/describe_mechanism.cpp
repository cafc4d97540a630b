// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "base/format.h"
#include "mechanism/part_mass.h"
#include "report/describe.h"

namespace jprim {

using SimTK::Mat33;
using SimTK::Transform;
using SimTK::Vec3;

void appendPose(const Transform& X, std::vector<float>& numbers) {
    for (int k = 0; k < 3; ++k) numbers.push_back(float(X.p()[k]));
    const SimTK::Quaternion e = X.R().convertRotationToQuaternion();
    for (int k = 0; k < 4; ++k) numbers.push_back(float(e[k]));
}

Json makeJson(const Vec3& v) {
    return {v[0], v[1], v[2]};
}

Json makeJson(const Transform& X) {
    const SimTK::Quaternion e = X.R().convertRotationToQuaternion();
    return {X.p()[0], X.p()[1], X.p()[2], e[0], e[1], e[2], e[3]};
}

namespace {

struct Mass {
    double mass = 0;
    Mat33 inertia{0};  // about the mass centre, axes of the BCS
};

// As the dataset has it: the body may have little additions.
class Masses {
public:
    Masses(const Dataset& dataset, const Mechanism& mechanism, const Motion& motion)
        : m_mechanism(mechanism), m_motion(motion) {
        for (const PartStatement& part : dataset.parts)
            m_parts.emplace(fmt::format("PART/{}", part.id), &part);
        for (const PointMassStatement& point : dataset.pointMasses)
            m_points.emplace(fmt::format("POINT_MASS/{}", point.id), point.mass.value_or(0));
    }

    Mass find(size_t index) const {
        const MechanismPart& part = m_mechanism.getParts()[index];
        if (const auto point = m_points.find(part.name); point != m_points.end())
            return {point->second, Mat33(0)};
        if (part.flexible) return findFlexible(part);
        const auto found = m_parts.find(part.name);
        return found == m_parts.end() || part.ground ? Mass{} : findRigid(part, *found->second, index);
    }

private:
    Mass findRigid(const MechanismPart& part, const PartStatement& statement, size_t index) const {
        const Transform X_BC = m_motion.findPoseOnPart(part.cm, index);
        const Transform X_BI =
            statement.im == 0 ? X_BC : m_motion.findPoseOnPart(m_mechanism.getMarker(statement.im), index);
        const double mass = statement.mass.value_or(0);
        return {mass, calcCentralInertia({mass, X_BC, X_BI, statement.ip})};
    }

    Mass findFlexible(const MechanismPart& part) const {
        const RigidBodyProperties& rigid = part.flexible->getBasis().rigid;
        const UnitSystem& units = m_mechanism.getUnits();
        const SimTK::Rotation R = ~part.bcs.getUndeformedPoseInBody().R();
        const Mat33 inertia = Mat33(R) * Mat33(rigid.inertia) * Mat33(~R);
        return {rigid.mass / units.mass, inertia / units.getInertia()};
    }

    const Mechanism& m_mechanism;
    const Motion& m_motion;
    std::map<std::string, const PartStatement*> m_parts;
    std::map<std::string, double> m_points;
};

// Adams' products of inertia are positive integrals.
Json makeInertia(const Mat33& I) {
    return {I(0, 0), I(1, 1), I(2, 2), -I(0, 1), -I(0, 2), -I(1, 2)};
}

Json makePart(const Mechanism& mechanism, size_t index, const Mass& mass, const Motion& motion) {
    const MechanismPart& part = mechanism.getParts()[index];
    Json json = {{"id", part.name},
                 {"ground", part.ground},
                 {"mass", mass.mass},
                 {"cm", makeJson(motion.findPoseOnPart(part.cm, index).p())},
                 {"inertia", makeInertia(mass.inertia)},
                 {"parent", nullptr},
                 {"joint", nullptr}};
    if (part.ground) return json;
    const Attachment& a = part.attachment;
    json["parent"] = a.parent < 0 ? "ground" : mechanism.getParts()[size_t(a.parent)].name;
    std::vector<std::string> elements;
    for (const ElementId& id : a.elements) elements.push_back(id.getText());
    json["joint"] = elements.empty() ? a.mobilizer : a.mobilizer + ": " + join(elements, ", ");
    return json;
}

Json makeMarkers(const Dataset& dataset, const Mechanism& mechanism, const Motion& motion) {
    Json markers = Json::array();
    for (const MarkerStatement& statement : dataset.markers) {
        if (statement.floating) continue;
        const Marker& marker = mechanism.getMarker(statement.id);
        const size_t part = motion.findPart(marker);
        markers.push_back(
            {{"id", statement.id}, {"part", part}, {"pose", makeJson(motion.findPoseOnPart(marker, part))}});
    }
    return markers;
}

Json findLoadOnI(const std::string& element, const Results& results) {
    const std::vector<std::string>& columns = results.reactions.columns;
    const auto found = std::find(columns.begin(), columns.end(), element + ".I.FX");
    if (found == columns.end()) return nullptr;
    return found - columns.begin() - 1;  // the time stands apart
}

// So that their markers can be found too.
void addRequests(const Dataset& dataset, Json& elements) {
    for (const RequestStatement& request : dataset.requests)
        elements.push_back({{"id", fmt::format("REQUEST/{}", request.id)},
                            {"kind", "REQUEST"},
                            {"type", getAdamsName(request.type)},
                            {"i", request.i},
                            {"j", request.j},
                            {"isForce", false},
                            {"loadOnI", nullptr}});
}

Json makeElements(const Dataset& dataset, const Mechanism& mechanism, const Results& results) {
    Json elements = Json::array();
    for (const Element& element : mechanism.getElements()) {
        if (!element.onI) continue;
        elements.push_back({{"id", element.getName()},
                            {"kind", getAdamsName(element.id.kind)},
                            {"type", element.type.empty() ? Json(nullptr) : Json(element.type)},
                            {"i", element.i},
                            {"j", element.j},
                            {"isForce", element.isForce()},
                            {"loadOnI", findLoadOnI(element.getName(), results)}});
    }
    addRequests(dataset, elements);
    return elements;
}

}  // namespace

void describeMechanism(const Dataset& dataset, const Mechanism& mechanism, const Motion& motion,
                       const Results& results, Json& json) {
    json["gravity"] = makeJson(mechanism.getGravity() / mechanism.getUnits().getAcceleration());
    const Masses masses(dataset, mechanism, motion);
    json["parts"] = Json::array();
    for (size_t k = 0; k < mechanism.getParts().size(); ++k)
        json["parts"].push_back(makePart(mechanism, k, masses.find(k), motion));
    json["markers"] = makeMarkers(dataset, mechanism, motion);
    json["elements"] = makeElements(dataset, mechanism, results);
}

}  // namespace jprim
