// SPDX-License-Identifier: Apache-2.0
#include "jprim/flexible/finite_element_model.h"

#include <unordered_set>

#include "base/format.h"
#include "flexible/structure.h"
#include "jprim/base/error.h"

namespace jprim {

void checkNodes(const FiniteElementModel& model) {
    if (model.freedomsPerNode != 3 && model.freedomsPerNode != 6)
        throw Error(model.name,
                    fmt::format("a node has {} freedoms; it must have 3 or 6", model.freedomsPerNode));
    if (model.nodes.empty()) throw Error(model.name, "there are no nodes");
    std::unordered_set<int> ids;
    for (const FiniteElementNode& node : model.nodes)
        if (!ids.insert(node.id).second)
            throw Error(model.name, fmt::format("node {} is given twice", node.id));
}

void checkFiniteElementModel(const FiniteElementModel& model) {
    checkNodes(model);
    checkStructure(Structure(model));
}

RigidBodyProperties calcRigidBodyProperties(const FiniteElementModel& model) {
    checkNodes(model);
    return calcRigidBodyProperties(Structure(model));
}

}  // namespace jprim
