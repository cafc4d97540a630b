// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_MARKER_EXPRESSION_H_
#define JPRIM_MARKER_EXPRESSION_H_

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "jprim/expression/spline.h"
#include "jprim/marker/marker.h"

namespace jprim {

class MarkerExpression;

/// What an expression may name besides markers.
struct ExpressionDefinitions {
    std::map<int, InterpolatingSpline> splines;  ///< of AKISPL(x, z, id, order) and CUBSPL(x, z, id, order)
    std::map<int, std::string>
        variables;  ///< of VARVAL(id): the text of an expression that stands in its place
    /// Functions of one or two numbers, called by their names: {"K", f} lets K(DM(1,2)) stand in the text. Equations
    /// need two derivatives of them, potentials one; the values of forces none.
    std::map<std::string, std::shared_ptr<const SimTK::Function>> functions;
};

/// An Adams function expression on markers: "DM(2,1)-0.5", "UVX(2)*UVY(1)", "STEP(TIME,0,0,1,VZ(2,1,1,1))".
/// The numbers in calls are the markers' keys; 0 or nothing is Ground. A value, immutable.
///
/// Measures of markers i, j (r = r_i - r_j), in the axes of k, derivatives as seen from l; all but i may be
/// left out and are then Ground:
///
/// | function | value |
/// | --- | --- |
/// | DX DY DZ(i,j,k), DXYZ, DM(i,j) | r along an axis of k; all three; length of r |
/// | VX VY VZ(i,j,k,l), VXYZ, VM(i,j,l), VR(i,j,l) | dr/dt seen from l: v_i - v_j - w_l x r; VR along r |
/// | ACCX ACCY ACCZ(i,j,k,l), ACCXYZ, ACCM(i,j,l) | d2r/dt2 seen from l |
/// | WX WY WZ(i,j,k), WXYZ, WM(i,j) | w_i - w_j |
/// | WDTX WDTY WDTZ(i,j,k,l), WDTXYZ, WDTM(i,j,l) | d(w_i - w_j)/dt seen from l |
/// | AX AY AZ(i,j) | angle of i about an axis of j [rad]; whole turns are counted, see below |
/// | PSI THETA PHI(i,j), YAW PITCH ROLL(i,j) | body-fixed 3-1-3 and 3-2-1 angles of i in j [rad] |
/// | UVX UVY UVZ(i) | an axis of i, a vector |
/// | INCANG(i,j,k) | angle at j between the rays to i and k [rad] |
///
/// Vectors are in Ground's axes, except DXYZ and its like, whose components are along k's axes. Units are the
/// system's. Names are not case sensitive.
///
/// | written | meaning |
/// | --- | --- |
/// | 1.5, 2E-3, 30D | numbers; D: degrees, in rad |
/// | [x, y, z], UV(v) | a vector; its direction, zero of a zero vector |
/// | a+b, a-b, -a | of numbers or of vectors |
/// | a*b | of numbers, of a number and a vector, or the dot product of two vectors |
/// | v%w | cross product |
/// | a/b, a**b | a may be a vector in a/b; ** takes numbers |
/// | TIME, PI, DTOR, RTOD | time, pi, pi/180, 180/pi |
/// | ABS SQRT EXP LOG LOG10 SIN COS TAN ASIN ACOS ATAN SINH COSH TANH(x), ATAN2(y,x) | as in C; angles in rad |
/// | AINT ANINT(x), MOD SIGN DIM MIN MAX(a,b) | as in Fortran: fraction cut off, rounded; a-b trunc(a/b); abs(a) with the sign of b; max(a-b,0) |
/// | IF(x: a, b, c) | a if x is negative, b if it is zero, c if it is positive |
/// | STEP STEP5 HAVSIN(x,x0,h0,x1,h1) | from h0 at x0 to h1 at x1: cubic, quintic, half a cosine; constant outside |
/// | IMPACT(x,x',x1,k,e,cmax,d), BISTOP(x,x',x1,x2,k,e,cmax,d) | force of a one-sided and a two-sided stop |
/// | POLY(x,x0,a0,a1,...), CHEBY, FORSIN FORCOS(x,x0,w,a0,...) | power, Chebyshev and Fourier series, up to 31 coefficients |
/// | SHF(x,x0,a,w,phi,b) | a sin(w (x-x0) - phi) + b |
/// | AKISPL CUBSPL(x,z,id,order), VARVAL(id), NAME(x), NAME(x,z) | what ExpressionDefinitions gives |
///
/// Loads of elements (JOINT, SFORCE, FX and their like) and ORIENT are known in datasets alone: here the
/// calcReaction…() and calcLoad…() of elements tell them. Likewise what Adams knows and we do not (DIF, CONTACT,
/// FRICTION, USER and more) is refused.
///
/// Turns. AX, AY and AZ go on beyond half a turn. In an element (a MarkerForce, an ExpressionMeasure, a
/// GeneralConstraint) an angle is sought within half a turn of where it was at the last step that an integrator
/// completed; in a new State, within half a turn of zero. That is part of the State as a discrete variable: a copy of
/// the State has it, a State to which only time, q and u are copied has not. The elements' getTurns(), setTurns() and
/// resetTurns() read and write it; reset it where q is set back to a start. What moves a State without an integrator
/// calls state.autoUpdateDiscreteVariables() after each of its steps. An angle must not go half a turn in one
/// step: bound the step (setMaximumStepSize()) of a rotor that no force makes the integrator follow. An equation that
/// itself says in which turn its angle is (GeneralConstraint::getTurns()) remembers nothing.
///
/// Source: Adams/Solver, function expressions.
class Expression {
public:
    /// @throws Error with the column in the text and what is wrong there; or for a function among the definitions
    ///         that is null, has not one or two arguments, or a name that is taken
    Expression(const std::string& text, const std::map<int, Marker>& markers,
               const ExpressionDefinitions& definitions = {});

    /// The value of a function at TIME: the FUNCTION of a motion, for example.
    /// @throws Error if the function is null or has more than one argument
    static Expression ofTime(const std::shared_ptr<const SimTK::Function>& function);

    /// For implementing constraints and forces.
    explicit Expression(std::shared_ptr<const MarkerExpression> expression)
        : m_expression(std::move(expression)) {}
    const MarkerExpression& getImplementation() const { return *m_expression; }

    /// True if the value is a vector, false if it is a number.
    bool isVector() const;

    /// @name What the value depends on
    ///@{
    /// The highest derivative: Stage::Position, Stage::Velocity or Stage::Acceleration; Stage::Time if it depends on
    /// no marker. The calc… methods require this stage.
    SimTK::Stage getDependsOnStage() const;
    bool dependsOnTime() const;
    /// True if it is at most linear in velocities and does not depend on accelerations, as a constraint must be.
    /// Decided from the operations: v/v is not recognised as a constant.
    bool isLinearInVelocity() const;
    /// The keys of the markers, in increasing order.
    std::vector<int> getMarkers() const;
    ///@}

    /// The value in a State; AX, AY and AZ are within half a turn of zero.
    /// @throws Error from calcValue() if it is a vector, from calcVector() if it is a number
    SimTK::Real calcValue(const SimTK::State& state) const;
    SimTK::Vec3 calcVector(const SimTK::State& state) const;

private:
    std::shared_ptr<const MarkerExpression> m_expression;
};

}  // namespace jprim

#endif
