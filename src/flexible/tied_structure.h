// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FLEXIBLE_TIED_STRUCTURE_H_
#define JPRIM_SRC_FLEXIBLE_TIED_STRUCTURE_H_

#include <vector>

#include "flexible/structure.h"
#include "jprim/flexible/reduce_to_modes.h"

namespace jprim {

/// A structure whose interface nodes move with their points. Its freedoms are the six of each interface, then
/// those of all other nodes in the order of the mesh.
struct TiedStructure {
    int numInterfaceFreedoms = 0;
    SparseMatrix meshFromTied;                  ///< u of the mesh = meshFromTied * u of the tied structure
    RigidMotions rigidMotions;                  ///< in the tied structure's freedoms
    std::vector<FiniteElementNode> interfaces;  ///< id and position of each point
    std::vector<bool> isMeshNode;               ///< of each: the point is a node of the mesh
};

/// @throws Error for interfaces that reduceToModes() refuses
TiedStructure tieInterfaces(const FiniteElementModel& model, const std::vector<InterfacePoint>& interfaces);

}  // namespace jprim

#endif
