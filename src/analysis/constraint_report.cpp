// SPDX-License-Identifier: Apache-2.0
#include "jprim/analysis/constraint_report.h"

#include <Eigen/QR>

namespace jprim {

using SimTK::Matrix;
using SimTK::SimbodyMatterSubsystem;
using SimTK::State;

namespace {

// Dependent rows of an assembled mechanism cancel to about the assembly tolerance; independent ones of a
// sensible mechanism are far above.
constexpr double RankTolerance = 1e-7;

// Dividing each column by its norm takes the unit of the speed out, then each row by its the equation's.
Eigen::MatrixXd equilibrate(const Matrix& G) {
    Eigen::MatrixXd A = Eigen::Map<const Eigen::MatrixXd>(&G(0, 0), G.nrow(), G.ncol());
    const auto normalize = [](auto&& vectors) {
        for (auto vector : vectors)
            if (vector.norm() > 0) vector /= vector.norm();
    };
    normalize(A.colwise());
    normalize(A.rowwise());
    return A;
}

}  // namespace

ConstraintReport analyzeConstraints(const SimbodyMatterSubsystem& matter, const State& state) {
    ConstraintReport report;
    Matrix G;
    matter.calcG(state, G);
    report.mobilities = state.getNU();
    report.equations = G.nrow();
    if (G.nrow() == 0 || G.ncol() == 0) return report;
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(equilibrate(G).transpose());
    qr.setThreshold(RankTolerance);
    report.rank = int(qr.rank());
    return report;
}

}  // namespace jprim
