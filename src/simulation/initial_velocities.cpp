// SPDX-License-Identifier: Apache-2.0
// Speeds u with G u = 0 that minimize first |C u - c|, then |u|, where the rows of C pick the given
// components c. Every part is a free body with u = [w_GB, v_GC]: its angular velocity and the velocity of its
// mass centre, both in Ground. To compare the two, angular velocities are multiplied by the part's size. Speeds
// of modes have zeros in S: they are at rest.
//
//     u = S y,  Z spans the null space of G S,  y = Z x,  x = least-norm least-squares of (C S Z) x = c
#include "simulation/initial_velocities.h"

#include <Eigen/QR>

namespace jprim {

using SimTK::Matrix;
using SimTK::Real;
using SimTK::State;
using SimTK::Vec3;
using SimTK::Vector;

namespace {

// Rows of G S that depend on the others cancel to about the assembly tolerance.
constexpr double RankTolerance = 1e-8;
// Given velocities count as admissible if they violate the constraints by no more than rounding.
constexpr double Admissible = 1e-12;

struct GivenVelocities {
    Eigen::VectorXd scale;  // the diagonal of S
    Eigen::MatrixXd C;
    Eigen::VectorXd c;
};

GivenVelocities collect(const Mechanism& mechanism, const State& state) {
    GivenVelocities given;
    given.scale = Eigen::VectorXd::Zero(state.getNU());
    std::vector<Eigen::VectorXd> rows;
    std::vector<Real> values;
    const auto add = [&](const std::optional<Real>& value, const Vec3& direction, int firstU, Real weight) {
        if (!value) return;
        Eigen::VectorXd row = Eigen::VectorXd::Zero(state.getNU());
        for (int k = 0; k < 3; ++k) row[firstU + k] = weight * direction[k];
        rows.push_back(row);
        values.push_back(weight * *value);
    };
    for (const MechanismPart& part : mechanism.getParts()) {
        if (part.ground) continue;
        const int firstU = part.body.getFirstUIndex(state);
        given.scale.segment<3>(firstU).setConstant(1 / part.size);
        given.scale.segment<3>(firstU + 3).setOnes();
        const SimTK::Rotation R_GV = part.vm.findPoseInGround(state).R();
        const SimTK::Rotation R_GW = part.wm.findPoseInGround(state).R();
        for (int k = 0; k < 3; ++k) {
            add(part.w[k], Vec3(R_GW(k)), firstU, part.size);
            add(part.v[k], Vec3(R_GV(k)), firstU + 3, 1);
        }
    }
    given.C.resize(Eigen::Index(rows.size()), state.getNU());
    for (size_t i = 0; i < rows.size(); ++i) given.C.row(Eigen::Index(i)) = rows[i];
    given.c = Eigen::Map<Eigen::VectorXd>(values.data(), Eigen::Index(values.size()));
    return given;
}

Eigen::MatrixXd calcNullSpace(const Eigen::MatrixXd& A) {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A.transpose());
    qr.setThreshold(RankTolerance);
    const Eigen::MatrixXd Q = qr.householderQ();
    return Q.rightCols(A.cols() - qr.rank());
}

}  // namespace

Vector calcInitialVelocities(const Mechanism& mechanism, const State& state) {
    const GivenVelocities given = collect(mechanism, state);
    Vector result(state.getNU(), Real(0));
    if (given.c.size() == 0 || given.c.isZero(0)) return result;

    Matrix G;
    mechanism.getMatter().calcG(state, G);
    const Eigen::MatrixXd CS = given.C * given.scale.asDiagonal();
    // The rows of C S are orthonormal: its pseudo-inverse is its transpose.
    Eigen::VectorXd y = CS.transpose() * given.c;
    if (G.nrow() > 0) {
        const Eigen::MatrixXd GS =
            Eigen::Map<const Eigen::MatrixXd>(&G(0, 0), G.nrow(), G.ncol()) * given.scale.asDiagonal();
        if ((GS * y).norm() > Admissible * y.norm()) {
            const Eigen::MatrixXd Z = calcNullSpace(GS);
            const Eigen::MatrixXd CSZ = CS * Z;
            if (Z.cols() == 0 || CSZ.norm() < RankTolerance) return result;
            y = Z * CSZ.completeOrthogonalDecomposition().solve(given.c);
        }
    }
    for (int i = 0; i < result.size(); ++i) result[i] = given.scale[i] * y[i];
    return result;
}

}  // namespace jprim
