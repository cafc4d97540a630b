// SPDX-License-Identifier: Apache-2.0
// Speeds u with G u = b that minimize first |C u - c|, then |u|, where the rows of C pick the given
// components c and b is what time-dependent constraints demand. Every part is a free body with
// u = [w_GB, v_GC], its angular velocity and the velocity of its mass centre. To compare the two, angular
// velocities are multiplied by the part's size. Speeds of modes have zeros in S: they are at rest.
//
//     u = S y,  (G S) p = b,  Z spans the null space of G S,  y = p + Z x,
//     x = least-norm least-squares of (C S Z) x = c - C S p
#include "simulation/initial_velocities.h"

#include <Eigen/QR>

#include "marker/marker_expression.h"
#include "simulation/constraint_jacobian.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;
using SimTK::Vector;

namespace {

// Given velocities count as admissible if they violate the constraints by no more than rounding.
constexpr double Admissible = 1e-12;

struct GivenVelocities {
    Eigen::VectorXd scale;  // the diagonal of S
    Eigen::MatrixXd C;
    Eigen::VectorXd c;
    bool isOrthonormal = true;  // the rows of C S
};

class Collector {
public:
    Collector(const Mechanism& mechanism, const State& state)
        : m_matter(mechanism.getMatter()), m_state(state) {
        m_given.scale = Eigen::VectorXd::Zero(state.getNU());
        for (const MechanismPart& part : mechanism.getParts())
            if (!part.ground) addPart(part);
        for (const InitialCoordinate& given : mechanism.getInitialCoordinates())
            if (given.rate) addRate(given.coordinate.getImplementation(), *given.rate);
    }

    GivenVelocities finish() {
        m_given.C.resize(Eigen::Index(m_rows.size()), m_state.getNU());
        for (size_t i = 0; i < m_rows.size(); ++i) m_given.C.row(Eigen::Index(i)) = m_rows[i];
        m_given.c = Eigen::Map<Eigen::VectorXd>(m_values.data(), Eigen::Index(m_values.size()));
        return std::move(m_given);
    }

private:
    void addPart(const MechanismPart& part) {
        const int firstU = part.body.getFirstUIndex(m_state), turns = part.turns ? 3 : 0;
        m_given.scale.segment(firstU, turns).setConstant(1 / part.size);
        m_given.scale.segment<3>(firstU + turns).setOnes();
        const SimTK::Rotation R_GV = part.vm.findPoseInGround(m_state).R();
        const SimTK::Rotation R_GW = part.wm.findPoseInGround(m_state).R();
        for (int k = 0; k < 3; ++k) {
            if (part.w[k] && part.turns)
                addRow(part, SpatialVec(part.size * Vec3(R_GW(k)), Vec3(0)), part.size * *part.w[k]);
            if (part.v[k]) addRow(part, SpatialVec(Vec3(0), Vec3(R_GV(k))), *part.v[k]);
        }
    }

    // The row that multiplies u to direction . V of the part's body.
    void addRow(const MechanismPart& part, const SpatialVec& direction, Real value) {
        SimTK::Vector_<SpatialVec> directions(m_matter.getNumBodies(), SpatialVec(Vec3(0), Vec3(0)));
        directions[part.body.getMobilizedBodyIndex()] = direction;
        addRow(directions, Vector(m_state.getNU(), Real(0)), value);
    }

    void addRow(const SimTK::Vector_<SpatialVec>& directions, const Vector& onSpeeds, Real value) {
        Vector row;
        m_matter.multiplyBySystemJacobianTranspose(m_state, directions, row);
        row += onSpeeds;
        m_rows.emplace_back(Eigen::Map<const Eigen::VectorXd>(&row[0], row.size()));
        m_values.push_back(value);
    }

    // The rate of a coordinate: the sum of direction . V over its markers.
    void addRate(const MarkerExpression& q, Real rate) {
        Evaluation evaluation(q.program);
        q.setInputs(m_state, evaluation);
        evaluation.calcValue();
        evaluation.calcGradient();
        std::vector<MarkerMotion> motions(q.markers.size());
        for (size_t k = 0; k < motions.size(); ++k) motions[k].X = q.markers[k].findPoseInGround(m_state);
        SimTK::Vector_<SpatialVec> directions(m_matter.getNumBodies(), SpatialVec(Vec3(0), Vec3(0)));
        Vector onSpeeds(m_state.getNU(), Real(0));
        for (size_t k = 0; k < motions.size(); ++k)
            q.markers[k].applyLoad(m_state, q.getDirection(evaluation, motions.data(), int(k)), directions,
                                   onSpeeds);
        addRow(directions, onSpeeds, rate);
        m_given.isOrthonormal = false;
    }

    const SimTK::SimbodyMatterSubsystem& m_matter;
    const State& m_state;
    GivenVelocities m_given;
    std::vector<Eigen::VectorXd> m_rows;
    std::vector<Real> m_values;
};

// G u - b, of the equations on velocities.
Eigen::VectorXd calcErrors(const Mechanism& mechanism, State& state, const Eigen::VectorXd& u) {
    for (int i = 0; i < state.getNU(); ++i) state.updU()[i] = u[i];
    mechanism.getSystem().realize(state, SimTK::Stage::Velocity);
    const Vector& errors = state.getUErr();
    Eigen::VectorXd result(errors.size());
    for (int k = 0; k < errors.size(); ++k) result[k] = errors[k];
    return result;
}

Eigen::VectorXd solveLeastNorm(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(JacobianRankTolerance);
    return decomposition.compute(A).solve(b);
}

// y, see above.
Eigen::VectorXd solve(const Eigen::MatrixXd& GS, const Eigen::VectorXd& b, const GivenVelocities& given) {
    const Eigen::MatrixXd CS = given.C * given.scale.asDiagonal();
    Eigen::VectorXd p = Eigen::VectorXd::Zero(GS.cols());
    if (!b.isZero(0)) p = solveLeastNorm(GS, b);
    const Eigen::MatrixXd Z = calcNullSpace(GS);
    const Eigen::MatrixXd CSZ = CS * Z;
    if (Z.cols() == 0 || CSZ.norm() < JacobianRankTolerance) return p;
    return p + Z * CSZ.completeOrthogonalDecomposition().solve(given.c - CS * p);
}

}  // namespace

Vector calcInitialVelocities(const Mechanism& mechanism, const State& positions) {
    State state = positions;
    mechanism.getSystem().realize(state, SimTK::Stage::Position);  // a copy has forgotten that it was
    const GivenVelocities given = Collector(mechanism, state).finish();
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(state.getNU());
    const Eigen::VectorXd b = -calcErrors(mechanism, state, rest);
    Eigen::VectorXd u = rest;
    if (given.isOrthonormal)  // the pseudo-inverse of C S is its transpose
        u = given.scale.cwiseAbs2().asDiagonal() * (given.C.transpose() * given.c);
    const bool isAdmissible =
        given.isOrthonormal && calcErrors(mechanism, state, u).norm() <= Admissible * u.norm();
    if (!isAdmissible) {
        const Eigen::MatrixXd GS =
            calcConstraintJacobian(mechanism, state, b.size()) * given.scale.asDiagonal();
        u = given.scale.asDiagonal() * solve(GS, b, given);
    }
    return Vector(int(u.size()), u.data());
}

}  // namespace jprim
