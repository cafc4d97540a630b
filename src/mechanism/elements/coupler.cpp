// SPDX-License-Identifier: Apache-2.0
#include "mechanism/elements/elements.h"
#include "mechanism/elements/equation.h"

namespace jprim {

// Sum of scale times displacement, in the dataset's units; angles count whole turns.
Element makeElement(const CouplerStatement& s, const ElementContext& context) {
    const Expression f = context.write(FunctionUse::Equation, [&](FunctionWriter& w) {
        MarkerFrames& frames = w.updFrames();
        Operand sum = w.updBuilder().number(0);
        for (size_t k = 0; k < s.joints.size(); ++k) {
            const JointStatement& joint = context.getJoint(s.joints[k]);
            const Operand q = s.types[k] == CouplerType::Rotational
                                  ? frames.angleAboutZ(joint.i, joint.j)
                                  : frames.along(frames.position(joint.i, joint.j), joint.j, 2);
            sum = w.updBuilder().add(sum, w.scale(s.scales[k], q));
        }
        return sum;
    });
    return makeEquation({ElementKind::Coupler, s.id}, f, context);
}

}  // namespace jprim
