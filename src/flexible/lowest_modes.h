// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FLEXIBLE_LOWEST_MODES_H_
#define JPRIM_SRC_FLEXIBLE_LOWEST_MODES_H_

#include <string>

#include "flexible/structure.h"

namespace jprim {

/// K + s M, factored once.
class ShiftedStiffness {
public:
    ShiftedStiffness(const SparseMatrix& K, const SparseMatrix& M, double shift);

    /// False if there is no factor because the sum is not positive definite.
    bool isDefinite() const { return m_factor.isDefinite(); }
    double getShift() const { return m_shift; }
    int getSize() const { return m_size; }
    Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const { return m_factor.solve(b); }

private:
    double m_shift;
    int m_size;
    LargeFactor m_factor;
};

/// The most modes that calcLowestModes() finds among so many freedoms: all, or a third if there are many.
int calcMostModes(int freedoms);

/// The shapes phi of the `count` lowest solutions of K phi = lambda M phi, as columns with ~phi M phi = 1.
/// @param count    at most calcMostModes()
/// @param element  what errors are about
/// @throws Error if there are not so many with finite lambda, or none are found
Eigen::MatrixXd calcLowestModes(const ShiftedStiffness& K, const SparseMatrix& M, int count,
                                const std::string& element);

}  // namespace jprim

#endif
