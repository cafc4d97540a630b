// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_FLEXIBLE_READ_MESH_H_
#define JPRIM_FLEXIBLE_READ_MESH_H_

#include <map>
#include <string>
#include <vector>

#include "jprim/flexible/finite_element_model.h"

namespace jprim {

/// The files a mesh's matrices were read from, for messages about them.
struct MatrixFiles {
    std::string stiffness, mass;
    std::vector<int> rows;  ///< the files' row of each freedom of the model, counted from 1
};

/// A mesh of solid elements as another program wrote it: its matrices and its named sets of nodes.
struct FiniteElementMesh {
    FiniteElementModel model;  ///< three freedoms a node; named after the .inp file
    MatrixFiles files;
    /// By upper-case name; rising ids, all in `model`. A set of nodes without freedoms, which are not in
    /// `model`, is empty.
    std::map<std::string, std::vector<int>> nodeSets;
    /// What the .inp file leaves open and how it was read, and what it names but does not define. Each begins
    /// with file and line.
    std::vector<std::string> warnings;

    /// The ids of the set's nodes; case does not matter.
    /// @throws Error naming the file and the sets there are, or a set that is empty
    const std::vector<int>& getNodeSet(const std::string& name) const;
};

/// Reads a mesh that CalculiX has solved with a step `*FREQUENCY, SOLVER=MATRIXSTORAGE`.
///
/// From FILE.inp come the nodes and sets, from FILE.sti, FILE.mas and FILE.dof beside it the matrices. The
/// mesh must be free of supports and couplings, and of elements for which CalculiX invents nodes: beams,
/// shells, C3D8I. Reference nodes, which have no freedoms, are left out of the model and of the sets.
///
/// Of an .inp file, *NODE, *ELEMENT, *NSET, *ELSET, *INCLUDE, *PART, *INSTANCE and *ASSEMBLY are read; an
/// element set is also the set of its elements' nodes, unless a node set has its name. A set of the assembly
/// that names no instance holds the assembly's own nodes, as Abaqus means it; other numbers are taken as the
/// instance's, with a warning. Members that nothing defines are left out, with a warning.
///
/// The matrices are not checked beyond their form; reduceToModes() does that.
/// @throws Error with file and line
FiniteElementMesh readCalculixMesh(const std::string& inpFile);

/// Reads a mesh whose matrices Abaqus wrote in a step with `*MATRIX GENERATE, STIFFNESS, MASS` and `*MATRIX
/// OUTPUT, STIFFNESS, MASS, FORMAT=COORDINATE`.
///
/// Each line of a matrix is `row column value`, counted from 1: three translations a node, the nodes of all
/// elements in the order of their ids. Either the full matrix or one triangle. The .inp file is read as for
/// readCalculixMesh(). It may hold one instance, moved by a translation.
/// @throws Error with file and line
FiniteElementMesh readAbaqusMesh(const std::string& inpFile, const std::string& stiffnessFile,
                                 const std::string& massFile);

}  // namespace jprim

#endif
