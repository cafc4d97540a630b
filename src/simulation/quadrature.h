// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_QUADRATURE_H_
#define JPRIM_SRC_SIMULATION_QUADRATURE_H_

#include "SimTKsimbody.h"

namespace jprim {

/// Integrates the last of a State's z, the work, on which nothing depends, over steps of a method that does not do so as
/// well as it integrates the motion: CPodes iterates until the motion has converged, whatever is left of errors elsewhere. Between the ends of
/// a step the motion is taken for the polynomials of fifth degree with the coordinates, rates and accelerations there,
/// and rates of z are sampled at Lobatto's four points, which is of sixth order in the step. Where that does not tell of
/// all that happens in a step, such as a contact that a motor presses together, it is halved.
class Quadrature {
public:
    /// @param isOfLowOrder  true of a method whose rates are better than its coordinates
    Quadrature(const SimTK::MultibodySystem& system, bool isOfLowOrder)
        : m_system(system), m_isOfLowOrder(isOfLowOrder) {}

    /// Where a motion begins. Requires Stage::Acceleration, like advance().
    void start(const SimTK::State& state);
    /// Puts the work at the end of a step in its place.
    void advance(SimTK::State& state);

private:
    /// Coordinates, states and work, with their rates.
    struct Moment {
        SimTK::Real time;
        SimTK::Vector q, qDot, qDotDot, z, zDot;

        SimTK::Real getPower() const { return zDot[zDot.size() - 1]; }
    };

    static Moment makeMoment(const SimTK::State& state);
    SimTK::Vector calcWay(const Moment& end) const;
    SimTK::Real calcRateBetween(const Moment& end, SimTK::Real fraction);
    /// Between two fractions of a step, from the rates there.
    SimTK::Real calcIntegral(const Moment& end, SimTK::Real a, SimTK::Real rateA, SimTK::Real b,
                             SimTK::Real rateB, int halvings);

    const SimTK::MultibodySystem& m_system;
    bool m_isOfLowOrder;
    Moment m_start;
    SimTK::Vector m_way;         // of the coordinates in a step
    SimTK::Real m_turnover = 0;  // what has been integrated, whatever its sign
    SimTK::State m_between;
};

}  // namespace jprim

#endif
