// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_MARKER_EXPRESSION_H_
#define JPRIM_MARKER_EXPRESSION_H_

#include <map>
#include <memory>
#include <string>

#include "jprim/marker/marker.h"

namespace jprim {

class MarkerExpression;

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
/// | AX AY AZ(i,j) | angle of i about an axis of j [rad]; whole turns are counted where time goes on |
/// | PSI THETA PHI(i,j), YAW PITCH ROLL(i,j) | body-fixed 3-1-3 and 3-2-1 angles of i in j [rad] |
/// | UVX UVY UVZ(i) | an axis of i, a vector |
/// | INCANG(i,j,k) | angle at j between the rays to i and k [rad] |
///
/// Vectors are in Ground's axes, except DXYZ and its like, whose components are along k's axes. Source:
/// Adams/Solver, function expressions. Units are the system's.
class Expression {
public:
    /// @throws Error with the column in the text and what is wrong there
    Expression(const std::string& text, const std::map<int, Marker>& markers);

    /// For implementing constraints and forces.
    explicit Expression(std::shared_ptr<const MarkerExpression> expression)
        : m_expression(std::move(expression)) {}
    const MarkerExpression& getImplementation() const { return *m_expression; }

    /// The value of a scalar expression; AX, AY and AZ are within half a turn. Requires Stage::Position,
    /// Stage::Velocity or Stage::Acceleration, as the highest derivative in it does.
    SimTK::Real calcValue(const SimTK::State& state) const;

private:
    std::shared_ptr<const MarkerExpression> m_expression;
};

}  // namespace jprim

#endif
