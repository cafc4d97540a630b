// SPDX-License-Identifier: Apache-2.0
#include "analysis/scaled_equations.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "analysis/body_jacobian.h"

namespace jprim {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using SimTK::SimbodyMatterSubsystem;
using SimTK::SpatialVec;
using SimTK::Stage;
using SimTK::State;

namespace {

// Rounding errors, of what they are beside; and an equation that a turn of 1 rad or a shift of 1 does not change.
constexpr double Rounding = 1e-12, Nothing = 1e-14;

// The size of one unit of each speed: the angular velocity that it is, or else the velocity.
struct Mobilities {
    VectorXd angular, linear;
};

Mobilities measureMobilities(const SimbodyMatterSubsystem& matter, const State& state) {
    Mobilities sizes{VectorXd::Zero(state.getNU()), VectorXd::Zero(state.getNU())};
    for (SimTK::MobilizedBodyIndex b(1); b < matter.getNumBodies(); ++b) {
        const SimTK::MobilizedBody& body = matter.getMobilizedBody(b);
        for (SimTK::MobilizerUIndex k(0); k < body.getNumU(state); ++k) {
            const SimTK::SpatialVec V = body.getHCol(state, k);
            const int j = int(body.getFirstUIndex(state)) + int(k);
            sizes.angular[j] = V[0].norm();
            sizes.linear[j] = sizes.angular[j] > 0 ? 0 : V[1].norm();
        }
    }
    return sizes;
}

// What a turn of 1 rad and a shift of 1 length unit of all bodies do to each equation.
struct RowSizes {
    VectorXd turn, shift;
};

// What one unit of each speed and of each multiplier are, body by body: the motions V and the loads F whose powers,
// added up, are the entries of G. What a tree takes out of G is still there in the loads and in each of the powers.
class Powers {
public:
    Powers(const SimbodyMatterSubsystem& matter, const State& state,
           const std::vector<ConstraintEquation>& equations)
        : m_loads(calcEquationLoads(matter, state, equations)), m_numSpeeds(state.getNU()) {}

    // Coordinates with loads of their own count as what they move. What rounding leaves of a shift does not count.
    RowSizes measureRows(const Mobilities& sizes) const {
        RowSizes rows{VectorXd::Zero(int(m_loads.size())), VectorXd::Zero(int(m_loads.size()))};
        for (int i = 0; i < rows.turn.size(); ++i) {
            double turn = 0, shift = 0;
            for (const auto& [body, F] : m_loads[size_t(i)].onBodies) {
                if (body == SimTK::GroundIndex) continue;
                turn += F[0].normSqr();
                shift += F[1].normSqr();
            }
            for (const auto& [j, f] : m_loads[size_t(i)].onSpeeds) {
                if (sizes.angular[j] > 0) turn += SimTK::square(f / sizes.angular[j]);
                if (sizes.linear[j] > 0) shift += SimTK::square(f / sizes.linear[j]);
            }
            rows.turn[i] = std::sqrt(turn);
            rows.shift[i] = std::sqrt(shift) > Rounding * rows.turn[i] ? std::sqrt(shift) : 0;
        }
        return rows;
    }

    // The sum of the sizes of all powers in each entry of G.
    MatrixXd measureEntries(const SimbodyMatterSubsystem& matter, const State& state) const {
        MatrixXd sizes = MatrixXd::Zero(int(m_loads.size()), m_numSpeeds);
        for (int i = 0; i < sizes.rows(); ++i)
            for (const auto& [j, f] : m_loads[size_t(i)].onSpeeds) sizes(i, j) = std::abs(f);
        SimTK::Vector u(m_numSpeeds, SimTK::Real(0));
        SimTK::Vector_<SpatialVec> V;
        for (int j = 0; j < sizes.cols(); ++j) {
            u[j] = 1;
            matter.multiplyBySystemJacobian(state, u, V);
            u[j] = 0;
            for (int i = 0; i < sizes.rows(); ++i)
                for (const auto& [body, F] : m_loads[size_t(i)].onBodies)
                    sizes(i, j) += V[body][0].norm() * F[0].norm() + V[body][1].norm() * F[1].norm();
        }
        return sizes;
    }

private:
    std::vector<EquationLoads> m_loads;
    int m_numSpeeds;
};

// The root mean square of all levers: what an equation says about a turn by what it says about a shift.
double calcLength(const RowSizes& rows) {
    double turns = 0, shifts = 0;
    for (int i = 0; i < rows.shift.size(); ++i) {
        if (rows.shift[i] == 0) continue;
        turns += rows.turn[i] * rows.turn[i];
        shifts += rows.shift[i] * rows.shift[i];
    }
    return turns > 0 ? std::sqrt(turns / shifts) : 1;
}

}  // namespace

ScaledEquations::ScaledEquations(const SimbodyMatterSubsystem& matter,
                                 std::vector<ConstraintEquation> equations, const State& state)
    : m_matter(matter), m_equations(std::move(equations)) {
    realize(state);
    const Powers powers(matter, state, m_equations);
    const RowSizes rows = powers.measureRows(measureMobilities(matter, state));
    const VectorXd sizes = (rows.shift.array() > 0).select(calcLength(rows) * rows.shift, rows.turn);
    // Rows and columns of nothing but rounding errors must not be made as long as the others.
    const auto invert = [](const VectorXd& lengths) -> VectorXd {
        const double noise = lengths.size() > 0 ? std::max(Nothing, Rounding * lengths.maxCoeff()) : 0;
        return lengths.unaryExpr([noise](double size) { return size > noise ? 1 / size : 1; });
    };
    m_rowScale = invert(sizes);
    const MatrixXd entries = powers.measureEntries(matter, state);
    m_columnScale = invert((m_rowScale.asDiagonal() * entries).colwise().norm().transpose());
    m_noise = Rounding * entries;
}

void ScaledEquations::realize(const State& state) const {
    m_matter.getSystem().realize(state, Stage::Velocity);
}

MatrixXd ScaledEquations::calcCleanJacobian(const State& state) const {
    realize(state);
    const BodyJacobian bodies(m_matter, state);
    BodyJacobian::Triplets entries;
    int row = 0;
    for (const EquationLoads& loads : calcEquationLoads(m_matter, state, m_equations))
        bodies.addRow(loads, 1, row++, entries);
    MatrixXd A = MatrixXd::Zero(int(m_equations.size()), state.getNU());
    for (const Eigen::Triplet<double>& entry : entries) A(entry.row(), entry.col()) += entry.value();
    return (A.array().abs() > m_noise.array()).select(A, 0);
}

MatrixXd ScaledEquations::calcJacobian(const State& state) const {
    return m_rowScale.asDiagonal() * calcCleanJacobian(state) * m_columnScale.asDiagonal();
}

VectorXd ScaledEquations::calcErrors(const State& state) const {
    realize(state);
    VectorXd errors = VectorXd::Zero(int(m_equations.size()));
    for (int i = 0; i < errors.size(); ++i) {
        const ConstraintEquation& equation = m_equations[size_t(i)];
        if (equation.level == KinematicLevel::Position)
            errors[i] = m_rowScale[i] * state.getQErr()[equation.multiplier];
    }
    return errors;
}

VectorXd ScaledEquations::calcRateErrors(const State& state) const {
    realize(state);
    VectorXd errors = VectorXd::Zero(int(m_equations.size()));
    for (int i = 0; i < errors.size(); ++i) {
        const ConstraintEquation& equation = m_equations[size_t(i)];
        if (equation.level != KinematicLevel::Acceleration)
            errors[i] = m_rowScale[i] * state.getUErr()[equation.multiplier];
    }
    return errors;
}

State ScaledEquations::move(const State& state, const VectorXd& u) const {
    realize(state);
    SimTK::Vector change;
    m_matter.multiplyByN(state, false, SimTK::Vector(int(u.size()), u.data()), change);
    State moved = state;
    moved.updQ() += change;
    m_matter.getSystem().realize(moved, Stage::Time);
    m_matter.normalizeQuaternions(moved);
    return moved;
}

std::vector<ConstraintEquation> selectHolonomic(const std::vector<ConstraintEquation>& equations) {
    std::vector<ConstraintEquation> selected;
    std::copy_if(equations.begin(), equations.end(), std::back_inserter(selected),
                 [](const ConstraintEquation& e) { return e.level == KinematicLevel::Position; });
    return selected;
}

}  // namespace jprim
