// SPDX-License-Identifier: Apache-2.0
// ATPOINT, INLINE and INPLANE hold some of the coordinates of p, the position of I's origin in J:
//     e_k = p_a,   de_k/dt = v_a,   d2e_k/dt2 = dv_a/dt,   load on I: a force along J's axis a.
// Seen from J there is nothing more to it; the rotation of J is MarkerPair's business.
#include <algorithm>

#include "jprim/primitive/primitives.h"
#include "primitive/pair_equations.h"

namespace jprim {
namespace {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::Vec3;

class TranslationalEquations final : public PairEquations {
public:
    // Holds J's axes firstAxis, firstAxis + 1 …, where x is 0; one equation for each of the words.
    TranslationalEquations(int firstAxis, const std::vector<const char*>& words)
        : PairEquations(Kind::Translational, words), m_firstAxis(firstAxis) {}

    void calcErrors(const MarkerPair& pair, Real* e) const override {
        for (int k = 0; k < getNumEquations(); ++k) e[k] = pair.getPosition()[m_firstAxis + k];
    }

    void calcDirections(const MarkerPair&, SpatialVec* d) const override {
        for (int k = 0; k < getNumEquations(); ++k) {
            d[k] = SpatialVec(Vec3(0), Vec3(0));
            d[k][1][m_firstAxis + k] = 1;
        }
    }

    void calcBias(const MarkerPair&, const SpatialVec&, Real* bias) const override {
        std::fill_n(bias, getNumEquations(), 0);
    }

private:
    int m_firstAxis;
};

constexpr const char* AlongX = "translation of I along Xj";
constexpr const char* AlongY = "translation of I along Yj";
constexpr const char* AlongZ = "translation of I along Zj";

}  // namespace

const PairEquations& getAtPointEquations() {
    static const TranslationalEquations equations(0, {AlongX, AlongY, AlongZ});
    return equations;
}

const PairEquations& getInLineEquations() {
    static const TranslationalEquations equations(0, {AlongX, AlongY});
    return equations;
}

const PairEquations& getInPlaneEquations() {
    static const TranslationalEquations equations(2, {AlongZ});
    return equations;
}

AtPoint::AtPoint(const Marker& I, const Marker& J, const std::string& name)
    : TypedHandle(AdamsType, getAtPointEquations(), I, J, name) {}

InLine::InLine(const Marker& I, const Marker& J, const std::string& name)
    : TypedHandle(AdamsType, getInLineEquations(), I, J, name) {}

InPlane::InPlane(const Marker& I, const Marker& J, const std::string& name)
    : TypedHandle(AdamsType, getInPlaneEquations(), I, J, name) {}

}  // namespace jprim
