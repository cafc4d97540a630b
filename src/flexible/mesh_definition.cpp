// SPDX-License-Identifier: Apache-2.0
#include "flexible/mesh_definition.h"

#include <algorithm>
#include <optional>

#include "base/format.h"
#include "base/text.h"
#include "flexible/keyword_file.h"
#include "flexible/set_reader.h"
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
    explicit DefinitionReader(const std::string& path) : m_path(path), m_file(path), m_sets(m_file, m_mesh) {}

    MeshDefinition read();

private:
    // Begins the block of a keyword and says what reads its data lines.
    void beginBlock();
    void beginNodes();
    void beginElements();

    void readData();
    void readNode();
    void readElement();
    void finishElement();
    void readTranslation();
    void finish();

    enum class Block { Other, Nodes, Elements, Set, Instance };

    std::string m_path;
    KeywordFile m_file;
    Block m_block = Block::Other;
    MeshDefinition m_mesh;
    SetReader m_sets;
    int m_parts = 0;
    Vec3 m_translation{0};
    bool m_isTranslated = false;
    bool m_lacksCoordinates = false;  // a node had less than three, and it was said
    Ids* m_set = nullptr;             // the set the block of nodes or elements adds to
    std::optional<int> m_element;     // whose nodes are not complete yet
    std::string m_elementType;
};

//---------------------------------------------------------------------------------------------- keywords
void DefinitionReader::beginBlock() {
    static const char* const refused[] = {"NGEN",  "NFILL",  "NCOPY",  "NMAP",
                                          "ELGEN", "ELCOPY", "SYSTEM", "TRANSFORM"};
    finishElement();
    const std::string& keyword = m_file.getKeyword();
    if (std::find(std::begin(refused), std::end(refused), keyword) != std::end(refused))
        m_file.fail(fmt::format("*{} is not supported; write nodes and elements out, in global coordinates",
                                keyword));
    if (keyword.find('*') != keyword.npos)
        m_file.fail(
            fmt::format("{} has a star within; a keyword begins a line of its own", quote("*" + keyword)));
    if (keyword == "PART" && ++m_parts > 1)
        m_file.fail("this is a second *PART; a mesh is one instance of one part");
    if (keyword == "INSTANCE") m_sets.beginInstance();
    if (keyword == "ASSEMBLY" || keyword == "END INSTANCE") m_sets.setInAssembly(true);
    if (keyword == "END ASSEMBLY") m_sets.endAssembly();
    if (keyword == "NSET" || keyword == "ELSET") m_sets.beginSet();
    if (keyword == "NODE" && !m_sets.isInAssembly()) beginNodes();
    if (keyword == "ELEMENT" && !m_sets.isInAssembly()) beginElements();
    m_block = keyword == "INSTANCE"                     ? Block::Instance
              : keyword == "NSET" || keyword == "ELSET" ? Block::Set
              : keyword == "NODE"                       ? Block::Nodes
              : keyword == "ELEMENT"                    ? Block::Elements
                                                        : Block::Other;
}

void DefinitionReader::beginNodes() {
    const std::string system = toUpperCase(m_file.getParameter("SYSTEM"));
    if (!system.empty() && system != "R")
        m_file.fail(fmt::format("*NODE, SYSTEM={} is not supported; give x, y, z", system));
    if (m_file.hasParameter("INPUT")) m_file.fail("*NODE, INPUT is not supported; use *INCLUDE");
    m_set = m_file.hasParameter("NSET") ? &m_sets.openNodeSet() : nullptr;
}

void DefinitionReader::beginElements() {
    if (m_file.hasParameter("INPUT")) m_file.fail("*ELEMENT, INPUT is not supported; use *INCLUDE");
    m_elementType = toUpperCase(m_file.getParameter("TYPE"));
    if (m_elementType.empty()) m_file.fail("*ELEMENT needs TYPE=type");
    m_set = m_file.hasParameter("ELSET") ? &m_sets.openElementSet() : nullptr;
}

//-------------------------------------------------------------------------------------------- data lines
void DefinitionReader::readData() {
    switch (m_block) {
        case Block::Other: return;
        case Block::Nodes: return readNode();
        case Block::Elements: return readElement();
        case Block::Instance: return readTranslation();
        case Block::Set: return m_sets.readData();
    }
}

// Nodes and elements of the assembly itself are reference points and connectors.
void DefinitionReader::readNode() {
    const auto& fields = m_file.getFields();
    const int id = m_file.readId(fields[0], "a node's id");
    if (m_sets.isInAssembly()) return m_sets.addOwnNode(id);
    if (fields.size() < 4 && !m_lacksCoordinates) {
        m_lacksCoordinates = true;
        m_mesh.warnings.push_back(
            fmt::format("{}: node {} has {} coordinates; those not given are taken as 0", m_file.getWhere(),
                        id, fields.size() - 1));
    }
    Vec3 position(0);
    for (std::size_t k = 1; k < std::min<std::size_t>(fields.size(), 4); ++k)
        position[int(k) - 1] = m_file.readReal(fields[k]);
    const auto [node, isNew] = m_mesh.nodes.try_emplace(id, position);
    if (!isNew && node->second != position)
        m_mesh.warnings.push_back(fmt::format(
            "{}: node {} is defined a second time, at another place, which is taken", m_file.getWhere(), id));
    node->second = position;
    if (m_set) m_set->push_back(id);
}

void DefinitionReader::readElement() {
    const auto& fields = m_file.getFields();
    if (m_sets.isInAssembly()) return m_sets.addOwnElement(m_file.readId(fields[0], "an element's id"));
    std::size_t first = 0;
    if (!m_element) {
        m_element = m_file.readId(fields[first++], "an element's id");
        if (!m_mesh.elements.try_emplace(*m_element).second)
            m_file.fail(fmt::format("element {} is defined a second time", *m_element));
        if (m_set) m_set->push_back(*m_element);
    }
    Ids& nodes = m_mesh.elements[*m_element];
    for (std::size_t k = first; k < fields.size(); ++k)
        nodes.push_back(m_file.readId(fields[k], "a node's id"));
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
        m_translation[int(k)] = m_file.readReal(fields[k]);
    m_isTranslated = true;
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
    m_sets.finish();
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
