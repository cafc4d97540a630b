// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_ASSEMBLY_CONDITIONS_H_
#define JPRIM_SRC_SIMULATION_ASSEMBLY_CONDITIONS_H_

#include <memory>
#include <string>
#include <vector>

#include "jprim/simulation/assemble.h"
#include "simulation/position_condition.h"

namespace jprim {

using PositionConditions = std::vector<std::shared_ptr<const PositionCondition>>;

/// PART/EXACT: the named ones of the coordinates X, Y, Z [length units] and PSI, THETA, PHI [rad] of the part's BCS
/// keep their given values.
///
/// 3-1-3 angles are singular where z stands upright, as in every plane mechanism. There PSI and PHI are both
/// the turn about z, and THETA is held by not tilting z.
class ExactCoordinates final : public PositionCondition {
public:
    explicit ExactCoordinates(const MechanismPart& part) : m_part(part) {}

    SimTK::Vector calcErrors(const SimTK::State& state) const override;
    void addDirections(const SimTK::State& state, int equation, Directions& directions) const override;

private:
    std::vector<SimTK::Real> calcErrors(const SimTK::Transform& X_GP) const;

    const MechanismPart& m_part;
};

/// A coordinate with a value given for the start. Angles are met on the nearest turn.
class GivenCoordinate final : public PositionCondition {
public:
    explicit GivenCoordinate(const InitialCoordinate& given) : m_given(given) {}

    SimTK::Vector calcErrors(const SimTK::State& state) const override;
    void addDirections(const SimTK::State& state, int equation, Directions& directions) const override;

private:
    const InitialCoordinate& m_given;
};

/// Keeps another condition's errors what they are in a State, or a part of that.
class KeptCondition final : public PositionCondition {
public:
    KeptCondition(std::shared_ptr<const PositionCondition> condition, const SimTK::State& state,
                  SimTK::Real part = 1)
        : m_condition(std::move(condition)), m_errors(part * m_condition->calcErrors(state)) {}

    SimTK::Vector calcErrors(const SimTK::State& state) const override {
        return m_condition->calcErrors(state) - m_errors;
    }
    void addDirections(const SimTK::State& state, int equation, Directions& directions) const override {
        m_condition->addDirections(state, equation, directions);
    }

private:
    std::shared_ptr<const PositionCondition> m_condition;
    SimTK::Vector m_errors;
};

PositionConditions makeExactConditions(const Mechanism& mechanism);
PositionConditions makeInitialConditions(const Mechanism& mechanism, const SimTK::State& state);

/// True if the element is switched off in a State: what is given for its coordinate does not count.
bool isSwitchedOff(const Mechanism& mechanism, const InitialCoordinate& given, const SimTK::State& state);

/// The coordinates that EXACT names and the State misses by more than `tolerance` [sizes of the part, rad]; the
/// worst first.
std::vector<MissedCoordinate> findMissedExact(const Mechanism& mechanism, const SimTK::State& state,
                                              SimTK::Real tolerance);
/// The same of values given for the start [length units, rad].
std::vector<MissedCoordinate> findMissedInitial(const Mechanism& mechanism, const SimTK::State& state,
                                                SimTK::Real tolerance);

/// What assembly must not move, for messages: the parts with EXACT coordinates and the elements with given
/// ones; empty if there is none.
std::string nameHeld(const Mechanism& mechanism);

}  // namespace jprim

#endif
