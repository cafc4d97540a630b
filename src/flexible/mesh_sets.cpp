// SPDX-License-Identifier: Apache-2.0
#include "flexible/mesh_sets.h"

#include <algorithm>

#include "base/text.h"
#include "flexible/text_file.h"

namespace jprim {

void sortIds(std::vector<int>& ids) {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

std::vector<int>& MeshSets::openSet(const std::string& name) {
    return (m_inAssembly ? m_ofAssembly : m_ofPart)[toUpperCase(name)];
}

const std::vector<int>* MeshSets::findSet(std::string_view name) const {
    const std::string_view plain = dropInstance(name);
    const std::string upper = toUpperCase(plain);
    const auto own = m_ofAssembly.find(upper);
    if (m_inAssembly && plain == name && own != m_ofAssembly.end()) return &own->second;
    const auto found = m_ofPart.find(upper);
    return found == m_ofPart.end() ? nullptr : &found->second;
}

std::string_view MeshSets::dropInstance(std::string_view name) const {
    const std::size_t length = m_instance.size();
    const bool hasInstance = length > 0 && name.size() > length + 1 && name[length] == '.' &&
                             toUpperCase(name.substr(0, length)) == toUpperCase(m_instance);
    return hasInstance ? name.substr(length + 1) : name;
}

void MeshSets::addNodesOf(const MeshSets& elementSets, const std::map<int, std::vector<int>>& elements) {
    for (const auto& [name, ids] : elementSets.m_ofPart)
        if (!m_ofPart.count(name)) m_ofPart[name] = collectNodes(ids, elements);
    for (const auto& [name, ids] : elementSets.m_ofAssembly)
        if (!m_ofAssembly.count(name)) m_ofAssembly[name] = collectNodes(ids, elements);
}

NamedSets MeshSets::getAll() const {
    NamedSets all = m_ofAssembly;
    for (const auto& [name, ids] : m_ofPart)
        if (!all.emplace(name, ids).second) all[toUpperCase(m_instance) + "." + name] = ids;
    for (auto& [name, ids] : all) sortIds(ids);
    return all;
}

std::vector<int> collectNodes(const std::vector<int>& elementIds,
                              const std::map<int, std::vector<int>>& elements) {
    std::vector<int> nodes;
    for (const int id : elementIds) {
        const auto element = elements.find(id);
        if (element == elements.end()) continue;
        nodes.insert(nodes.end(), element->second.begin(), element->second.end());
    }
    sortIds(nodes);
    return nodes;
}

}  // namespace jprim
