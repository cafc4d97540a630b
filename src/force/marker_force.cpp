// SPDX-License-Identifier: Apache-2.0
#include "jprim/force/marker_force.h"

#include "force/marker_force_impl.h"
#include "marker/find_implementation.h"

namespace jprim {

using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;
using SimTK::Vector;

MarkerForce::MarkerForce(SimTK::GeneralForceSubsystem& forces, MarkerForceImpl* implementation)
    : TypedHandle(forces, implementation) {}

MarkerForce::MarkerForce(SimTK::GeneralForceSubsystem& forces, const Marker& I,
                         const std::optional<Marker>& J, const ForceLaw& law, const std::string& name)
    : MarkerForce(forces, new MarkerForceImpl(forces, I, J, law, name)) {}

const MarkerForceImpl& MarkerForce::getImpl() const {
    return static_cast<const MarkerForceImpl&>(getImplementation());
}

bool MarkerForce::isInstanceOf(const SimTK::Force& force) {
    return findImplementation<MarkerForceImpl>(force) != nullptr;
}

std::string MarkerForce::getDescription() const {
    return getImpl().getDescription();
}

const std::string& MarkerForce::getName() const {
    return getImpl().getName();
}

SpatialVec MarkerForce::calcLoadOnI(const State& state) const {
    return getImpl().isDisabled(state, getForceIndex()) ? SpatialVec(Vec3(0), Vec3(0))
                                                        : getImpl().calcLoadOnI(state);
}

SpatialVec MarkerForce::calcLoadOnJ(const State& state) const {
    return getImpl().isDisabled(state, getForceIndex()) ? SpatialVec(Vec3(0), Vec3(0))
                                                        : getImpl().calcLoadOnJ(state);
}

Vector MarkerForce::getTurns(const State& state) const {
    return getImpl().getTurns(state);
}

void MarkerForce::setTurns(State& state, const Vector& turns) const {
    getImpl().setTurns(state, turns);
}

void MarkerForce::resetTurns(State& state) const {
    setTurns(state, Vector(getImpl().getNumAngles(), SimTK::Real(0)));
}

SimTK::Real MarkerForce::calcPotentialRate(const State& state) const {
    return getImpl().isDisabled(state, getForceIndex()) ? 0 : getImpl().calcPotentialRate(state);
}

}  // namespace jprim
