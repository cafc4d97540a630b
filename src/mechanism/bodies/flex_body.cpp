// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "base/format.h"
#include "mechanism/bodies/bodies.h"

namespace jprim {

using SimTK::Transform;

void addFlexBodies(const BodyContext& context) {
    MechanismContents& contents = context.contents;
    const int first = int(context.dataset.parts.size() + context.dataset.pointMasses.size());
    for (size_t k = 0; k < context.dataset.flexBodies.size(); ++k) {
        const FlexBodyStatement& statement = context.dataset.flexBodies[k];
        if (context.modes.count(statement.id) == 0) continue;
        MechanismPart part =
            startPart(fmt::format("FLEX_BODY/{}", statement.id), statement, first + int(k), context);
        const ModalBasis inUnits =
            convertUnits(context.modes.at(statement.id), 1 / contents.lengthUnit, 1, 1);
        ModalBasis basis = moveOrigin(inUnits, inUnits.rigid.center);
        basis.name = part.name;
        part.size = 0;
        for (const ModalNode& node : basis.nodes) part.size = std::max(part.size, node.position.norm());

        FlexibleBodyOptions options;
        if (statement.constantCoupling) options.coupling = InertiaCoupling::Constant;
        if (statement.cratio) options.dampingRatios.assign(basis.frequencies.size(), *statement.cratio);
        const bool isMade = context.reporter.attempt(part.name, statement.where, [&] {
            part.flexible.emplace(contents.matter, contents.forces, basis, options);
        });
        if (!isMade) continue;
        part.body = part.flexible->getBody();
        part.cm = Marker(part.body);
        part.bcs = Marker(part.body, Transform(-inUnits.rigid.center));
        contents.parts.push_back(part);
    }
}

}  // namespace jprim
