// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_RANDOM_CHAIN_H_
#define JPRIM_TESTS_SUPPORT_RANDOM_CHAIN_H_

#include <random>
#include <string>
#include <vector>

#include "base/format.h"
#include "jprim/marker/angles.h"

namespace jprim::testing {

/// A chain of links between two fixed markers, whose parts are given displaced from a position in which it fits.
struct RandomChain {
    int links = 5;
    bool planar = true;                 ///< hinges on one axis, displaced in the plane
    bool curled = false;                ///< a loop that all but closes, not an arc
    double shift = 1. / 3, turn = 0.5;  ///< largest displacement [lengths of the link, rad]
    unsigned seed = 1;

    /// Every axis is askew in ground, and no number rounds well.
    std::string write() const;
};

namespace chain {

using SimTK::Rotation;
using SimTK::Transform;
using SimTK::Vec3;

class Writer {
public:
    explicit Writer(const RandomChain& chain) : m_chain(chain), m_random(chain.seed) {
        m_tilt = drawRotation(3);
        double heading = 0;
        m_nodes.push_back(Vec3(0.3, -0.2, 0.1));
        for (int k = 0; k < chain.links; ++k) {
            heading += chain.curled ? 2 * SimTK::Pi / chain.links * draw(0.6, 1.2) : draw(-0.5, 0.5);
            const Vec3 along(std::cos(heading), std::sin(heading), chain.planar ? 0 : draw(-0.5, 0.5));
            m_lengths.push_back(draw(0.3, 1.5));
            m_nodes.push_back(m_nodes.back() + m_lengths.back() * along.normalize());
            const Vec3 z = chain.planar ? Vec3(0, 0, 1) : drawVector();
            m_axes.push_back(Rotation(SimTK::UnitVec3(along), SimTK::XAxis, z, SimTK::ZAxis));
        }
    }

    std::string write() {
        std::string parts = "chain\nPART/1, GROUND\n";
        for (int k = 0; k <= m_chain.links; ++k) addJoint(k);
        for (int k = 0; k < m_chain.links; ++k) parts += writePart(k);
        return parts + m_markers + m_joints + "END\n";
    }

private:
    double draw(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(m_random);
    }
    Vec3 drawVector() { return Vec3(draw(-1, 1), draw(-1, 1), draw(-1, 1)); }
    Rotation drawRotation(double largest) {
        const double angle = draw(-largest, largest);
        return Rotation(angle, SimTK::UnitVec3(drawVector()));
    }
    static std::string write(const Vec3& v) {
        return fmt::format("{:.17g},{:.17g},{:.17g}", v[0], v[1], v[2]);
    }

    Transform getPose(int part) const {
        if (part == 0) return Transform();
        return Transform(m_tilt * m_axes[size_t(part - 1)], m_tilt * m_nodes[size_t(part - 1)]);
    }
    void addMarker(int id, int part, const Transform& X_GM) {
        const Transform X = ~getPose(part) * X_GM;
        m_markers += fmt::format("MARKER/{}, PART={}, QP={}, REULER={}\n", id, part + 1, write(X.p()),
                                 write(calcAngles313(X.R())));
    }
    void addJoint(int k) {
        static const std::vector<std::string> spatial = {"SPHERICAL", "REVOLUTE", "CYLINDRICAL", "UNIVERSAL",
                                                         "TRANSLATIONAL"};
        const std::string type = m_chain.planar ? "REVOLUTE" : spatial[size_t(draw(0, 4.999))];
        const Transform X_GJ(m_tilt * (m_chain.planar ? Rotation() : drawRotation(3)),
                             m_tilt * m_nodes[size_t(k)]);
        Transform X_GI = X_GJ;
        if (type == "UNIVERSAL") X_GI.updR() = X_GJ.R() * Rotation(SimTK::Pi / 2, SimTK::XAxis);
        const int next = k == m_chain.links ? 0 : k + 1;
        addMarker(100 * k + 12, k, X_GJ);
        addMarker(100 * k + 21, next, X_GI);
        m_joints += fmt::format("JOINT/{}, {}, I={}, J={}\n", k + 1, type, 100 * k + 21, 100 * k + 12);
    }
    std::string writePart(int k) {
        const Vec3 direction = m_chain.planar ? Vec3(draw(-1, 1), draw(-1, 1), 0) : drawVector();
        const Vec3 away = m_chain.shift * m_lengths[size_t(k)] * draw(0, 1) * direction.normalize();
        const Rotation turned = m_chain.planar ? Rotation(draw(-m_chain.turn, m_chain.turn), SimTK::ZAxis)
                                               : drawRotation(m_chain.turn);
        m_markers += fmt::format("MARKER/{}, PART={}, QP={:.17g},0,0\n", 100 * k + 33, k + 2,
                                 m_lengths[size_t(k)] / 2);
        return fmt::format("PART/{}, MASS=1, CM={}, IP=1,1,1, QG={}, REULER={}\n", k + 2, 100 * k + 33,
                           write(m_tilt * (m_nodes[size_t(k)] + away)),
                           write(calcAngles313(m_tilt * turned * m_axes[size_t(k)])));
    }

    const RandomChain& m_chain;
    std::mt19937 m_random;
    Rotation m_tilt;
    std::vector<Vec3> m_nodes;
    std::vector<double> m_lengths;
    std::vector<Rotation> m_axes;
    std::string m_markers, m_joints;
};

}  // namespace chain

inline std::string RandomChain::write() const {
    return chain::Writer(*this).write();
}

}  // namespace jprim::testing

#endif
