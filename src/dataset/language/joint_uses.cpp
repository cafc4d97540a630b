// SPDX-License-Identifier: Apache-2.0
// MOTION and COUPLER speak of the one coordinate of a joint, or of one of the two.
#include "base/format.h"
#include "dataset/language/read_state.h"

namespace jprim {
namespace {

using JointTypes = std::unordered_map<int, JointType, IdHash>;

bool hasRotation(JointType type) {
    return type == JointType::Revolute || type == JointType::Cylindrical;
}
bool hasTranslation(JointType type) {
    return type == JointType::Translational || type == JointType::Cylindrical;
}

// What is wrong with the use of a joint of this type; empty if nothing is.
std::string findFault(const JointUse& use, JointType type) {
    const bool rotates = hasRotation(type);
    const bool translates = hasTranslation(type);
    if (!rotates && !translates)
        return "; only REVOLUTE, TRANSLATIONAL and CYLINDRICAL joints have a coordinate";
    if (!use.coordinate && rotates && translates)
        return fmt::format(", so it must be said which of its two coordinates is meant: {}", use.remedy);
    if (use.coordinate == CouplerType::Rotational && !rotates) return ", which does not rotate";
    if (use.coordinate == CouplerType::Translational && !translates) return ", which does not translate";
    return "";
}

// A joint with errors has no type; it was reported already.
void completeCouplers(std::vector<CouplerStatement>& couplers, const JointTypes& types) {
    for (CouplerStatement& coupler : couplers) {
        if (!coupler.types.empty()) continue;
        for (const int joint : coupler.joints) {
            const auto type = types.find(joint);
            const bool rotates = type != types.end() && hasRotation(type->second);
            coupler.types.push_back(rotates ? CouplerType::Rotational : CouplerType::Translational);
        }
    }
}

}  // namespace

void checkJointUses(ReadState& state) {
    JointTypes types;
    for (const JointStatement& joint : state.dataset.joints) types.emplace(joint.id, joint.type);
    for (const JointUse& use : state.jointUses) {
        const auto type = types.find(use.joint);
        if (type == types.end()) continue;
        const std::string fault = findFault(use, type->second);
        if (!fault.empty())
            state.addError(use.statement, use.where,
                           fmt::format("{}: JOINT/{} is {}{}", use.argument, use.joint,
                                       getAdamsName(type->second), fault));
    }
    completeCouplers(state.dataset.couplers, types);
}

}  // namespace jprim
