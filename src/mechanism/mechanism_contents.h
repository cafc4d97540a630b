// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_MECHANISM_CONTENTS_H_
#define JPRIM_SRC_MECHANISM_MECHANISM_CONTENTS_H_

#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

#include "jprim/mechanism/mechanism.h"
#include "mechanism/work_integral.h"

namespace jprim {

class ControlVariables;

/// What a Mechanism consists of; see its accessors. It stays where it is when the Mechanism moves.
struct MechanismContents {
    /// False if something may put energy in or take it out.
    [[nodiscard]] bool isConservative() const;
    /// @throws Error if there is none
    [[nodiscard]] const Marker& getMarker(int id) const;

    std::string title;
    UnitSystem units;
    double lengthUnit = 1;
    SimTK::Vec3 gravity{0};
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    SimTK::GeneralForceSubsystem forces{system};
    std::vector<MechanismPart> parts;
    std::unordered_map<int, Marker> markers;
    ElementList elements;
    std::vector<InitialCoordinate> initialCoordinates;
    std::vector<MechanismRequest> requests;
    std::vector<MechanismSensor> sensors;
    std::function<Mechanism()> makeWithFreeParts;  ///< empty if the parts are free
    std::vector<MechanismState> states;
    const ControlVariables* control = nullptr;  ///< owned by the system
    const WorkIntegral* work = nullptr;  ///< owned by the system; null if the mechanism is conservative
};

}  // namespace jprim

#endif
