// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_FLEXIBLE_FINITE_ELEMENT_MODEL_H_
#define JPRIM_FLEXIBLE_FINITE_ELEMENT_MODEL_H_

#include <string>
#include <vector>

#include "SimTKcommon.h"
#include "jprim/simbody_abi.h"

namespace jprim {

/// A node of a finite-element mesh. Ids are the mesh's own numbers.
struct FiniteElementNode {
    int id = 0;
    SimTK::Vec3 position;
};

/// One term of a sparse matrix; terms at the same place add up.
struct MatrixTerm {
    int row = 0;
    int column = 0;
    double value = 0;
};

/// A linear, undamped, unsupported (free-free) structure: M d2u/dt2 + K u = f.
///
/// Freedoms are numbered node by node in the order of `nodes`: the displacements x, y, z [length] and, with
/// six freedoms a node, the small rotations about x, y, z [rad]. All in the frame the nodes are given in, in
/// any consistent units. Both triangles of the symmetric matrices are stored.
struct FiniteElementModel {
    std::string name;  ///< appears in messages
    std::vector<FiniteElementNode> nodes;
    int freedomsPerNode = 6;  ///< 3 or 6
    std::vector<MatrixTerm> stiffness;
    std::vector<MatrixTerm> mass;

    int getNumFreedoms() const { return int(nodes.size()) * freedomsPerNode; }
};

/// Mass, mass centre and inertia about the mass centre of a structure that moves as a rigid body.
struct RigidBodyProperties {
    double mass = 0;
    SimTK::Vec3 center{0};
    SimTK::Mat33 inertia{0};
};

/// From the mass matrix: ~R M R, where the columns of R are the six rigid motions of the nodes.
/// @throws Error as checkFiniteElementModel() does for the mass matrix
RigidBodyProperties calcRigidBodyProperties(const FiniteElementModel& model);

/// Refuses what cannot be a free-free structure, naming the model and the item: freedoms per node other than
/// 3 or 6, no nodes, a node given twice, a term outside the matrices or not a number, an asymmetric matrix, a
/// vanishing total mass, a negative diagonal, a node that no stiffness connects to the others, a structure
/// whose rigid motions store energy because it is held somewhere.
/// @throws Error
void checkFiniteElementModel(const FiniteElementModel& model);

}  // namespace jprim

#endif
