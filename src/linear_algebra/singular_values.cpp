// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/singular_values.h"

#include <simmath/LinearAlgebra.h>

#include "linear_algebra/conversion.h"

namespace jprim {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// LAPACK's, by Simbody: Eigen's takes the compiler half a minute.
SimTK::FactorSVD factor(const MatrixXd& A) {
    return SimTK::FactorSVD(toSimTKMatrix(A));
}

}  // namespace

SingularValues decompose(const MatrixXd& A) {
    if (A.size() == 0)
        return {VectorXd(0), MatrixXd::Identity(A.rows(), A.rows()), MatrixXd::Identity(A.cols(), A.cols())};
    SimTK::Vector values;
    SimTK::Matrix U, transposedV;
    factor(A).getSingularValuesAndVectors(values, U, transposedV);
    return {toEigen(values), toEigen(U), toEigen(transposedV).transpose()};
}

VectorXd calcSingularValues(const MatrixXd& A) {
    if (A.size() == 0) return VectorXd(0);
    SimTK::Vector values;
    factor(A).getSingularValues(values);
    return toEigen(values);
}

}  // namespace jprim
