// SPDX-License-Identifier: Apache-2.0
// The part of MechanismBuilder that makes flexible bodies and the markers on them.
#include <algorithm>

#include "base/format.h"
#include "build/mechanism_builder.h"
#include "jprim/base/error.h"

namespace jprim {

using SimTK::Transform;
using SimTK::Vec3;

// QP, or for a marker on a node the node's place if there is no QP.
std::optional<Triple> MechanismBuilder::findOrigin(const MarkerStatement& marker) {
    if (marker.flexBody == 0 || marker.node == 0 || m_modes.count(marker.flexBody) == 0) return marker.qp;
    try {
        const Vec3 p = m_modes.at(marker.flexBody).getNode(marker.node).position / m_mechanism.m_units.length;
        return marker.qp.value_or(Triple{p[0], p[1], p[2]});
    } catch (const Error& error) {
        report(Severity::Error, marker.where, fmt::format("MARKER/{}: {}", marker.id, error.what()));
        return marker.qp;
    }
}

void MechanismBuilder::addFlexBodies() {
    for (const FlexBodyStatement& body : m_dataset.flexBodies)
        if (m_modes.count(body.id) > 0) addFlexBody(body);
}

void MechanismBuilder::addFlexBody(const FlexBodyStatement& statement) {
    MechanismPart part;
    part.name = fmt::format("FLEX_BODY/{}", statement.id);
    setRigidCoordinates(statement, statement.where, part);

    const ModalBasis inUnits = convertUnits(m_modes.at(statement.id), 1 / m_mechanism.m_lengthUnit, 1, 1);
    ModalBasis basis = moveOrigin(inUnits, inUnits.rigid.center);
    basis.name = part.name;
    part.size = 0;
    for (const ModalNode& node : basis.nodes) part.size = std::max(part.size, node.position.norm());

    FlexibleBodyOptions options;
    if (statement.constantCoupling) options.coupling = InertiaCoupling::Constant;
    if (statement.cratio) options.dampingRatios.assign(basis.frequencies.size(), *statement.cratio);
    attempt(part.name, statement.where, [&] {
        part.flexible.emplace(m_mechanism.m_bodies->matter, m_mechanism.m_bodies->forces, basis, options);
    });
    if (!part.flexible) return;
    part.body = part.flexible->getBody();
    part.cm = Marker(part.body);
    part.bcs = Marker(part.body, Transform(-inUnits.rigid.center));
    m_mechanism.m_parts.push_back(part);
}

// On a node of a flexible body, which undeformed has the axes of the body; or fixed to the body's frame.
Marker MechanismBuilder::makeMarker(const MarkerStatement& statement) const {
    const MechanismPart& part = m_mechanism.m_parts[size_t(m_ownerOfMarker.at(statement.id))];
    const Transform X_BM = part.bcs.getPose() * m_markerPoses.at(statement.id);
    const auto isItsNode = [&](const ModalNode& node) { return node.id == statement.node; };
    const bool isOnNode = part.flexible && std::any_of(part.flexible->getBasis().nodes.begin(),
                                                       part.flexible->getBasis().nodes.end(), isItsNode);
    if (!isOnNode)
        return Marker(part.body, X_BM);  // a node that is missing was reported with the marker's place
    const Vec3 p_BN = part.flexible->getBasis().getNode(statement.node).position;
    return Marker(*part.flexible, statement.node, Transform(-p_BN) * X_BM);
}

}  // namespace jprim
