// SPDX-License-Identifier: Apache-2.0
// PERPENDICULAR and its relatives hold sums of e = a . b, the cosine of the angle between an axis a of I and an axis b
// of J. Both are in J, where b is at rest and da/dt = w x a.
//
//     e       = a.b
//     de/dt   = (w x a).b = (a x b).w,            load: torque lambda (a x b)
//     d2e/dt2 = (dw/dt x a + w x (w x a)).b
#include "jprim/primitive/primitives.h"
#include "primitive/pair_equations.h"

namespace jprim {
namespace {

using SimTK::CoordinateAxis;
using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::Vec3;
using SimTK::XAxis;
using SimTK::YAxis;
using SimTK::ZAxis;

struct Cosine {
    CoordinateAxis ofI;
    CoordinateAxis ofJ;
    Real factor = 1;
};

class CosineEquations final : public PairEquations {
public:
    CosineEquations(const char* words, const std::vector<Cosine>& cosines)
        : PairEquations(Kind::Rotational, {words}), m_cosines(cosines) {}

    void calcErrors(const MarkerPair& pair, Real* e) const override {
        e[0] = 0;
        for (const Cosine& c : m_cosines) e[0] += c.factor * findAxis(pair, c)[c.ofJ];
    }

    void calcDirections(const MarkerPair& pair, SpatialVec* d) const override {
        d[0] = SpatialVec(Vec3(0), Vec3(0));
        for (const Cosine& c : m_cosines) {
            Vec3 b(0);
            b[c.ofJ] = c.factor;
            d[0][0] += findAxis(pair, c) % b;
        }
    }

    void calcBias(const MarkerPair& pair, const SpatialVec& V_J, Real* bias) const override {
        const Vec3& w = V_J[0];
        bias[0] = 0;
        for (const Cosine& c : m_cosines) bias[0] += c.factor * (w % (w % findAxis(pair, c)))[c.ofJ];
    }

private:
    static const Vec3& findAxis(const MarkerPair& pair, const Cosine& c) {
        return pair.getRotation().getAxisUnitVec(c.ofI).asVec3();
    }

    std::vector<Cosine> m_cosines;
};

constexpr const char* OfConvel = "its own equation";

}  // namespace

const PairEquations& getPerpendicularEquations() {
    static const CosineEquations equations("rotation between Zi and Zj", {{ZAxis, ZAxis}});
    return equations;
}

const PairEquations& getCrossedBarsEquations() {
    static const CosineEquations equations("rotation between Xi and Yj", {{XAxis, YAxis}});
    return equations;
}

// With R_JI = Rz(a) Rx(b) Rz(c) the difference is (1 + cos b) sin(a + c), the sum (1 - cos b) sin(a - c).
const PairEquations& getConstantVelocityEquations(bool opposed) {
    static const CosineEquations alike(OfConvel, {{XAxis, YAxis}, {YAxis, XAxis, -1}});
    static const CosineEquations against(OfConvel, {{XAxis, YAxis}, {YAxis, XAxis, 1}});
    return opposed ? against : alike;
}

Perpendicular::Perpendicular(const Marker& I, const Marker& J, const std::string& name)
    : TypedHandle(AdamsType, getPerpendicularEquations(), I, J, name) {}

}  // namespace jprim
