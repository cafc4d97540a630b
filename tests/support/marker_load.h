// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_MARKER_LOAD_H_
#define JPRIM_TESTS_SUPPORT_MARKER_LOAD_H_

#include "jprim/marker/marker.h"

namespace jprim::testing {

/// A constant load [moment, force] in Ground on a marker.
class MarkerLoad : public SimTK::Force::Custom::Implementation {
public:
    MarkerLoad(const Marker& marker, const SimTK::SpatialVec& load_G) : m_marker(marker), m_load_G(load_G) {}

    void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& bodyForces,
                   SimTK::Vector_<SimTK::Vec3>&, SimTK::Vector& mobilityForces) const override {
        m_marker.applyLoad(state, m_load_G, bodyForces, mobilityForces);
    }
    SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }

private:
    Marker m_marker;
    SimTK::SpatialVec m_load_G;
};

}  // namespace jprim::testing

#endif
