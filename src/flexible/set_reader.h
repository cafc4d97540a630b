// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FLEXIBLE_SET_READER_H_
#define JPRIM_SRC_FLEXIBLE_SET_READER_H_

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "flexible/keyword_file.h"
#include "flexible/mesh_definition.h"
#include "flexible/mesh_sets.h"
#include "flexible/set_members.h"

namespace jprim {

/// Reads *NSET and *ELSET of an input file, and knows where the file is: in the part or its only instance, or in the
/// assembly around it.
class SetReader {
public:
    /// @param file  at the line to read whenever a function is called
    /// @param mesh  with the nodes and elements above that line; receives sets and warnings
    SetReader(const KeywordFile& file, MeshDefinition& mesh) : m_file(file), m_mesh(mesh) {}

    void beginInstance();
    void setInAssembly(bool inAssembly);
    /// What follows the assembly is as far from the part as the assembly, if there is a part.
    void endAssembly() { setInAssembly(m_hasInstance); }
    bool isInAssembly() const { return m_inAssembly; }

    /// The set that a keyword's parameter names, made if there is none of this name.
    std::vector<int>& openNodeSet() { return openSet("NSET", m_nodeSets); }
    std::vector<int>& openElementSet() { return openSet("ELSET", m_elementSets); }

    /// Begins *NSET or *ELSET.
    void beginSet();
    /// Reads a line of it.
    void readData();

    /// Notes a node or an element of the assembly itself: a reference point or a connector.
    void addOwnNode(int id) { m_ownNodes.insert(id); }
    void addOwnElement(int id) { m_ownElements.insert(id); }

    /// Gives the mesh its sets, when all nodes and elements are known.
    void finish();

private:
    /// An element whose nodes a set of nodes asks for above its definition.
    struct Premature {
        std::string where;
        int element;
    };

    void readMembers();
    void readRange();
    void addMember(int id, bool namesInstance);
    void addNodesOfElements();
    bool isOfNodes() const { return m_file.getKeyword() == "NSET"; }
    SetMembers& updMembers() { return isOfNodes() ? m_nodeMembers : m_elementMembers; }
    std::vector<int>& openSet(const char* parameter, MeshSets& sets);
    const std::vector<int>& findSet(std::string_view name, const MeshSets& sets) const;

    const KeywordFile& m_file;
    MeshDefinition& m_mesh;
    MeshSets m_nodeSets, m_elementSets;
    SetMembers m_nodeMembers{"node"}, m_elementMembers{"element"};
    std::set<int> m_ownNodes, m_ownElements;
    std::vector<Premature> m_premature;
    std::string m_instance;
    bool m_hasInstance = false;
    bool m_inAssembly = false;          // and not in its instance
    std::vector<int>* m_set = nullptr;  // the set the block adds to
    std::string m_where;                // its keyword's line
    bool m_isAssumed = false;           // that a number in it is the instance's
};

}  // namespace jprim

#endif
