// SPDX-License-Identifier: Apache-2.0
#include "flexible/set_reader.h"

#include <algorithm>
#include <cstdint>

#include "base/format.h"
#include "base/text.h"
#include "jprim/base/error.h"

namespace jprim {

using Ids = std::vector<int>;

//------------------------------------------------------------------------------------------- surroundings
void SetReader::beginInstance() {
    if (m_hasInstance) m_file.fail("this is a second *INSTANCE; a mesh is one instance of one part");
    m_hasInstance = true;
    m_instance = m_file.getParameter("NAME");
    m_nodeSets.setInstance(m_instance);
    m_elementSets.setInstance(m_instance);
    setInAssembly(false);
}

void SetReader::setInAssembly(bool inAssembly) {
    m_inAssembly = inAssembly;
    m_nodeSets.setInAssembly(inAssembly);
    m_elementSets.setInAssembly(inAssembly);
}

//------------------------------------------------------------------------------------------------- blocks
void SetReader::beginSet() {
    const std::string instance = m_file.getParameter("INSTANCE");
    if (m_hasInstance && !instance.empty() && toUpperCase(instance) != toUpperCase(m_instance))
        m_file.fail(
            fmt::format("there is no instance {}; the mesh is {}", quote(instance), quote(m_instance)));
    m_set = isOfNodes() ? &openNodeSet() : &openElementSet();
    m_where = m_file.getWhere();
    m_isAssumed = false;
    if (isOfNodes() && m_file.hasParameter("ELSET")) addNodesOfElements();
}

void SetReader::addNodesOfElements() {
    const Ids& elements = findSet(m_file.getParameter("ELSET"), m_elementSets);
    for (const int element : elements)
        if (!m_mesh.elements.count(element)) m_premature.push_back({m_where, element});
    const Ids nodes = collectNodes(elements, m_mesh.elements);
    m_set->insert(m_set->end(), nodes.begin(), nodes.end());
}

//-------------------------------------------------------------------------------------------- data lines
void SetReader::readData() {
    const std::size_t begin = m_set->size();
    m_file.hasParameter("GENERATE") ? readRange() : readMembers();
    updMembers().add(m_file.getParameter(m_file.getKeyword()), *m_set, begin, m_file.getWhere());
}

void SetReader::readMembers() {
    const MeshSets& sets = isOfNodes() ? m_nodeSets : m_elementSets;
    for (const std::string_view field : m_file.getFields()) {
        if (field.empty()) continue;
        const std::string_view member = sets.dropInstance(field);
        if (isDigit(member.front()) || member.front() == '-' || member.front() == '+') {
            addMember(
                m_file.readId(member, isOfNodes() ? "the number of a node" : "the number of an element"),
                member.size() < field.size());
        } else {
            const Ids added = findSet(field, sets);
            m_set->insert(m_set->end(), added.begin(), added.end());
        }
    }
}

void SetReader::readRange() {
    constexpr std::int64_t most = 10'000'000;
    const auto& fields = m_file.getFields();
    const int first = m_file.readId(fields[0], "an id");
    const int last = fields.size() > 1 ? m_file.readId(fields[1], "an id") : first;
    const int step = fields.size() > 2 ? m_file.readId(fields[2], "a step") : 1;
    if (last < first || step < 1)
        m_file.fail(fmt::format("cannot go from {} to {} in steps of {}", first, last, step));
    const std::int64_t count = (std::int64_t(last) - first) / step + 1;
    if (count > most)
        m_file.fail(
            fmt::format("goes from {} to {}, over {} numbers; at most {} can be", first, last, count, most));
    for (std::int64_t id = first; id <= last; id += step) addMember(int(id), false);
}

// To Abaqus a number in the assembly is that of a reference point there, unless the set or the number itself
// names the instance.
void SetReader::addMember(int id, bool namesInstance) {
    if (m_inAssembly && !namesInstance && !m_file.hasParameter("INSTANCE")) {
        if ((isOfNodes() ? m_ownNodes : m_ownElements).count(id) > 0) return;
        if (!m_isAssumed)
            m_mesh.warnings.push_back(fmt::format(
                "{}: the set {} stands outside the instance and has no instance={}; its numbers are read as that "
                "instance's",
                m_where, quote(m_file.getParameter(m_file.getKeyword())), m_instance));
        m_isAssumed = true;
    }
    m_set->push_back(id);
}

//------------------------------------------------------------------------------------------------- names
Ids& SetReader::openSet(const char* parameter, MeshSets& sets) {
    const std::string name = m_file.getParameter(parameter);
    if (name.empty()) m_file.fail(fmt::format("*{} needs {}=name", m_file.getKeyword(), parameter));
    return sets.openSet(name);
}

const Ids& SetReader::findSet(std::string_view name, const MeshSets& sets) const {
    if (const Ids* found = sets.findSet(name)) return *found;
    m_file.fail(fmt::format("there is no {} set {} above this line",
                            &sets == &m_nodeSets ? "node" : "element", quote(name)));
}

//------------------------------------------------------------------------------------------------- whole
void SetReader::finish() {
    const auto isNode = [this](int id) { return m_mesh.nodes.count(id) > 0; };
    const auto isElement = [this](int id) { return m_mesh.elements.count(id) > 0; };
    for (const Premature& premature : m_premature)
        if (isElement(premature.element))
            throw Error(premature.where,
                        fmt::format("element {} of this set is defined below; move the set there",
                                    premature.element));
    for (const auto& warnings :
         {m_nodeMembers.findUndefined(isNode), m_elementMembers.findUndefined(isElement)})
        m_mesh.warnings.insert(m_mesh.warnings.end(), warnings.begin(), warnings.end());
    m_nodeSets.addNodesOf(m_elementSets, m_mesh.elements);
    m_mesh.nodeSets = m_nodeSets.getAll();
    for (auto& [name, ids] : m_mesh.nodeSets)
        ids.erase(std::remove_if(ids.begin(), ids.end(), [&](int id) { return !isNode(id); }), ids.end());
}

}  // namespace jprim
