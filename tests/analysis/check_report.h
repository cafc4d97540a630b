// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_ANALYSIS_CHECK_REPORT_H_
#define JPRIM_TESTS_ANALYSIS_CHECK_REPORT_H_

#include <Eigen/LU>
#include <string>

#include "jprim/analysis/constraint_report.h"

namespace jprim::testing {

/// A second route to what a report says: ranks of sets of rows of Simbody's G as it is, by LU with full
/// pivoting. For regular positions and lengths of about 1.
class ReportChecker {
public:
    ReportChecker(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::State& state)
        : m_rows(0, state.getNU()) {
        matter.getSystem().realize(state, SimTK::Stage::Velocity);
        SimTK::Matrix G;
        matter.calcG(state, G);
        m_rows.resize(G.nrow(), G.ncol());
        for (int i = 0; i < G.nrow(); ++i)
            for (int j = 0; j < G.ncol(); ++j) m_rows(i, j) = G(i, j);
    }

    /// What is wrong with the report; empty if nothing is.
    std::string findContradiction(const ConstraintReport& report) const {
        std::vector<int> all(report.equations.size()), independent;
        for (int k = 0; k < int(all.size()); ++k) all[size_t(k)] = k;
        for (const int k : all)
            if (std::none_of(report.redundant.begin(), report.redundant.end(),
                             [k](const RedundantEquation& r) { return r.equation == k; }))
                independent.push_back(k);
        if (calcRank(report, all) != report.rank) return "the rank is another";
        if (int(independent.size()) != report.rank) return "not as many are redundant";
        if (calcRank(report, independent) != report.rank)
            return "without the redundant ones something is lost";
        for (const RedundantEquation& r : report.redundant) {
            const std::string text = report.equations[size_t(r.equation)].getText();
            if (calcRank(report, r.dependsOn) != int(r.dependsOn.size()))
                return text + " depends on what depends on itself";
            std::vector<int> circuit = r.dependsOn;
            circuit.push_back(r.equation);
            if (calcRank(report, circuit) != int(r.dependsOn.size())) return text + " does not follow";
            for (size_t leftOut = 0; leftOut < r.dependsOn.size(); ++leftOut) {
                std::vector<int> fewer = circuit;
                fewer.erase(fewer.begin() + int(leftOut));
                if (calcRank(report, fewer) != int(fewer.size())) return text + " follows from less";
            }
        }
        return "";
    }

private:
    int calcRank(const ConstraintReport& report, const std::vector<int>& equations) const {
        constexpr double Dependent = 1e-8;  // of the largest pivot; far from both sides at regular positions
        if (equations.empty()) return 0;
        Eigen::MatrixXd rows(int(equations.size()), m_rows.cols());
        for (int i = 0; i < rows.rows(); ++i)
            rows.row(i) = m_rows.row(report.equations[size_t(equations[size_t(i)])].multiplier);
        Eigen::FullPivLU<Eigen::MatrixXd> lu(rows);
        lu.setThreshold(Dependent);
        return int(lu.rank());
    }

    Eigen::MatrixXd m_rows;
};

}  // namespace jprim::testing

#endif
