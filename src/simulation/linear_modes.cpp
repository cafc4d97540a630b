// SPDX-License-Identifier: Apache-2.0
#include "jprim/simulation/linear_modes.h"

#include <algorithm>
#include <cmath>

#include "linear_algebra/conversion.h"
#include "simulation/mode_energies.h"

namespace jprim {

using Eigen::VectorXcd;
using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::Vector;
using Complex = std::complex<double>;

namespace {

using Motion = SimTK::Vector_<SpatialVec>;

class ModeShapes {
public:
    ModeShapes(const Mechanism& mechanism, const LinearModel& model)
        : m_mechanism(mechanism), m_model(model), m_energies(mechanism, model.state) {}

    LinearMode make(const Eigenmode& eigenmode) const {
        LinearMode mode{eigenmode, {}, {}, ""};
        const VectorXcd x = Eigen::Map<const VectorXcd>(mode.x.data(), Eigen::Index(mode.x.size()));
        const VectorXcd z = toEigen(m_model.displacements) * x, u = toEigen(m_model.speeds) * x;
        mode.shape = makeShape(z);
        scale(mode);
        mode.shares = m_energies.calcShares(z, u);
        return mode;
    }

private:
    std::vector<PartShape> makeShape(const VectorXcd& z) const {
        Motion real, imaginary;
        const SimTK::SimbodyMatterSubsystem& matter = m_mechanism.getMatter();
        matter.multiplyBySystemJacobian(m_model.state, toSimTK(z.real()), real);
        matter.multiplyBySystemJacobian(m_model.state, toSimTK(z.imag()), imaginary);
        std::vector<PartShape> shapes;
        for (const MechanismPart& part : m_mechanism.getParts()) {
            if (part.ground) continue;
            const auto b = part.body.getMobilizedBodyIndex();
            const SimTK::Vec3 arm =
                part.body.getBodyRotation(m_model.state) * part.body.getBodyMassCenterStation(m_model.state);
            PartShape shape{part.name, {}, {}};
            for (int k = 0; k < 3; ++k) {
                shape.rotation[size_t(k)] = {real[b][0][k], imaginary[b][0][k]};
                shape.translation[size_t(k)] = {(real[b][1] + real[b][0] % arm)[k],
                                                (imaginary[b][1] + imaginary[b][0] % arm)[k]};
            }
            shapes.push_back(shape);
        }
        return shapes;
    }

    // The largest displacement becomes 1.
    void scale(LinearMode& mode) const {
        Complex largest = 0;
        size_t place = 0;
        constexpr double ByFar = 1 + 1e-6;  // of equal ones the first, whatever is rounded
        const auto compare = [&](const Complex& displacement) {
            if (std::abs(displacement) <= ByFar * std::abs(largest)) return;
            largest = displacement;
            mode.largestPart = mode.shape[place].part;
        };
        for (const MechanismPart& part : m_mechanism.getParts()) {
            if (part.ground) continue;
            for (const Complex& translation : mode.shape[place].translation) compare(translation);
            for (const Complex& rotation : mode.shape[place].rotation) compare(part.size * rotation);
            ++place;
        }
        if (largest == 0.) return;
        const double length = m_mechanism.getUnits().length;
        for (Complex& value : mode.x) value *= length / largest;
        for (PartShape& shape : mode.shape) {
            for (Complex& value : shape.translation) value /= largest;
            for (Complex& value : shape.rotation) value *= length / largest;
        }
    }

    const Mechanism& m_mechanism;
    const LinearModel& m_model;
    ModeEnergies m_energies;
};

// The largest error of the accelerations' derivatives, of what is largest in a row of like kind.
double calcRelativeError(const LinearModel& model) {
    const Eigen::MatrixXd A = toEigen(model.A), errors = toEigen(model.errors);
    double worst = 0;
    for (Eigen::Index j = 0; j < A.cols(); ++j) {
        const double size = A.col(j).norm();
        if (size > 0) worst = std::max(worst, errors.col(j).norm() / size);
    }
    return worst;
}

// The largest of a part: of its mass centre, of a turn by its size, or of a mode.
Real calcAcceleration(const MechanismPart& part, const LinearModel& model, const Motion& accelerations) {
    const SpatialVec& A = accelerations[part.body.getMobilizedBodyIndex()];
    const Real acceleration = std::max(A[1].norm(), part.size * A[0].norm());
    if (!part.flexible) return acceleration;
    const Real root = std::sqrt(part.body.getBodyMass(model.state));
    const Vector modal = part.flexible->getModalAccelerations(model.state);
    return std::max(acceleration, modal.normInf() / root);
}

void noteAccelerations(const Mechanism& mechanism, const LinearModel& model, LinearModes& modes) {
    constexpr Real Small = 1e-6, Rounding = 1e-10;
    Motion accelerations;
    mechanism.getMatter().multiplyBySystemJacobian(model.state, model.uDot, accelerations);
    Real fastest = 0, largest = 0, size = 0;
    const MechanismPart* accelerated = nullptr;
    for (const LinearMode& mode : modes.modes) fastest = std::max(fastest, std::norm(mode.eigenvalue));
    for (const MechanismPart& part : mechanism.getParts()) {
        if (part.ground) continue;
        size = std::max(size, part.size);
        const Real acceleration = calcAcceleration(part, model, accelerations);
        if (acceleration <= largest) continue;
        largest = acceleration;
        accelerated = &part;
    }
    modes.isMoving = model.state.getU().norm() > 0;
    const Real usual = mechanism.getGravity().norm() + size * fastest;
    if (!accelerated || largest <= Small * usual + Rounding) return;
    modes.acceleratedPart = accelerated->name;
    modes.acceleration = largest / mechanism.getUnits().getAcceleration();
}

}  // namespace

LinearModes calcLinearModes(const Mechanism& mechanism, const SimTK::State& state) {
    const LinearModel model = linearize(mechanism, state);
    const Eigenmodes eigenmodes = calcEigenmodes(model);
    LinearModes modes;
    modes.time = state.getTime() / mechanism.getUnits().time;
    modes.numStates = model.getNumStates();
    modes.numZero = eigenmodes.numZero;
    modes.relativeError = calcRelativeError(model);
    const ModeShapes shapes(mechanism, model);
    for (const Eigenmode& eigenmode : eigenmodes.modes) modes.modes.push_back(shapes.make(eigenmode));
    noteAccelerations(mechanism, model, modes);
    return modes;
}

}  // namespace jprim
