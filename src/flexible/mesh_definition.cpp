// SPDX-License-Identifier: Apache-2.0
#include "flexible/mesh_definition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "base/text.h"
#include "flexible/keyword_file.h"
#include "flexible/mesh_sets.h"
#include "jprim/base/error.h"

namespace jprim {

using SimTK::Vec3;

namespace {

using Ids = std::vector<int>;

// The nodes of an element by its type's name, C3D10M; nothing for types other than solids.
std::optional<std::size_t> findNumNodes(const std::string& type) {
    if (type.rfind("C3D", 0) != 0) return std::nullopt;
    std::string digits = type.substr(3);
    digits.resize(std::min(digits.find_first_not_of("0123456789"), digits.size()));
    int count = 0;
    std::string_view text = digits;
    return takeNumber(text, count) ? std::optional<std::size_t>(count) : std::nullopt;
}

class DefinitionReader {
public:
    explicit DefinitionReader(const std::string& path) : m_path(path), m_file(path) {}

    MeshDefinition read();

private:
    // Begins the block of a keyword and says what reads its data lines.
    void beginBlock();
    void beginNodes();
    void beginElements();
    void beginSet();
    void beginPart();
    void beginInstance();

    void readData();
    void readNode();
    void readElement();
    void finishElement();
    void readTranslation();
    void readMembers();
    void readRange();

    int readId(std::string_view field, const char* what) const;
    double readReal(std::string_view field) const;
    Ids& openSet(const char* parameter, MeshSets& sets);
    const Ids& findSet(std::string_view name, const MeshSets& sets) const;
    void setInAssembly(bool inAssembly);
    void finish();

    enum class Block { Other, Nodes, Elements, Set, Instance };

    std::string m_path;
    KeywordFile m_file;
    Block m_block = Block::Other;
    MeshDefinition m_mesh;
    MeshSets m_nodeSets, m_elementSets;
    int m_parts = 0, m_instances = 0;
    bool m_inAssembly = false;  // and not in its instance
    Vec3 m_translation{0};
    bool m_isTranslated = false;
    Ids* m_set = nullptr;          // the set the block adds to
    std::optional<int> m_element;  // whose nodes are not complete yet
    std::string m_elementType;
};

//---------------------------------------------------------------------------------------------- keywords
void DefinitionReader::beginBlock() {
    static const char* const refused[] = {"NGEN",  "NFILL",  "NCOPY",  "NMAP",
                                          "ELGEN", "ELCOPY", "SYSTEM", "TRANSFORM"};
    finishElement();
    m_block = Block::Other;
    const std::string& keyword = m_file.getKeyword();
    if (std::find(std::begin(refused), std::end(refused), keyword) != std::end(refused))
        m_file.fail(fmt::format("*{} is not supported; write nodes and elements out, in global coordinates",
                                keyword));
    if (keyword == "PART") beginPart();
    if (keyword == "INSTANCE") beginInstance();
    if (keyword == "ASSEMBLY" || keyword == "END INSTANCE") setInAssembly(true);
    if (keyword == "END ASSEMBLY") setInAssembly(false);
    if (keyword == "NSET" || keyword == "ELSET") beginSet();
    // Nodes and elements of the assembly itself are reference points and connectors.
    if (keyword == "NODE" && !m_inAssembly) beginNodes();
    if (keyword == "ELEMENT" && !m_inAssembly) beginElements();
}

void DefinitionReader::beginNodes() {
    const std::string system = toUpperCase(m_file.getParameter("SYSTEM"));
    if (!system.empty() && system != "R")
        m_file.fail(fmt::format("*NODE, SYSTEM={} is not supported; give x, y, z", system));
    if (m_file.hasParameter("INPUT")) m_file.fail("*NODE, INPUT is not supported; use *INCLUDE");
    m_block = Block::Nodes;
    m_set = m_file.hasParameter("NSET") ? &openSet("NSET", m_nodeSets) : nullptr;
}

void DefinitionReader::beginElements() {
    if (m_file.hasParameter("INPUT")) m_file.fail("*ELEMENT, INPUT is not supported; use *INCLUDE");
    m_elementType = toUpperCase(m_file.getParameter("TYPE"));
    if (m_elementType.empty()) m_file.fail("*ELEMENT needs TYPE=type");
    m_block = Block::Elements;
    m_set = m_file.hasParameter("ELSET") ? &openSet("ELSET", m_elementSets) : nullptr;
}

void DefinitionReader::beginSet() {
    const bool ofNodes = m_file.getKeyword() == "NSET";
    m_set = ofNodes ? &openSet("NSET", m_nodeSets) : &openSet("ELSET", m_elementSets);
    m_block = Block::Set;
    if (!ofNodes || !m_file.hasParameter("ELSET")) return;
    const Ids& elements = findSet(m_file.getParameter("ELSET"), m_elementSets);
    const Ids nodes = collectNodes(elements, m_mesh.elements);
    m_set->insert(m_set->end(), nodes.begin(), nodes.end());
}

void DefinitionReader::beginPart() {
    if (++m_parts > 1) m_file.fail("this is a second *PART; a mesh is one instance of one part");
}

void DefinitionReader::beginInstance() {
    if (++m_instances > 1) m_file.fail("this is a second *INSTANCE; a mesh is one instance of one part");
    m_nodeSets.setInstance(m_file.getParameter("NAME"));
    m_elementSets.setInstance(m_file.getParameter("NAME"));
    setInAssembly(false);
    m_block = Block::Instance;
}

//-------------------------------------------------------------------------------------------- data lines
void DefinitionReader::readData() {
    switch (m_block) {
        case Block::Other: return;
        case Block::Nodes: return readNode();
        case Block::Elements: return readElement();
        case Block::Instance: return readTranslation();
        case Block::Set: return m_file.hasParameter("GENERATE") ? readRange() : readMembers();
    }
}

void DefinitionReader::readNode() {
    const auto& fields = m_file.getFields();
    const int id = readId(fields[0], "a node's id");
    Vec3 position(0);
    for (std::size_t k = 1; k < std::min<std::size_t>(fields.size(), 4); ++k)
        position[int(k) - 1] = readReal(fields[k]);
    m_mesh.nodes[id] = position;
    if (m_set) m_set->push_back(id);
}

void DefinitionReader::readElement() {
    const auto& fields = m_file.getFields();
    std::size_t first = 0;
    if (!m_element) {
        m_element = readId(fields[first++], "an element's id");
        m_mesh.elements[*m_element].clear();
        if (m_set) m_set->push_back(*m_element);
    }
    Ids& nodes = m_mesh.elements[*m_element];
    for (std::size_t k = first; k < fields.size(); ++k) nodes.push_back(readId(fields[k], "a node's id"));
    // CalculiX goes on to the next line without a comma, too.
    const auto count = findNumNodes(m_elementType);
    if (count ? nodes.size() >= *count : !m_file.isContinued()) finishElement();
}

void DefinitionReader::finishElement() {
    if (!m_element) return;
    const std::size_t given = m_mesh.elements[*m_element].size();
    const std::size_t count = findNumNodes(m_elementType).value_or(given);
    if (given != count)
        m_file.fail(fmt::format("element {} of type {} has {} nodes; it must have {}", *m_element,
                                m_elementType, given, count));
    m_element.reset();
}

// The second data line of an instance is a rotation.
void DefinitionReader::readTranslation() {
    const auto& fields = m_file.getFields();
    if (m_isTranslated) m_file.fail("the instance is rotated, which is not supported; rotate the part");
    for (std::size_t k = 0; k < std::min<std::size_t>(fields.size(), 3); ++k)
        m_translation[int(k)] = readReal(fields[k]);
    m_isTranslated = true;
}

void DefinitionReader::readMembers() {
    const bool ofInstance = !m_inAssembly || m_file.hasParameter("INSTANCE");
    const MeshSets& sets = m_file.getKeyword() == "NSET" ? m_nodeSets : m_elementSets;
    for (const std::string_view field : m_file.getFields()) {
        if (field.empty()) continue;
        const std::string_view member = sets.dropInstance(field);
        if (member.front() >= '0' && member.front() <= '9') {
            const int id = readId(member, "an id");
            // Others are numbers of the assembly's own reference points.
            if (ofInstance || member.size() < field.size()) m_set->push_back(id);
        } else {
            const Ids added = findSet(field, sets);
            m_set->insert(m_set->end(), added.begin(), added.end());
        }
    }
}

void DefinitionReader::readRange() {
    constexpr std::int64_t most = 10'000'000;
    const auto& fields = m_file.getFields();
    const int first = readId(fields[0], "an id");
    const int last = fields.size() > 1 ? readId(fields[1], "an id") : first;
    const int step = fields.size() > 2 ? readId(fields[2], "a step") : 1;
    if (last < first || step < 1 || (std::int64_t(last) - first) / step >= most)
        m_file.fail(fmt::format("cannot go from {} to {} in steps of {}", first, last, step));
    for (std::int64_t id = first; id <= last; id += step) m_set->push_back(int(id));
}

//------------------------------------------------------------------------------------------ fields, sets
int DefinitionReader::readId(std::string_view field, const char* what) const {
    int id = 0;
    std::string_view rest = field;
    if (!takeNumber(rest, id) || !rest.empty() || id < 0)
        m_file.fail(fmt::format("{} is not {}", quote(field), what));
    return id;
}

// An empty field is a zero.
double DefinitionReader::readReal(std::string_view field) const {
    double value = 0;
    std::string_view rest = field;
    if (!field.empty() && (!takeNumber(rest, value) || !rest.empty()))
        m_file.fail(fmt::format("{} is not a number", quote(field)));
    return value;
}

Ids& DefinitionReader::openSet(const char* parameter, MeshSets& sets) {
    const std::string name = m_file.getParameter(parameter);
    if (name.empty()) m_file.fail(fmt::format("*{} needs {}=name", m_file.getKeyword(), parameter));
    return sets.openSet(name);
}

const Ids& DefinitionReader::findSet(std::string_view name, const MeshSets& sets) const {
    if (const Ids* found = sets.findSet(name)) return *found;
    m_file.fail(fmt::format("there is no {} set {} above this line",
                            &sets == &m_nodeSets ? "node" : "element", quote(name)));
}

void DefinitionReader::setInAssembly(bool inAssembly) {
    m_inAssembly = inAssembly;
    m_nodeSets.setInAssembly(inAssembly);
    m_elementSets.setInAssembly(inAssembly);
}

//------------------------------------------------------------------------------------------------- whole
void DefinitionReader::finish() {
    if (m_mesh.nodes.empty()) throw Error(m_path, "there are no nodes; *NODE defines them");
    for (const auto& [id, nodes] : m_mesh.elements)
        for (const int node : nodes)
            if (!m_mesh.nodes.count(node))
                throw Error(m_path,
                            fmt::format("element {} has node {}, which *NODE does not define", id, node));
    for (auto& [id, position] : m_mesh.nodes) position += m_translation;
    m_nodeSets.addNodesOf(m_elementSets, m_mesh.elements);
    m_mesh.nodeSets = m_nodeSets.getAll();
}

MeshDefinition DefinitionReader::read() {
    while (m_file.nextLine()) m_file.isKeyword() ? beginBlock() : readData();
    finishElement();
    finish();
    return std::move(m_mesh);
}

}  // namespace

MeshDefinition readMeshDefinition(const std::string& inpFile) {
    return DefinitionReader(inpFile).read();
}

}  // namespace jprim
