// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FLEXIBLE_NODE_ROTATIONS_H_
#define JPRIM_SRC_FLEXIBLE_NODE_ROTATIONS_H_

#include <vector>

#include "flexible/structure.h"
#include "jprim/flexible/modal_basis.h"

namespace jprim {

/// Gives rotations to the nodes of a mesh that has displacements only: half the curl of the linear field
/// fitted to the displacements of the nodes around, those that a term of the stiffness connects. Exact for
/// rotations and for uniform strain.
/// @param K      the mesh's stiffness, three freedoms a node
/// @param nodes  all nodes of the mesh, with their translations
void fitNodeRotations(const SparseMatrix& K, std::vector<ModalNode>& nodes);

}  // namespace jprim

#endif
