// SPDX-License-Identifier: Apache-2.0
#include "mechanism/tree_plan.h"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>

#include "simmath/MultibodyGraphMaker.h"

namespace jprim {

using SimTK::MultibodyGraphMaker;

namespace {

//-------------------------------------------------------------------------- what mobilizers can stand for
std::optional<MobilizerType> findMobilizer(JointType type) {
    switch (type) {
        case JointType::Fixed: return MobilizerType::Weld;
        case JointType::Revolute: return MobilizerType::Pin;
        case JointType::Translational: return MobilizerType::Slider;
        case JointType::Universal: return MobilizerType::Universal;
        case JointType::Hooke: return MobilizerType::Hooke;
        case JointType::Cylindrical: return MobilizerType::Cylinder;
        case JointType::Spherical: return MobilizerType::Ball;
        case JointType::Planar: return MobilizerType::Planar;
        default: return std::nullopt;
    }
}

/// The first primitive says which marker is I.
struct Combination {
    MobilizerType type;
    std::vector<JprimType> jprims;
};

// Those that leave fewer freedoms first.
const Combination Combinations[] = {
    {MobilizerType::Weld, {JprimType::AtPoint, JprimType::Orientation}},
    {MobilizerType::Slider, {JprimType::InLine, JprimType::Orientation}},
    {MobilizerType::Pin, {JprimType::AtPoint, JprimType::ParallelAxes}},
    {MobilizerType::Universal, {JprimType::AtPoint, JprimType::Perpendicular}},
    {MobilizerType::Cylinder, {JprimType::InLine, JprimType::ParallelAxes}},
    {MobilizerType::Ball, {JprimType::AtPoint}},
    {MobilizerType::Planar, {JprimType::InPlane, JprimType::ParallelAxes}},
    {MobilizerType::Translation, {JprimType::Orientation}}};

LoadShare getShare(JprimType type) {
    const bool isTranslational =
        type == JprimType::AtPoint || type == JprimType::InLine || type == JprimType::InPlane;
    return isTranslational ? LoadShare::Force : LoadShare::Moment;
}

using Jprims = std::vector<const JprimStatement*>;

// Takes the combination out of what is left of the primitives between two markers, if it is there.
std::optional<PlannedMobilizer> take(const Combination& combination, Jprims& left) {
    PlannedMobilizer planned;
    planned.type = combination.type;
    Jprims rest = left;
    for (const JprimType type : combination.jprims) {
        const auto found =
            std::find_if(rest.begin(), rest.end(), [&](const JprimStatement* s) { return s->type == type; });
        if (found == rest.end()) return std::nullopt;
        const JprimStatement& s = **found;
        if (planned.elements.empty()) {
            planned.i = s.i;
            planned.j = s.j;
        }
        planned.elements.push_back({{ElementKind::Jprim, s.id}, getShare(type), s.i != planned.i});
        rest.erase(found);
    }
    left = rest;
    return planned;
}

// The primitives between the same two markers, in the order of the dataset.
std::vector<Jprims> groupByMarkers(const Dataset& dataset) {
    std::vector<Jprims> groups;
    std::map<std::pair<int, int>, size_t> places;
    for (const JprimStatement& s : dataset.jprims) {
        const std::pair<int, int> markers = std::minmax(s.i, s.j);
        const size_t place = places.try_emplace(markers, groups.size()).first->second;
        if (place == groups.size()) groups.emplace_back();
        groups[place].push_back(&s);
    }
    return groups;
}

std::vector<PlannedMobilizer> findJoints(const Dataset& dataset) {
    std::vector<PlannedMobilizer> joints;
    for (Jprims& jprims : groupByMarkers(dataset))
        for (const Combination& combination : Combinations)
            if (const auto joint = take(combination, jprims)) joints.push_back(*joint);
    for (const JointStatement& s : dataset.joints)
        if (const auto type = findMobilizer(s.type)) {
            const LoadShare share = s.type == JointType::Spherical ? LoadShare::Force : LoadShare::Both;
            PlannedMobilizer joint;
            joint.type = *type;
            joint.i = s.i;
            joint.j = s.j;
            joint.elements = {{{ElementKind::Joint, s.id}, share, false}};
            joints.push_back(joint);
        }
    const auto hasLessFreedom = [](const PlannedMobilizer& a, const PlannedMobilizer& b) {
        return a.type < b.type;  // they are declared in this order
    };
    std::stable_sort(joints.begin(), joints.end(), hasLessFreedom);
    return joints;
}

//---------------------------------------------------------------------------------------------- the tree
/// The dataset as Simbody's graph. Of the joints that are found only those between two PARTs are in it.
class Graph {
public:
    explicit Graph(const Dataset& dataset) : m_joints(findJoints(dataset)) {
        m_maker.addJointType(Joint, 1, true);
        m_maker.addBody(Ground, 0, false);
        for (const PartStatement& part : dataset.parts) addPart(part);
        for (const MarkerStatement& marker : dataset.markers)
            if (marker.part != 0) m_owners[marker.id] = marker.part;
        for (PlannedMobilizer& joint : m_joints) addJoint(joint);
        m_maker.generateGraph();
    }

    std::vector<PlannedMobilizer> makeMobilizers() const {
        std::vector<PlannedMobilizer> mobilizers;
        for (int k = 0; k < m_maker.getNumMobilizers(); ++k) {
            const MultibodyGraphMaker::Mobilizer& mobilizer = m_maker.getMobilizer(k);
            const auto* part = static_cast<const PartStatement*>(mobilizer.getOutboardBodyRef());
            if (!part) continue;  // ground, which some versions of Simbody list
            PlannedMobilizer planned;
            if (!mobilizer.isAddedBaseMobilizer()) {
                planned = *static_cast<const PlannedMobilizer*>(mobilizer.getJointRef());
                planned.reversed = mobilizer.isReversedFromJoint();
                planned.parent = m_places.at(m_owners.at(planned.reversed ? planned.i : planned.j));
            }
            planned.part = m_places.at(part->id);
            mobilizers.push_back(planned);
        }
        return mobilizers;
    }

private:
    // Names that no part has.
    static constexpr const char *Ground = "ground", *Joint = "joint";

    // Massless parts get a little mass when they are built, so that for the tree all parts are alike.
    void addPart(const PartStatement& part) {
        m_places[part.id] = int(m_places.size());
        if (part.ground)
            m_names[part.id] = Ground;
        else
            m_maker.addBody(m_names[part.id] = std::to_string(part.id), 1, false,
                            const_cast<PartStatement*>(&part));  // it only hands the pointer back
    }

    void addJoint(PlannedMobilizer& joint) {
        const auto I = m_owners.find(joint.i), J = m_owners.find(joint.j);
        if (I == m_owners.end() || J == m_owners.end() || I->second == J->second) return;
        m_maker.addJoint(joint.elements[0].id.getText(), Joint, m_names.at(J->second), m_names.at(I->second),
                         false, &joint);
    }

    std::vector<PlannedMobilizer> m_joints;
    std::unordered_map<int, int> m_places;         // of a PART in the dataset, by id
    std::unordered_map<int, std::string> m_names;  // of a PART in the graph
    std::unordered_map<int, int> m_owners;         // the PART that a marker is on
    MultibodyGraphMaker m_maker;
};

}  // namespace

TreePlan::TreePlan(std::vector<PlannedMobilizer> mobilizers) : m_mobilizers(std::move(mobilizers)) {
    for (const PlannedMobilizer& mobilizer : m_mobilizers)
        for (const PlannedElement& element : mobilizer.elements)
            m_places[element.id] = {&mobilizer, &element};
}

std::optional<TreePlace> TreePlan::find(const ElementId& id) const {
    const auto found = m_places.find(id);
    if (found == m_places.end()) return std::nullopt;
    return found->second;
}

TreePlan planTree(const Dataset& dataset) {
    return TreePlan(Graph(dataset).makeMobilizers());
}

TreePlan planFreeParts(const Dataset& dataset) {
    std::vector<PlannedMobilizer> mobilizers;
    for (size_t k = 0; k < dataset.parts.size(); ++k)
        if (!dataset.parts[k].ground) {
            PlannedMobilizer free;
            free.part = int(k);
            mobilizers.push_back(free);
        }
    return TreePlan(std::move(mobilizers));
}

const char* getSimbodyName(MobilizerType type) {
    switch (type) {
        case MobilizerType::Free: return "Free";
        case MobilizerType::Weld: return "Weld";
        case MobilizerType::Pin: return "Pin";
        case MobilizerType::Slider: return "Slider";
        case MobilizerType::Universal:
        case MobilizerType::Hooke: return "Universal";
        case MobilizerType::Cylinder: return "Cylinder";
        case MobilizerType::Ball: return "Ball";
        case MobilizerType::Planar: return "Planar";
        case MobilizerType::Translation: break;
    }
    return "Translation";
}

}  // namespace jprim
