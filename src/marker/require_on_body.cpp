// SPDX-License-Identifier: Apache-2.0
#include "marker/require_on_body.h"

#include "base/format.h"
#include "jprim/base/error.h"
#include "marker/marker_expression.h"

namespace jprim {

void requireOnBody(const Marker& marker, const std::string& label, const std::string& element) {
    if (!marker.isOnBody())
        throw Error(element,
                    label +
                        " is not on a body; construct it with a MobilizedBody that has been added to a "
                        "matter subsystem");
}

void requireInSystem(const Marker& marker, const std::string& label, const SimTK::System& system,
                     const std::string& element) {
    requireOnBody(marker, label, element);
    if (&marker.getBody().getMatterSubsystem().getSystem() != &system)
        throw Error(element, label + " belongs to another system; put all bodies into one");
}

void requireInSystem(const Expression& expression, const SimTK::System& system, const std::string& element) {
    const MarkerExpression& e = expression.getImplementation();
    for (size_t k = 0; k < e.markers.size(); ++k)
        requireInSystem(e.markers[k], fmt::format("marker {}", e.markerIds[k]), system, element);
}

const SimTK::System& findSystem(const SimTK::GeneralForceSubsystem& forces, const std::string& element) {
    if (!forces.hasGuts() || !forces.isInSystem())
        throw Error(element, "its force subsystem belongs to no system; construct it with a MultibodySystem");
    return forces.getSystem();
}

void requireTwoBodies(const Marker& I, const Marker& J, const std::string& element) {
    for (const auto& [marker, letter] : {std::pair(&I, 'I'), std::pair(&J, 'J')})
        requireOnBody(*marker, std::string("marker ") + letter, element);
    if (&I.getBody().getMatterSubsystem().getSystem() != &J.getBody().getMatterSubsystem().getSystem())
        throw Error(element, "markers I and J belong to different systems; put both bodies into one");
    if (I.getBody().getMobilizedBodyIndex() == J.getBody().getMobilizedBodyIndex())
        throw Error(element, fmt::format("markers I and J are both on body {}; it acts between two "
                                         "different bodies",
                                         int(I.getBody().getMobilizedBodyIndex())));
}

}  // namespace jprim
