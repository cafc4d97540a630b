// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_ASSEMBLY_CONDITIONS_H_
#define JPRIM_SRC_SIMULATION_ASSEMBLY_CONDITIONS_H_

#include <string>
#include <utility>
#include <vector>

#include "jprim/build/mechanism.h"

namespace jprim {

/// PART/EXACT as something the Assembler must satisfy: the named ones of the coordinates X, Y, Z [sizes of
/// the part] and PSI, THETA, PHI [rad] of the part's BCS keep their given values.
///
/// 3-1-3 angles are singular where z stands upright, as in every plane mechanism. There PSI and PHI are both
/// the turn about z, and THETA is held by not tilting z.
class ExactCoordinates : public SimTK::AssemblyCondition {
public:
    explicit ExactCoordinates(const MechanismPart& part)
        : AssemblyCondition(part.name + " EXACT"), m_part(part) {}

    int calcErrors(const SimTK::State& state, SimTK::Vector& errors) const override;

private:
    void addTurns(const SimTK::Rotation& R_GP, std::vector<SimTK::Real>& held) const;

    const MechanismPart& m_part;
};

/// Coordinates given for the start, likewise [length units, rad]. Angles are met on the nearest turn.
class GivenCoordinates : public SimTK::AssemblyCondition {
public:
    explicit GivenCoordinates(std::vector<InitialCoordinate> coordinates)
        : AssemblyCondition("initial coordinates"), m_coordinates(std::move(coordinates)) {}

    int calcErrors(const SimTK::State& state, SimTK::Vector& errors) const override;

private:
    std::vector<InitialCoordinate> m_coordinates;
};

/// The largest error of the coordinates given for the start, and whose it is.
std::pair<SimTK::Real, std::string> findCoordinateError(const Mechanism& mechanism,
                                                        const SimTK::State& state);

/// What assembly must not move, for messages: the parts with EXACT coordinates and the elements with given
/// ones; empty if there is none.
std::string nameHeld(const Mechanism& mechanism);

}  // namespace jprim

#endif
