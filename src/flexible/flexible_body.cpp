// SPDX-License-Identifier: Apache-2.0
#include "jprim/flexible/flexible_body.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "flexible/flexible_node.h"
#include "flexible/modal_coordinates.h"
#include "jprim/base/error.h"

namespace jprim {

using SimTK::Mat33;
using SimTK::MobilizedBody;
using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;
using SimTK::Vector;

namespace {

// A basis from a program may have been left unfinished.
void requireFinite(const ModalBasis& basis) {
    const RigidBodyProperties& rigid = basis.rigid;
    if (!std::isfinite(rigid.mass) || !rigid.center.isFinite() || !rigid.inertia.isFinite())
        throw Error(basis.name, "its mass, mass centre or inertia is not finite");
    for (size_t k = 0; k < basis.frequencies.size(); ++k)
        if (!(basis.frequencies[k] > 0) || std::isinf(basis.frequencies[k]))
            throw Error(basis.name,
                        fmt::format("the frequency of mode {} is {}; it must be positive and finite", k + 1,
                                    basis.frequencies[k]));
    for (const ModalNode& node : basis.nodes)
        if (!node.position.isFinite())
            throw Error(basis.name, fmt::format("the position of node {} is not finite", node.id));
}

SimTK::Body::Rigid makeBody(const ModalBasis& basis) {
    requireFinite(basis);
    const RigidBodyProperties& rigid = basis.rigid;
    const Mat33& I = rigid.inertia;
    if (basis.getNumModes() == 0) throw Error(basis.name, "has no modes; use a rigid body");
    if (!(rigid.mass > 0) || !(I(0, 0) > 0) || !(I(1, 1) > 0) || !(I(2, 2) > 0))
        throw Error(basis.name,
                    fmt::format("has mass {:.3g} and moments of inertia {:.3g}, {:.3g}, {:.3g}; all "
                                "must be positive",
                                rigid.mass, I(0, 0), I(1, 1), I(2, 2)));
    const SimTK::Inertia central(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
    return SimTK::Body::Rigid(SimTK::MassProperties(rigid.mass, rigid.center,
                                                    central.shiftFromMassCenter(rigid.center, rigid.mass)));
}

std::vector<Real> chooseDampingRatios(const ModalBasis& basis, std::vector<Real> ratios) {
    if (ratios.empty())
        for (const Real frequency : basis.frequencies) ratios.push_back(calcDefaultDampingRatio(frequency));
    if (int(ratios.size()) != basis.getNumModes())
        throw Error(basis.name,
                    fmt::format("{} damping ratios for {} modes", ratios.size(), basis.getNumModes()));
    for (const Real ratio : ratios)
        if (!(ratio >= 0) || std::isinf(ratio))
            throw Error(basis.name, fmt::format("a damping ratio is {}", ratio));
    return ratios;
}

const ModalBasis& requireSystem(const SimTK::SimbodyMatterSubsystem& matter,
                                const SimTK::GeneralForceSubsystem& forces, const ModalBasis& basis) {
    if (&matter.getSystem() != &forces.getSystem())
        throw Error(basis.name, "its matter and its forces belong to different systems");
    return basis;
}

}  // namespace

Real calcDefaultDampingRatio(Real frequency) {
    const Real hertz = frequency / (2 * SimTK::Pi);
    return hertz < 100 ? 0.01 : hertz < 1000 ? 0.1 : 1;
}

//--------------------------------------------------------------------------------------------- data
/// What all copies of a FlexibleBody share, in terms of the State's coordinates eta.
class FlexibleBody::Data {
public:
    Data(SimTK::SimbodyMatterSubsystem& matter, const ModalBasis& basis_, const FlexibleBodyOptions& options)
        : basis(basis_),
          dampingRatios(chooseDampingRatios(basis_, options.dampingRatios)),
          coupling(options.coupling),
          coordinates(matter, basis_.getNumModes(), basis_.rigid.mass),
          modalMass(SimTK::square(coordinates.getScale())) {
        for (const Mat33& J : basis.inertiaChange) inertiaChange.push_back(coordinates.getScale() * J);
        const int n = basis.getNumModes();
        for (int k = 0; k < n; ++k)
            for (int l = 0; l < n; ++l) gyroscopic.push_back(modalMass * basis.getGyroscopic(k, l));
    }

    // Sum over k of J_k x_k.
    Mat33 combineInertia(const Real* x) const {
        Mat33 sum(0);
        for (const Mat33& J : inertiaChange) sum += *x++ * J;
        return sum;
    }

    ModalBasis basis;
    std::vector<Real> dampingRatios;
    InertiaCoupling coupling;
    ModalCoordinates coordinates;
    Real modalMass;                    // of every eta
    std::vector<Mat33> inertiaChange;  // J_k of unit eta
    std::vector<Vec3> gyroscopic;      // n_kl of unit eta, all k and l
};

//------------------------------------------------------------------------------------------- forces
/// Stiffness and damping of the modes, and the inertia forces that couple them with the body's rotation.
class FlexibleBody::Forces final : public SimTK::Force::Custom::Implementation {
public:
    Forces(const MobilizedBody& body, std::shared_ptr<const Data> data)
        : m_body(body), m_data(std::move(data)) {}

    void calcForce(const State& state, SimTK::Vector_<SpatialVec>& bodyForces, SimTK::Vector_<Vec3>&,
                   Vector& mobilityForces) const override {
        const Data& d = *m_data;
        const Real *eta = d.coordinates.getEta(state), *etaDot = d.coordinates.getEtaDot(state);
        const int first = d.coordinates.getFirstUIndex(state);
        for (int k = 0; k < d.coordinates.getNumModes(); ++k) {
            const Real w = d.basis.frequencies[k];
            mobilityForces[first + k] -= d.modalMass * w * (w * eta[k] + 2 * d.dampingRatios[k] * etaDot[k]);
        }
        if (d.coupling == InertiaCoupling::Partial)
            addCoupling(state, eta, etaDot, &mobilityForces[first], bodyForces);
    }

    Real calcPotentialEnergy(const State& state) const override {
        const Data& d = *m_data;
        const Real* eta = d.coordinates.getEta(state);
        Real sum = 0;
        for (int k = 0; k < d.coordinates.getNumModes(); ++k)
            sum += SimTK::square(d.basis.frequencies[k] * eta[k]);
        return d.modalMass * sum / 2;
    }

private:
    void addCoupling(const State& state, const Real* eta, const Real* etaDot, Real* modalForces,
                     SimTK::Vector_<SpatialVec>& bodyForces) const {
        const Data& d = *m_data;
        const SimTK::Rotation& R_GB = m_body.getBodyRotation(state);
        const Vec3 w = ~R_GB * m_body.getBodyAngularVelocity(state);
        const int n = d.coordinates.getNumModes();
        Vec3 angularMomentum = d.combineInertia(eta) * w;
        const Vec3* n_kl = d.gyroscopic.data();
        for (int k = 0; k < n; ++k) {
            Vec3 sum(0);
            for (int l = 0; l < n; ++l) sum += etaDot[l] * *n_kl++;
            modalForces[k] += SimTK::dot(w, d.inertiaChange[k] * w) / 2 + 2 * SimTK::dot(w, sum);
            angularMomentum += eta[k] * sum;
        }
        const Vec3 moment = -(d.combineInertia(etaDot) * w + w % angularMomentum);
        bodyForces[m_body.getMobilizedBodyIndex()][0] += R_GB * moment;
    }

    MobilizedBody m_body;
    std::shared_ptr<const Data> m_data;
};

//--------------------------------------------------------------------------------------------- body
FlexibleBody::FlexibleBody(SimTK::SimbodyMatterSubsystem& matter, SimTK::GeneralForceSubsystem& forces,
                           const ModalBasis& basis, const FlexibleBodyOptions& options)
    : m_body(matter.Ground(), makeBody(requireSystem(matter, forces, basis))),
      m_data(std::make_shared<Data>(matter, basis, options)) {
    SimTK::Force::Custom(forces, new Forces(m_body, m_data));
}

const ModalBasis& FlexibleBody::getBasis() const {
    return m_data->basis;
}

int FlexibleBody::getNumModes() const {
    return m_data->coordinates.getNumModes();
}

const std::vector<Real>& FlexibleBody::getDampingRatios() const {
    return m_data->dampingRatios;
}

const std::vector<SimTK::MobilizedBodyIndex>& FlexibleBody::getCarriers() const {
    return m_data->coordinates.getCarriers();
}

namespace {
Vector scaled(const Real* values, int count, Real factor) {
    Vector result(count);
    for (int k = 0; k < count; ++k) result[k] = factor * values[k];
    return result;
}

void copyScaled(const Vector& values, int count, Real factor, const std::string& element, Real* out) {
    if (values.size() != count)
        throw Error(element, fmt::format("{} values for {} modal coordinates", values.size(), count));
    if (!std::isfinite(values.norm())) throw Error(element, "a value for a modal coordinate is not finite");
    for (int k = 0; k < count; ++k) out[k] = factor * values[k];
}
}  // namespace

Vector FlexibleBody::getModalCoordinates(const State& state) const {
    return scaled(m_data->coordinates.getEta(state), getNumModes(), m_data->coordinates.getScale());
}

Vector FlexibleBody::getModalVelocities(const State& state) const {
    return scaled(m_data->coordinates.getEtaDot(state), getNumModes(), m_data->coordinates.getScale());
}

Vector FlexibleBody::getModalAccelerations(const State& state) const {
    return scaled(m_data->coordinates.getEtaDotDot(state), getNumModes(), m_data->coordinates.getScale());
}

void FlexibleBody::setModalCoordinates(State& state, const Vector& q) const {
    copyScaled(q, getNumModes(), 1 / m_data->coordinates.getScale(), m_data->basis.name,
               m_data->coordinates.updEta(state));
}

void FlexibleBody::setModalVelocities(State& state, const Vector& qdot) const {
    copyScaled(qdot, getNumModes(), 1 / m_data->coordinates.getScale(), m_data->basis.name,
               m_data->coordinates.updEtaDot(state));
}

Real FlexibleBody::calcElasticEnergy(const State& state) const {
    const Vector q = getModalCoordinates(state);
    Real sum = 0;
    for (int k = 0; k < q.size(); ++k) sum += SimTK::square(m_data->basis.frequencies[k] * q[k]) / 2;
    return sum;
}

Real FlexibleBody::calcElasticEnergyRate(const State& state) const {
    const Vector q = getModalCoordinates(state), qdot = getModalVelocities(state);
    Real sum = 0;
    for (int k = 0; k < q.size(); ++k) sum += SimTK::square(m_data->basis.frequencies[k]) * q[k] * qdot[k];
    return sum;
}

Real FlexibleBody::calcCouplingEnergy(const State& state) const {
    if (m_data->coupling == InertiaCoupling::Constant) return 0;
    const Vec3 w = ~m_body.getBodyRotation(state) * m_body.getBodyAngularVelocity(state);
    return SimTK::dot(w, m_data->combineInertia(m_data->coordinates.getEta(state)) * w) / 2;
}

Real FlexibleBody::calcDissipation(const State& state) const {
    const Vector qdot = getModalVelocities(state);
    Real sum = 0;
    for (int k = 0; k < qdot.size(); ++k)
        sum += 2 * m_data->dampingRatios[k] * m_data->basis.frequencies[k] * SimTK::square(qdot[k]);
    return sum;
}

std::shared_ptr<const FlexibleNode> FlexibleBody::findNode(int id) const {
    return std::make_shared<FlexibleNode>(m_data->basis.getNode(id), m_data->coordinates);
}

}  // namespace jprim
