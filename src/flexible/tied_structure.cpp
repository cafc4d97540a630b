// SPDX-License-Identifier: Apache-2.0
#include "flexible/tied_structure.h"

#include <algorithm>
#include <unordered_map>

#include "base/format.h"
#include "jprim/base/error.h"
#include "linear_algebra/eigenvalues.h"

namespace jprim {

using SimTK::Vec3;

namespace {

class Tie {
public:
    Tie(const FiniteElementModel& model, const std::vector<InterfacePoint>& interfaces)
        : m_model(model), m_interfaces(interfaces), m_interfaceOfNode(model.nodes.size(), -1) {
        for (int i = 0; i < int(model.nodes.size()); ++i) m_indexOfNode[model.nodes[i].id] = i;
        m_nextId = 1;
        for (const FiniteElementNode& node : model.nodes) m_nextId = std::max(m_nextId, node.id + 1);
        for (const InterfacePoint& point : interfaces) m_nextId = std::max(m_nextId, point.id + 1);
        for (int k = 0; k < int(interfaces.size()); ++k) add(interfaces[k], k);
        m_result.numInterfaceFreedoms = 6 * int(interfaces.size());
        makeTransformation();
    }

    TiedStructure&& take() { return std::move(m_result); }

private:
    [[noreturn]] void fail(int k, const std::string& what) const {
        throw Error(m_model.name, fmt::format("interface {}: {}", getName(k), what));
    }

    std::string getName(int k) const {
        const std::string& name = m_interfaces[std::size_t(k)].name;
        return name.empty() ? std::to_string(k + 1) : name;
    }

    void add(const InterfacePoint& interface, int k) {
        if (interface.nodes.empty()) fail(k, "it has no nodes");
        const std::vector<int> nodes = claimNodes(interface, k);
        Vec3 mean(0);
        for (const int i : nodes) mean += m_model.nodes[i].position / double(nodes.size());
        if (m_model.freedomsPerNode == 3) checkSpread(nodes, mean, k);

        const bool isNode = m_model.freedomsPerNode == 6 && nodes.size() == 1 && !interface.position &&
                            (interface.id == 0 || interface.id == interface.nodes[0]);
        if (!isNode && m_indexOfNode.count(interface.id) != 0)
            fail(k, fmt::format("its id {} is that of a node", interface.id));
        for (const FiniteElementNode& other : m_result.interfaces)
            if (interface.id != 0 && other.id == interface.id)
                fail(k, fmt::format("its id {} is that of another interface", interface.id));
        const int id = isNode ? interface.nodes[0] : interface.id != 0 ? interface.id : m_nextId++;
        m_result.interfaces.push_back({id, interface.position.value_or(mean)});
        m_result.isMeshNode.push_back(isNode);
    }

    std::vector<int> claimNodes(const InterfacePoint& interface, int k) {
        std::vector<int> nodes;
        for (const int id : interface.nodes) {
            const auto found = m_indexOfNode.find(id);
            if (found == m_indexOfNode.end()) fail(k, fmt::format("the mesh has no node {}", id));
            int& owner = m_interfaceOfNode[found->second];
            if (owner == k) continue;  // named twice
            if (owner >= 0)
                fail(k, fmt::format("node {} belongs to interface {} already", id, getName(owner)));
            owner = k;
            nodes.push_back(found->second);
        }
        return nodes;
    }

    // Nodes without rotations hold a point in all six freedoms only if they span a plane.
    void checkSpread(const std::vector<int>& nodes, const Vec3& mean, int k) const {
        constexpr double Flat = 1e-12;  // of squared extents
        Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
        for (const int i : nodes) {
            const Vec3 s = m_model.nodes[i].position - mean;
            const Eigen::Vector3d e(s[0], s[1], s[2]);
            spread += e * e.transpose();
        }
        const Eigen::Vector3d extents = calcPrincipalValues(spread);
        if (extents[1] <= Flat * extents[2] || nodes.size() < 3)
            fail(k,
                 "its nodes lie on one line, and nodes of a solid mesh have no rotations; name three or "
                 "more that do not");
    }

    void makeTransformation() {
        const int f = m_model.freedomsPerNode, n = int(m_model.nodes.size());
        const auto numFree = std::count(m_interfaceOfNode.begin(), m_interfaceOfNode.end(), -1);
        const int size = m_result.numInterfaceFreedoms + f * int(numFree);
        std::vector<Eigen::Triplet<double>> terms;
        m_result.rigidMotions.resize(size, 6);
        for (int k = 0; k < int(m_result.interfaces.size()); ++k)
            m_result.rigidMotions.middleRows(6 * k, 6) =
                makeRigidMotionsOfNode(6, m_result.interfaces[k].position);
        int column = m_result.numInterfaceFreedoms;
        for (int i = 0; i < n; ++i) {
            const Vec3& p = m_model.nodes[i].position;
            if (const int k = m_interfaceOfNode[i]; k >= 0) {
                const RigidMotions R = makeRigidMotionsOfNode(f, p - m_result.interfaces[k].position);
                for (int a = 0; a < f; ++a)
                    for (int b = 0; b < 6; ++b)
                        if (R(a, b) != 0) terms.emplace_back(f * i + a, 6 * k + b, R(a, b));
            } else {
                for (int a = 0; a < f; ++a) terms.emplace_back(f * i + a, column + a, 1);
                m_result.rigidMotions.middleRows(column, f) = makeRigidMotionsOfNode(f, p);
                column += f;
            }
        }
        m_result.meshFromTied.resize(f * n, size);
        m_result.meshFromTied.setFromTriplets(terms.begin(), terms.end());
    }

    const FiniteElementModel& m_model;
    const std::vector<InterfacePoint>& m_interfaces;
    TiedStructure m_result;
    std::unordered_map<int, int> m_indexOfNode;
    std::vector<int> m_interfaceOfNode;
    int m_nextId = 1;
};

}  // namespace

TiedStructure tieInterfaces(const FiniteElementModel& model, const std::vector<InterfacePoint>& interfaces) {
    return Tie(model, interfaces).take();
}

}  // namespace jprim
