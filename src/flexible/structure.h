// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FLEXIBLE_STRUCTURE_H_
#define JPRIM_SRC_FLEXIBLE_STRUCTURE_H_

#include <Eigen/SparseCore>
#include <vector>

#include "jprim/flexible/finite_element_model.h"

/// @file
/// Finite-element models as Eigen matrices.
namespace jprim {

using SparseMatrix = Eigen::SparseMatrix<double>;
using RigidMotions = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// Terms that stand at the same place added up. @throws Error for a term outside or not a number
SparseMatrix makeMatrix(const FiniteElementModel& model, const std::vector<MatrixTerm>& terms,
                        const char* what);

/// Displacements of all freedoms in the six unit motions about the origin: translations, then rotations.
RigidMotions makeRigidMotions(const FiniteElementModel& model);

/// The freedoms of a node at `offset` from the centre of a unit motion, as rows: three or six.
Eigen::Matrix<double, Eigen::Dynamic, 6> makeRigidMotionsOfNode(int freedoms, const SimTK::Vec3& offset);

}  // namespace jprim

#endif
