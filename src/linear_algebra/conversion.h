// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_LINEAR_ALGEBRA_CONVERSION_H_
#define JPRIM_SRC_LINEAR_ALGEBRA_CONVERSION_H_

#include <SimTKcommon.h>

#include <Eigen/Core>

/// @file
/// Simbody's vectors and matrices as Eigen's, and back.
namespace jprim {

inline Eigen::Vector3d toEigen(const SimTK::Vec3& v) {
    return {v[0], v[1], v[2]};
}

inline Eigen::Matrix3d toEigen(const SimTK::Mat33& m) {
    Eigen::Matrix3d result;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) result(i, j) = m(i, j);
    return result;
}

inline Eigen::VectorXd toEigen(const SimTK::Vector& v) {
    Eigen::VectorXd result(v.size());
    for (int i = 0; i < v.size(); ++i) result[i] = v[i];
    return result;
}

inline Eigen::MatrixXd toEigen(const SimTK::Matrix& m) {
    if (m.nelt() == 0) return Eigen::MatrixXd(m.nrow(), m.ncol());
    return Eigen::Map<const Eigen::MatrixXd>(&m(0, 0), m.nrow(), m.ncol());
}

inline SimTK::Vec3 toVec3(const Eigen::Vector3d& v) {
    return {v[0], v[1], v[2]};
}

inline SimTK::Matrix toSimTKMatrix(const Eigen::MatrixXd& m) {
    const Eigen::MatrixXd byRow = m.transpose();  // as Simbody reads it
    return SimTK::Matrix(int(m.rows()), int(m.cols()), byRow.data());
}

inline SimTK::Vector toSimTK(const Eigen::VectorXd& v) {
    return SimTK::Vector(int(v.size()), v.data());
}

}  // namespace jprim

#endif
