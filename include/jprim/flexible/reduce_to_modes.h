// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_FLEXIBLE_REDUCE_TO_MODES_H_
#define JPRIM_FLEXIBLE_REDUCE_TO_MODES_H_

#include <optional>
#include <string>
#include <vector>

#include "jprim/flexible/finite_element_model.h"
#include "jprim/flexible/modal_basis.h"
#include "jprim/flexible/read_mesh.h"

namespace jprim {

/// A point with six freedoms at which a structure is held or loaded, and the nodes that move with it as one
/// rigid piece.
struct InterfacePoint {
    /// One node of a mesh with six freedoms a node; otherwise three or more, not on one line.
    std::vector<int> nodes;
    /// The point's id among the nodes of the basis. 0 chooses: a single node's own, or for a set the next
    /// number that no node has.
    int id = 0;
    /// Where the point is; the mean of the nodes' positions if not given.
    std::optional<SimTK::Vec3> position;
    std::string name = {};  ///< appears in messages; the interface's number, from 1, if empty
};

/// Craig and Bampton's reduction, made free. Its shapes are the structure's static answer to moving each
/// freedom of each interface (six an interface), and the lowest modes of the structure held at all of them:
///
///     Psi = -inv(K_ii) K_ib,   K_ii phi = lambda M_ii phi,   T = [1 0; Psi phi]
///
/// From their span the six rigid motions are taken out, and the reduced eigenproblem
/// ~T K T y = w^2 ~T M T y makes what is left orthonormal. The result has
/// 6 * interfaces + numFixedModes - 6 modes. Without interfaces it has the numFixedModes lowest modes of the
/// free structure.
///
/// On a mesh with three freedoms a node, a node's rotation is that of the displacement field fitted to the
/// nodes around it (those its stiffness reaches).
///
/// Source: R. R. Craig, M. C. C. Bampton, Coupling of Substructures for Dynamic Analyses, AIAA Journal 6
/// (1968) 1313-1319.
///
/// @throws Error naming the model and the item: whatever checkFiniteElementModel() refuses; an interface
/// without nodes, with an unknown node, with nodes on one line, sharing a node with another; an id that is
/// taken; fewer than no modes or more than the structure has; matrices that are not positive definite once it
/// is held; a motion besides the six rigid ones that meets no resistance
ModalBasis reduceToModes(const FiniteElementModel& model, const std::vector<InterfacePoint>& interfaces,
                         int numFixedModes);

/// The same for a mesh that was read from files: what is wrong with a matrix is said of its file, in that file's
/// own rows and, for a term, with its line.
ModalBasis reduceToModes(const FiniteElementMesh& mesh, const std::vector<InterfacePoint>& interfaces,
                         int numFixedModes);

}  // namespace jprim

#endif
