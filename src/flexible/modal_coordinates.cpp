// SPDX-License-Identifier: Apache-2.0
#include "flexible/modal_coordinates.h"

#include <algorithm>
#include <cmath>

namespace jprim {

using SimTK::MobilizedBody;
using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Transform;
using SimTK::UIndex;
using SimTK::Vec3;

namespace {

constexpr int MostModesOfACarrier = 3;
constexpr Real Spin = 1099511627776;                        // 2^40
constexpr Real MassOfACarrier = 1. / (Spin * Spin * Spin);  // 2^-120, of a unit of mass

class Carrier final : public MobilizedBody::Custom::Implementation {
public:
    Carrier(SimTK::SimbodyMatterSubsystem& matter, int numModes)
        : Implementation(matter, numModes, numModes) {}
    Implementation* clone() const override { return new Carrier(*this); }

    Transform calcMobilizerTransformFromQ(const State&, int, const Real*) const override {
        return Transform();
    }
    SpatialVec multiplyByHMatrix(const State&, int nu, const Real* u) const override {
        Vec3 w(0);
        for (int k = 0; k < nu; ++k) w[k] = Spin * u[k];
        return {w, Vec3(0)};
    }
    void multiplyByHTranspose(const State&, const SpatialVec& F, int nu, Real* f) const override {
        for (int k = 0; k < nu; ++k) f[k] = Spin * F[0][k];
    }
    SpatialVec multiplyByHDotMatrix(const State&, int, const Real*) const override {
        return SpatialVec(Vec3(0), Vec3(0));
    }
    void multiplyByHDotTranspose(const State&, const SpatialVec&, int nu, Real* f) const override {
        std::fill(f, f + nu, 0);
    }
    // Nothing that a coordinate does can be seen in space, so none is found there.
    void setQToFitTransform(const State&, const Transform&, int, Real*) const override {}
    void setUToFitVelocity(const State&, const SpatialVec&, int, Real*) const override {}
};

}  // namespace

ModalCoordinates::ModalCoordinates(SimTK::SimbodyMatterSubsystem& matter, int numModes, Real bodyMass)
    : m_numModes(numModes), m_scale(std::exp2(std::round(std::log2(bodyMass) / 2))) {
    const Real inertia = m_scale * m_scale / (Spin * Spin);
    const SimTK::Body::Rigid body(SimTK::MassProperties(
        MassOfACarrier, Vec3(0),
        SimTK::UnitInertia(inertia / MassOfACarrier, inertia / MassOfACarrier, inertia / MassOfACarrier)));
    for (int k = 0; k < numModes; k += MostModesOfACarrier) {
        const int count = std::min(MostModesOfACarrier, numModes - k);
        const MobilizedBody::Custom carrier(matter.Ground(), new Carrier(matter, count), Transform(), body,
                                            Transform());
        if (k == 0) m_first = carrier;
        m_carriers.push_back(carrier.getMobilizedBodyIndex());
    }
}

// Simbody numbers coordinates of bodies on Ground in the order in which they were added.
const Real* ModalCoordinates::getEta(const State& state) const {
    return &state.getQ(m_first.getMatterSubsystem().getMySubsystemIndex())[m_first.getFirstQIndex(state)];
}

const Real* ModalCoordinates::getEtaDot(const State& state) const {
    return &state.getU(m_first.getMatterSubsystem().getMySubsystemIndex())[getFirstUIndex(state)];
}

const Real* ModalCoordinates::getEtaDotDot(const State& state) const {
    return &state.getUDot(m_first.getMatterSubsystem().getMySubsystemIndex())[getFirstUIndex(state)];
}

Real* ModalCoordinates::updEta(State& state) const {
    return &state.updQ(m_first.getMatterSubsystem().getMySubsystemIndex())[m_first.getFirstQIndex(state)];
}

Real* ModalCoordinates::updEtaDot(State& state) const {
    return &state.updU(m_first.getMatterSubsystem().getMySubsystemIndex())[getFirstUIndex(state)];
}

UIndex ModalCoordinates::getFirstUIndex(const State& state) const {
    return m_first.getFirstUIndex(state);
}

}  // namespace jprim
