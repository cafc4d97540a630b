// SPDX-License-Identifier: Apache-2.0
#include "mechanism/mobilizers.h"

#include <type_traits>

#include "jprim/marker/marker_pair.h"

namespace jprim {

using SimTK::Body;
using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Transform;
using SimTK::UnitVec3;
using SimTK::Vec3;

namespace {

// The frame whose x, y and z axes are the given ones of another; exact.
Rotation makeCycle(SimTK::CoordinateAxis x) {
    return Rotation(UnitVec3(x), SimTK::XAxis, Vec3(UnitVec3(x.getNextAxis())), SimTK::YAxis);
}

/// How a mobilizer's frames stand to the markers'.
struct Turns {
    Rotation ofI, ofJ;
};

// Simbody's Slider goes along x; its Universal turns about x of J's frame and y of I's.
Turns getTurns(MobilizerType type) {
    switch (type) {
        case MobilizerType::Slider: return {makeCycle(SimTK::ZAxis), makeCycle(SimTK::ZAxis)};
        case MobilizerType::Universal: return {makeCycle(SimTK::YAxis), makeCycle(SimTK::ZAxis)};
        case MobilizerType::Hooke: return {makeCycle(SimTK::ZAxis), makeCycle(SimTK::YAxis)};
        default: return {};
    }
}

template <class Type>
MobilizedBody add(MobilizedBody& parent, const Transform& X_PF, const Body& body, const Transform& X_BM,
                  [[maybe_unused]] MobilizedBody::Direction direction) {
    if constexpr (std::is_same_v<Type, MobilizedBody::Weld>)
        return Type(parent, X_PF, body, X_BM);  // the same in both directions
    else
        return Type(parent, X_PF, body, X_BM, direction);
}

auto getFactory(MobilizerType type) {
    switch (type) {
        case MobilizerType::Free: return add<MobilizedBody::Free>;
        case MobilizerType::Weld: return add<MobilizedBody::Weld>;
        case MobilizerType::Pin: return add<MobilizedBody::Pin>;
        case MobilizerType::Slider: return add<MobilizedBody::Slider>;
        case MobilizerType::Universal:
        case MobilizerType::Hooke: return add<MobilizedBody::Universal>;
        case MobilizerType::Cylinder: return add<MobilizedBody::Cylinder>;
        case MobilizerType::Ball: return add<MobilizedBody::Ball>;
        case MobilizerType::Planar: return add<MobilizedBody::Planar>;
        case MobilizerType::Translation: break;
    }
    return add<MobilizedBody::Translation>;
}

Transform turn(const Transform& X, const Rotation& R) {
    return Transform(X.R() * R, X.p());
}

}  // namespace

MobilizedBody addMobilizer(const PlannedMobilizer& planned, MobilizedBody& parent, const Transform& X_PF,
                           const Body& body, const Transform& X_BM) {
    const Turns turns = getTurns(planned.type);
    const bool reversed = planned.reversed;
    return getFactory(planned.type)(parent, turn(X_PF, reversed ? turns.ofI : turns.ofJ), body,
                                    turn(X_BM, reversed ? turns.ofJ : turns.ofI),
                                    reversed ? MobilizedBody::Reverse : MobilizedBody::Forward);
}

SpatialVec TreeJoint::calcLoadOnI(const State& state, LoadShare share) const {
    SpatialVec load = m_body.findMobilizerReactionOnBodyAtMInGround(state);
    if (m_reversed) load = calcOppositeLoad(load, -calcLever(state));
    if (share == LoadShare::Force) load[0] = Vec3(0);
    if (share == LoadShare::Moment) load[1] = Vec3(0);
    return load;
}

SpatialVec TreeJoint::calcLoadOnJ(const State& state, LoadShare share) const {
    return calcOppositeLoad(calcLoadOnI(state, share), calcLever(state));
}

}  // namespace jprim
