// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FLEXIBLE_STRUCTURE_H_
#define JPRIM_SRC_FLEXIBLE_STRUCTURE_H_

#include <string>
#include <vector>

#include "jprim/flexible/read_mesh.h"
#include "linear_algebra/sparse_factor.h"

/// @file
/// Finite-element models as Eigen matrices.
namespace jprim {

using RigidMotions = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// The stiffness or the mass matrix of a model, and how messages speak of it: of the file it was read from and
/// of that file's rows, counted from 1; of the model and its rows, counted from 0, if there is no file.
class NamedMatrix {
public:
    /// Adds up the terms that stand at the same place.
    /// @param kind  "stiffness" or "mass"
    /// @param file  empty if there is none
    /// @param rows  the file's row of each freedom
    /// @throws Error for a term outside or not a number
    NamedMatrix(const FiniteElementModel& model, const std::vector<MatrixTerm>& terms, const char* kind,
                const std::string& file, const std::vector<int>& rows);

    const SparseMatrix& get() const { return m_matrix; }
    const std::string& getKind() const { return m_kind; }

    /// `row 3 (node 7, z)`
    std::string nameRow(int row) const;
    /// `row 3, column 1 (node 7, z and node 5, x)`
    std::string nameTerm(int row, int column) const;

    /// Refuses the matrix: `file: the stiffness matrix MESSAGE`.
    [[noreturn]] void fail(const std::string& message) const;
    /// The same with the line of the term, or of its mirror image: `file:line: the stiffness matrix MESSAGE`.
    [[noreturn]] void failAt(int row, int column, const std::string& message) const;
    /// Says that the matrix is not positive definite.
    /// @param motion   displacements of all freedoms that meet no positive resistance; it names the node
    /// @param message  completes `is not positive definite around row 3 (node 7, z)`
    [[noreturn]] void failIndefinite(const Eigen::VectorXd& motion, const std::string& message) const;

private:
    std::string nameFreedom(int row) const;
    int getRow(int row) const { return m_file.empty() ? row : m_rows[std::size_t(row)]; }

    const FiniteElementModel& m_model;
    std::string m_kind, m_file;
    const std::vector<int>& m_rows;
    SparseMatrix m_matrix;
};

/// A model with its matrices.
struct Structure {
    /// @param files  where the matrices come from, if from files
    explicit Structure(const FiniteElementModel& model, const MatrixFiles& files = {});

    const FiniteElementModel& model;
    NamedMatrix K, M;
};

/// What checkFiniteElementModel() does for the nodes. @throws Error
void checkNodes(const FiniteElementModel& model);

/// What checkFiniteElementModel() does for the matrices. @throws Error
void checkStructure(const Structure& structure);

/// Displacements of all freedoms in the six unit motions about a centre: translations, then rotations.
RigidMotions makeRigidMotions(const FiniteElementModel& model, const SimTK::Vec3& center = SimTK::Vec3(0));

/// One freedom of a node at `offset` from the centre of each unit motion.
/// @param axis  0 to 2 for a displacement, 3 to 5 for a rotation
Eigen::Matrix<double, 1, 6> calcRigidMotion(int axis, const SimTK::Vec3& offset);

/// The freedoms of a node at `offset` from the centre of a unit motion, as rows: three or six.
RigidMotions makeRigidMotionsOfNode(int freedoms, const SimTK::Vec3& offset);

/// From the mass matrix: ~R M R. @throws Error if that is no rigid body's
RigidBodyProperties calcRigidBodyProperties(const Structure& structure);

}  // namespace jprim

#endif
