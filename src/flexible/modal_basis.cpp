// SPDX-License-Identifier: Apache-2.0
#include "jprim/flexible/modal_basis.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "jprim/base/error.h"

namespace jprim {

using SimTK::Mat33;
using SimTK::Vec3;

Vec3 ModalBasis::getGyroscopic(int k, int l) const {
    if (k == l) return Vec3(0);
    if (k > l) return -getGyroscopic(l, k);
    const int n = getNumModes();
    return gyroscopic[size_t(k * (2 * n - k - 1) / 2 + l - k - 1)];
}

const ModalNode& ModalBasis::getNode(int id) const {
    const auto found =
        std::find_if(nodes.begin(), nodes.end(), [id](const ModalNode& node) { return node.id == id; });
    if (found == nodes.end()) throw Error(name, fmt::format("has no node {}", id));
    return *found;
}

ModalBasis convertUnits(const ModalBasis& basis, double lengthFactor, double massFactor, double timeFactor) {
    ModalBasis result = basis;
    const double coordinate = std::sqrt(massFactor) * lengthFactor;  // of q
    result.rigid.mass *= massFactor;
    result.rigid.center *= lengthFactor;
    result.rigid.inertia *= massFactor * lengthFactor * lengthFactor;
    for (double& frequency : result.frequencies) frequency /= timeFactor;
    for (ModalNode& node : result.nodes) {
        node.position *= lengthFactor;
        for (Vec3& shape : node.translation) shape *= lengthFactor / coordinate;
        for (Vec3& shape : node.rotation) shape /= coordinate;
    }
    for (Mat33& change : result.inertiaChange) change *= coordinate;
    return result;
}

ModalBasis moveOrigin(const ModalBasis& basis, const Vec3& origin) {
    ModalBasis result = basis;
    result.rigid.center -= origin;
    for (ModalNode& node : result.nodes) node.position -= origin;
    return result;
}

}  // namespace jprim
