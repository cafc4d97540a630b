// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_ANALYSIS_CONSTRAINT_EQUATIONS_H_
#define JPRIM_ANALYSIS_CONSTRAINT_EQUATIONS_H_

#include <map>
#include <string>
#include <vector>

#include "SimTKsimbody.h"
#include "jprim/base/kinematic_level.h"
#include "jprim/base/units.h"
#include "jprim/joint/joint.h"
#include "jprim/simbody_abi.h"

/// @file
/// The constraint equations of any Simbody system, named as a user knows them.
namespace jprim {

/// The word for equations of positions, g(q, t) = 0; of speeds, not integrable; or of accelerations alone: "holonomic",
/// "nonholonomic", "acceleration".
[[nodiscard]] const char* getEquationKind(KinematicLevel level);

/// One equation that is in use in a State.
struct ConstraintEquation {
    std::string element;  ///< "JOINT/3 REVOLUTE"
    std::string words;    ///< what it holds: "translation of I along Xj"
    KinematicLevel level = KinematicLevel::Position;
    SimTK::ConstraintIndex constraint;       ///< the Simbody constraint it belongs to
    int number = 0;                          ///< its place among that constraint's equations, from 0
    int multiplier = 0;                      ///< its row in G and place among the multipliers
    Dimension dimension = Dimension::Angle;  ///< of its error
    SimTK::Real scale = 1;  ///< the factor in the State, see PairConstraint::setEquationScale()

    bool isDropped() const { return scale == 0; }

    /// Its error in its own unit, from all errors of one kind as Simbody numbers them; 0 if it is dropped.
    [[nodiscard]] SimTK::Real getError(const SimTK::Vector& errors) const {
        return scale > 0 ? errors[multiplier] / scale : 0;
    }
    /// "JOINT/3 REVOLUTE: translation of I along Xj".
    [[nodiscard]] std::string getText() const { return element + ": " + words; }
};

/// What the user calls a Simbody constraint.
struct ElementName {
    std::string element;
    std::vector<std::string> equations;      ///< words for each; where they end, "equation 3"
    Dimension dimension = Dimension::Angle;  ///< of errors; a PairConstraint knows its own
};
using ElementNames = std::map<SimTK::ConstraintIndex, ElementName>;

/// The names that joints have anyway, for changing some.
[[nodiscard]] ElementNames nameElements(const std::vector<Joint>& joints);

/// All equations in use, in the order in which the constraints were added to the system. A constraint that `names`
/// leaves out is called by its own description if it is one of jprim's, any other by its class and index, as in
/// "Ball (constraint 4)". Requires Stage::Instance.
[[nodiscard]] std::vector<ConstraintEquation> findEquations(const SimTK::SimbodyMatterSubsystem& matter,
                                                            const SimTK::State& state,
                                                            const ElementNames& names = {});

}  // namespace jprim

#endif
