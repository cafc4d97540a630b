// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FLEXIBLE_MESH_DEFINITION_H_
#define JPRIM_SRC_FLEXIBLE_MESH_DEFINITION_H_

#include <map>
#include <string>
#include <vector>

#include "SimTKcommon.h"

namespace jprim {

/// The geometry of a mesh as an input file defines it.
struct MeshDefinition {
    std::map<int, SimTK::Vec3> nodes;                  ///< position by id
    std::map<int, std::vector<int>> elements;          ///< an element's nodes by its id; all are defined
    std::map<std::string, std::vector<int>> nodeSets;  ///< by upper-case name; rising ids, all defined
    std::vector<std::string> warnings;                 ///< each begins with file and line
};

/// Reads the nodes, elements and sets of an Abaqus or CalculiX input file. An element set is also the set of
/// its elements' nodes, unless a node set has its name. Where a part and the assembly have a set of the same
/// name, the part's is called INSTANCE.NAME. What sets name but nothing defines is left out, with a warning.
/// @throws Error with file and line
MeshDefinition readMeshDefinition(const std::string& inpFile);

}  // namespace jprim

#endif
