// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_LINEAR_ALGEBRA_RANDOM_VECTOR_H_
#define JPRIM_SRC_LINEAR_ALGEBRA_RANDOM_VECTOR_H_

#include <Eigen/Core>
#include <random>

namespace jprim {

/// Entries between -1 and 1, the same on every machine for the same generator. (The standard's distributions
/// are not.)
inline Eigen::VectorXd makeRandomVector(Eigen::Index size, std::mt19937& generator) {
    const auto draw = [&generator](Eigen::Index) { return 2. * generator() / double(generator.max()) - 1; };
    return Eigen::VectorXd::NullaryExpr(size, draw);
}

}  // namespace jprim

#endif
