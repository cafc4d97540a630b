// SPDX-License-Identifier: Apache-2.0
#include "flexible/structure.h"

#include <cmath>

#include "base/format.h"
#include "flexible/matrix_file.h"
#include "jprim/base/error.h"

namespace jprim {

using SimTK::Vec3;

NamedMatrix::NamedMatrix(const FiniteElementModel& model, const std::vector<MatrixTerm>& terms,
                         const char* kind, const std::string& file, const std::vector<int>& rows)
    : m_model(model), m_kind(kind), m_file(file), m_rows(rows) {
    const int n = model.getNumFreedoms();
    std::vector<Eigen::Triplet<double>> triplets;
    triplets.reserve(terms.size());
    for (const MatrixTerm& term : terms) {
        if (term.row < 0 || term.row >= n || term.column < 0 || term.column >= n)
            fail(fmt::format("has a term in row {}, column {}; {} nodes with {} freedoms have rows 0 to {}",
                             term.row, term.column, model.nodes.size(), model.freedomsPerNode, n - 1));
        if (!std::isfinite(term.value))
            fail("has a term that is not a number in " + nameTerm(term.row, term.column));
        triplets.emplace_back(term.row, term.column, term.value);
    }
    m_matrix.resize(n, n);
    m_matrix.setFromTriplets(triplets.begin(), triplets.end());
}

std::string NamedMatrix::nameFreedom(int row) const {
    const int f = m_model.freedomsPerNode, axis = row % f;
    return fmt::format("node {}, {}{}", m_model.nodes[std::size_t(row / f)].id,
                       axis < 3 ? "" : "rotation about ", "xyz"[axis % 3]);
}

std::string NamedMatrix::nameRow(int row) const {
    return fmt::format("row {} ({})", getRow(row), nameFreedom(row));
}

std::string NamedMatrix::nameTerm(int row, int column) const {
    const std::string place =
        fmt::format("row {}, column {} ({}", getRow(row), getRow(column), nameFreedom(row));
    return place + (row == column ? ")" : fmt::format(" and {})", nameFreedom(column)));
}

void NamedMatrix::fail(const std::string& message) const {
    throw Error(m_file.empty() ? m_model.name : m_file, fmt::format("the {} matrix {}", m_kind, message));
}

void NamedMatrix::failAt(int row, int column, const std::string& message) const {
    if (m_file.empty()) fail(message);
    std::vector<int> lines = findLinesOfTerm(m_file, getRow(row), getRow(column));
    if (lines.empty()) lines = findLinesOfTerm(m_file, getRow(column), getRow(row));
    if (lines.empty()) fail(message);
    throw Error(fmt::format("{}:{}", m_file, lines[0]), fmt::format("the {} matrix {}", m_kind, message));
}

void NamedMatrix::failIndefinite(const Eigen::VectorXd& motion, const std::string& message) const {
    // Freedoms of different units are made comparable by their own resistance.
    Eigen::Index at = 0;
    motion.cwiseAbs2().cwiseProduct(m_matrix.diagonal()).maxCoeff(&at);
    fail(fmt::format("is not positive definite around {}{}", nameRow(int(at)), message));
}

Structure::Structure(const FiniteElementModel& finiteElements, const MatrixFiles& files)
    : model(finiteElements),
      K(model, model.stiffness, "stiffness", files.stiffness, files.rows),
      M(model, model.mass, "mass", files.mass, files.rows) {}

Eigen::Matrix<double, 1, 6> calcRigidMotion(int axis, const Vec3& offset) {
    Eigen::Matrix<double, 1, 6> motion = Eigen::Matrix<double, 1, 6>::Zero();
    motion[axis] = 1;
    if (axis >= 3) return motion;
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    motion[3 + next] = offset[last];
    motion[3 + last] = -offset[next];
    return motion;
}

RigidMotions makeRigidMotionsOfNode(int freedoms, const Vec3& offset) {
    RigidMotions R(freedoms, 6);
    for (int axis = 0; axis < freedoms; ++axis) R.row(axis) = calcRigidMotion(axis, offset);
    return R;
}

RigidMotions makeRigidMotions(const FiniteElementModel& model, const Vec3& center) {
    RigidMotions R(model.getNumFreedoms(), 6);
    for (int i = 0; i < int(model.nodes.size()); ++i)
        R.middleRows(i * model.freedomsPerNode, model.freedomsPerNode) =
            makeRigidMotionsOfNode(model.freedomsPerNode, model.nodes[i].position - center);
    return R;
}

}  // namespace jprim
