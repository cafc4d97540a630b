// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FLEXIBLE_INERTIA_COUPLING_H_
#define JPRIM_SRC_FLEXIBLE_INERTIA_COUPLING_H_

#include "flexible/structure.h"
#include "jprim/flexible/modal_basis.h"

namespace jprim {

/// Fills in J_k and n_kl of a basis from the mass matrix and the shapes of all freedoms of the mesh.
void addInertiaCoupling(const FiniteElementModel& model, const SparseMatrix& M, const Eigen::MatrixXd& shapes,
                        ModalBasis& basis);

}  // namespace jprim

#endif
