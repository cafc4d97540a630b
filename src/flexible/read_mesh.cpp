// SPDX-License-Identifier: Apache-2.0
#include "jprim/flexible/read_mesh.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <unordered_map>

#include "base/format.h"
#include "base/text.h"
#include "flexible/matrix_file.h"
#include "flexible/mesh_definition.h"
#include "flexible/mesh_sets.h"
#include "flexible/text_file.h"
#include "jprim/base/error.h"

namespace jprim {
namespace {

/// The nodes with freedoms, and the freedom of each row of the matrices.
struct RowTable {
    std::vector<int> nodes;
    std::vector<int> freedoms;
};

std::string getFileName(const std::string& path) {
    return std::filesystem::path(path).filename().string();
}

/// Reads CalculiX's list of rows: a line `node.direction` for each.
class DofFileReader {
public:
    DofFileReader(const std::string& path, const std::string& remedy, const std::string& inpFile,
                  const MeshDefinition& definition)
        : m_file(path, remedy), m_inpName(getFileName(inpFile)), m_definition(definition) {}

    RowTable read() {
        while (m_file.nextLine())
            if (!trim(m_file.getLine()).empty()) readRow();
        for (const int node : m_table.nodes) checkNode(node);
        for (const auto& [id, nodes] : m_definition.elements)
            for (const int node : nodes) checkNode(node);
        return std::move(m_table);
    }

private:
    struct NodeRows {
        int index = 0;
        bool has[3] = {false, false, false};
    };

    void readRow() {
        const std::string_view line = trim(m_file.getLine());
        const std::size_t dot = line.find('.');
        std::string_view front = line.substr(0, dot), back = line.substr(std::min(dot, line.size() - 1) + 1);
        int node = 0, direction = 0;
        const bool isRead = dot != line.npos && takeNumber(front, node) && takeNumber(back, direction);
        if (!isRead || !front.empty() || !back.empty() || direction < 1 || direction > 3)
            m_file.fail(fmt::format("{} is not `node.direction` with a direction from 1 to 3", quote(line)));
        addRow(node, direction - 1);
    }

    void addRow(int node, int axis) {
        if (!m_definition.nodes.count(node))
            m_file.fail(
                fmt::format("node {} is not in {}; CalculiX expands beams and shells and gives C3D8I "
                            "elements nodes of their own, which is not supported; use other solids",
                            node, m_inpName));
        const auto [found, isNew] = m_rows.try_emplace(node);
        NodeRows& rows = found->second;
        if (isNew) {
            rows.index = int(m_table.nodes.size());
            m_table.nodes.push_back(node);
        }
        if (rows.has[axis])
            m_file.fail(
                fmt::format("node {} appears a second time; CalculiX expands beams and shells, which "
                            "is not supported; use solids",
                            node));
        rows.has[axis] = true;
        m_table.freedoms.push_back(3 * rows.index + axis);
    }

    void checkNode(int node) const {
        const auto found = m_rows.find(node);
        std::string missing;
        for (int axis = 0; axis < 3; ++axis)
            if (found == m_rows.end() || !found->second.has[axis])
                missing += (missing.empty() ? "" : ", ") + std::string(1, "xyz"[axis]);
        if (missing.empty()) return;
        throw Error(
            m_file.getPath(),
            fmt::format("node {} is not free in {}; the file is cut short, or the mesh has supports or "
                        "couplings, which it must not (*BOUNDARY, *EQUATION, *MPC, *TIE, *RIGID BODY)",
                        node, missing));
    }

    TextFile m_file;
    std::string m_inpName;
    const MeshDefinition& m_definition;
    std::unordered_map<int, NodeRows> m_rows;
    RowTable m_table;
};

// Abaqus writes rows for the nodes of elements only, three to each.
RowTable makeRowTable(const MeshDefinition& definition) {
    RowTable table;
    for (const auto& [id, nodes] : definition.elements)
        table.nodes.insert(table.nodes.end(), nodes.begin(), nodes.end());
    if (table.nodes.empty())
        for (const auto& [id, position] : definition.nodes) table.nodes.push_back(id);
    sortIds(table.nodes);
    table.freedoms.resize(3 * table.nodes.size());
    std::iota(table.freedoms.begin(), table.freedoms.end(), 0);
    return table;
}

// The mesh without its matrices.
FiniteElementMesh makeMesh(const std::string& inpFile, MeshDefinition definition, const RowTable& table) {
    FiniteElementMesh mesh;
    mesh.model.name = getFileName(inpFile);
    mesh.model.freedomsPerNode = 3;
    for (const int id : table.nodes) mesh.model.nodes.push_back({id, definition.nodes.at(id)});
    std::vector<int> ids = table.nodes;
    std::sort(ids.begin(), ids.end());
    for (const auto& [name, members] : definition.nodeSets)
        std::set_intersection(members.begin(), members.end(), ids.begin(), ids.end(),
                              std::back_inserter(mesh.nodeSets[name]));
    mesh.warnings = std::move(definition.warnings);
    return mesh;
}

void readMatrices(const std::string& stiffnessFile, const std::string& massFile, const RowTable& table,
                  const std::string& remedy, FiniteElementMesh& mesh) {
    mesh.files = {stiffnessFile, massFile, std::vector<int>(table.freedoms.size())};
    for (std::size_t row = 0; row < table.freedoms.size(); ++row)
        mesh.files.rows[std::size_t(table.freedoms[row])] = int(row) + 1;
    mesh.model.stiffness = readMatrixFile(stiffnessFile, table.freedoms, remedy);
    mesh.model.mass = readMatrixFile(massFile, table.freedoms, remedy);
}

}  // namespace

const std::vector<int>& FiniteElementMesh::getNodeSet(const std::string& name) const {
    const auto found = nodeSets.find(toUpperCase(name));
    if (found != nodeSets.end() && !found->second.empty()) return found->second;
    if (found != nodeSets.end())
        throw Error(model.name, fmt::format("the node set {} has no node of an element; it is empty, or its "
                                            "nodes are reference points or not defined",
                                            quote(name)));
    std::string names;
    for (const auto& [other, nodes] : nodeSets) names += (names.empty() ? "" : ", ") + other;
    throw Error(model.name, fmt::format("there is no node set {}; {}", quote(name),
                                        names.empty() ? "the file has none" : "there are " + names));
}

FiniteElementMesh readCalculixMesh(const std::string& inpFile) {
    const MeshDefinition definition = readMeshDefinition(inpFile);
    const std::string remedy =
        fmt::format("CalculiX writes it when it runs {} with a step *FREQUENCY, SOLVER=MATRIXSTORAGE",
                    getFileName(inpFile));
    const auto getBeside = [&](const char* ending) {
        return std::filesystem::path(inpFile).replace_extension(ending).string();
    };
    const RowTable table = DofFileReader(getBeside(".dof"), remedy, inpFile, definition).read();
    FiniteElementMesh mesh = makeMesh(inpFile, definition, table);
    readMatrices(getBeside(".sti"), getBeside(".mas"), table, remedy, mesh);
    return mesh;
}

FiniteElementMesh readAbaqusMesh(const std::string& inpFile, const std::string& stiffnessFile,
                                 const std::string& massFile) {
    const std::string remedy =
        "Abaqus writes it in a step with *MATRIX GENERATE, STIFFNESS, MASS and *MATRIX OUTPUT, STIFFNESS, "
        "MASS, FORMAT=COORDINATE";
    const MeshDefinition definition = readMeshDefinition(inpFile);
    const RowTable table = makeRowTable(definition);
    FiniteElementMesh mesh = makeMesh(inpFile, definition, table);
    readMatrices(stiffnessFile, massFile, table, remedy, mesh);
    return mesh;
}

}  // namespace jprim
