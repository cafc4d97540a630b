// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FLEXIBLE_MESH_SETS_H_
#define JPRIM_SRC_FLEXIBLE_MESH_SETS_H_

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace jprim {

/// Sets by upper-case name.
using NamedSets = std::map<std::string, std::vector<int>>;

/// Sorts the ids and drops those that repeat.
void sortIds(std::vector<int>& ids);

/// The named sets of nodes, or of elements, of an input file: those of its part and those of the assembly
/// around it, which may have the same names. A file without parts counts as one part.
class MeshSets {
public:
    /// Names the only instance of the part.
    void setInstance(const std::string& name) { m_instance = name; }

    /// Says whether the lines that follow belong to the assembly or to the part.
    void setInAssembly(bool inAssembly) { m_inAssembly = inAssembly; }

    /// The set to add to, made if there is none of this name.
    std::vector<int>& openSet(const std::string& name);

    /// A set as a line of the file refers to it, or nullptr. The assembly sees its own sets first.
    const std::vector<int>* findSet(std::string_view name) const;

    /// The name or number without the INSTANCE. that the assembly writes before what belongs to the part.
    std::string_view dropInstance(std::string_view name) const;

    /// Adds the sets of elements as sets of nodes, unless one has the name already.
    /// @param elements  the nodes of each element
    void addNodesOf(const MeshSets& elementSets, const std::map<int, std::vector<int>>& elements);

    /// All sets, with sorted ids. A part's set whose name the assembly has as well is called INSTANCE.NAME.
    NamedSets getAll() const;

private:
    NamedSets m_ofPart, m_ofAssembly;
    std::string m_instance;
    bool m_inAssembly = false;
};

/// The nodes of some elements. Elements that do not exist have none.
std::vector<int> collectNodes(const std::vector<int>& elementIds,
                              const std::map<int, std::vector<int>>& elements);

}  // namespace jprim

#endif
