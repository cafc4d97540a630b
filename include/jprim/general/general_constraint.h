// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_GENERAL_GENERAL_CONSTRAINT_H_
#define JPRIM_GENERAL_GENERAL_CONSTRAINT_H_

#include <string>

#include "jprim/base/kinematic_level.h"
#include "jprim/marker/expression.h"
#include "jprim/marker/typed_handle.h"

namespace jprim {

class GeneralConstraintImpl;

/// Adams' GCON: one equation f = 0 between any number of markers, given as an expression. It is
/// - holonomic if f depends on positions and time: e = f, and df/dt, d2f/dt2 are its exact derivatives;
/// - nonholonomic if f depends on velocities: de/dt = f, which must be linear in them.
///
/// Each marker receives the load lambda df'/d[w, v], f' being df/dt of a holonomic and f of a nonholonomic
/// equation. Realizing Stage::Position throws Error where the equation has no finite value, and where it is not met and
/// no motion changes it: from there no assembler finds a way. A length that is zero may grow in any direction; one is
/// then chosen, so that DM(1,2)-0.5 assembles from points that coincide.
///
/// An ordinary SimTK::Constraint; the handle holds no data and may be copied freely. Source: Adams/Solver C++,
/// statement GCON.
class GeneralConstraint : public TypedConstraint<GeneralConstraint, SimTK::Constraint::Custom> {
public:
    /// An empty handle; good only to be assigned to.
    GeneralConstraint() = default;

    /// True of all that are made of one, PrescribedMotions and the Joints Screw and Rackpin among them.
    static bool isInstanceOf(const SimTK::Constraint& constraint);
    static constexpr const char* ClassName = "GeneralConstraint";

    /// f = 0.
    /// @throws Error, naming the constraint, if f is a vector, depends on no marker, on accelerations or
    ///         reactions, or not linearly on velocities; or if markers are on no body or in different systems
    explicit GeneralConstraint(const Expression& f, const std::string& name = "");

    /// A coordinate that follows a function of time: q = g, dq/dt = g or d2q/dt2 = g.
    /// @param coordinate  q, of positions
    /// @param function    g, of nothing but TIME
    /// @param level       what equals g: q, its rate or its acceleration
    /// @param period      q and q + period are the same, and g may go on for many of them; 0: they are not
    /// @throws Error as above, or for another level or period
    GeneralConstraint(const Expression& coordinate, const Expression& function, KinematicLevel level,
                      SimTK::Real period, const std::string& name = "");

    const std::string& getName() const;
    /// Adams' word for what it is: "GCON", "MOTION", "SCREW" or "RACKPIN".
    const char* getAdamsType() const;
    /// What messages call this constraint: its name, of a joint with the type; or the type alone.
    std::string getDescription() const;
    /// True if the equation is one of positions.
    bool isHolonomic() const;

    /// A factor of the equation. It changes no motion and no reaction, but what a tolerance means: by default
    /// 1; good where the factor's gradient is about 1. @throws Error if it is zero or not finite
    GeneralConstraint& setDefaultScale(SimTK::Real scale);

    /// @name Dropping the equation
    /// As PairConstraint::dropEquation(): an equation that follows from others then holds nothing and carries no
    /// load, be it the only one of a system. Needs Stage::Topology and changes Stage::Position.
    ///@{
    void dropEquation(SimTK::State& state) const;
    void restoreEquation(SimTK::State& state) const;
    bool isEquationDropped(const SimTK::State& state) const;
    /// As PairConstraint::setEquationScale(): a factor in a State, besides the default one.
    /// @throws Error if it is negative or not finite
    void setEquationScale(SimTK::State& state, SimTK::Real scale) const;
    SimTK::Real getEquationScale(const SimTK::State& state) const;
    /// The error in the default scale, also of a dropped equation. Requires the stage that the equation is about:
    /// Stage::Position of a holonomic one.
    SimTK::Real calcEquationError(const SimTK::State& state) const;
    ///@}

    /// @name Turns
    /// How far the angles AX, AY and AZ in f have turned, one number for each pair of markers and axis in f in the
    /// order in which f names them: angle/2 pi, so that the nearest whole number is the count of whole turns. See
    /// the page of Expression for how they are counted. Where f contains one angle, times a constant, f = 0 itself
    /// says in which turn it is: the nearest that the equation asks for, whatever happened before, and setting the
    /// turns changes nothing. Where it contains several times constants in the ratio of whole numbers up to 200 (a
    /// COUPLER of gears), f is likewise reduced by what whole turns can change in it, so that it does not depend on
    /// the turns remembered. An equation of dq/dt, d2q/dt2 or velocities is about none.
    ///@{
    /// Requires Stage::Position.
    SimTK::Vector getTurns(const SimTK::State& state) const;
    /// Each angle is from now on sought within half a turn of the one given; so a number read from getTurns() and a
    /// whole number serve alike. Requires Stage::Model; the State goes back to before Stage::Position.
    /// @throws Error, naming the constraint, for another number of turns or one that is not finite
    void setTurns(SimTK::State& state, const SimTK::Vector& turns) const;
    /// As in a new State: each angle within half a turn of zero.
    void resetTurns(SimTK::State& state) const;
    ///@}

    /// The load [moment, force] on the marker with this key in the expression, at its origin, in Ground or in
    /// the axes of a marker; zero if the expression does not depend on it, or the constraint is disabled.
    /// Requires Stage::Acceleration.
    SimTK::SpatialVec calcReactionOn(const SimTK::State& state, int marker) const;
    SimTK::SpatialVec calcReactionOn(const SimTK::State& state, int marker, const Marker& axes) const;

    /// The marker with this key in the expression. @throws Error if the expression does not depend on it
    const Marker& getMarker(int key) const;

    /// What keeps the equation from being met at States near this one, in words; empty if nothing does.
    /// Requires Stage::Position.
    std::string findProblem(const SimTK::State& state) const;

protected:
    /// The same for a class that is made of it.
    GeneralConstraint(const char* adamsType, const Expression& f, const std::string& name);
    GeneralConstraint(const char* adamsType, const Expression& coordinate, const Expression& function,
                      KinematicLevel level, SimTK::Real period, const std::string& name);
    static bool isOfType(const SimTK::Constraint& constraint, const char* adamsType);

private:
    friend class Joint;
    explicit GeneralConstraint(GeneralConstraintImpl* implementation);
    const GeneralConstraintImpl& getImpl() const;
    GeneralConstraintImpl& updImpl();
};

}  // namespace jprim

#endif
