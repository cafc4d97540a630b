// SPDX-License-Identifier: Apache-2.0
// ATPOINT, INLINE and INPLANE hold some of the coordinates of p, the position of I's origin in J:
//     e_k = p_a,   de_k/dt = v_a,   d2e_k/dt2 = dv_a/dt,   load on I: a force along J's axis a.
// Seen from J there is nothing more to it; the rotation of J is MarkerPair's business.
#include "jprim/primitive/primitives.h"
#include "primitive/primitive_impl.h"

namespace jprim {
namespace {

using SimTK::SpatialVec;
using SimTK::Vec3;

class TranslationalImpl : public PrimitiveImpl {
public:
    // Holds J's axes firstAxis, firstAxis + 1 …, where x is 0; one equation for each of the words.
    TranslationalImpl(const char* adamsType, int firstAxis, const Words& words, const Marker& I,
                      const Marker& J, const std::string& name)
        : PrimitiveImpl(adamsType, Kind::Translational, words, I, J, name), m_firstAxis(firstAxis) {}

    Implementation* clone() const override { return new TranslationalImpl(*this); }

    void calcErrors(const MarkerPair& pair, Errors& e) const override {
        for (int k = 0; k < getNumEquations(); ++k) e[k] = pair.getPosition()[m_firstAxis + k];
    }

    void calcDirections(const MarkerPair&, Directions& d) const override {
        for (int k = 0; k < getNumEquations(); ++k) {
            d[k] = SpatialVec(Vec3(0), Vec3(0));
            d[k][1][m_firstAxis + k] = 1;
        }
    }

    void calcBias(const MarkerPair&, const SpatialVec&, Errors& bias) const override { bias = 0; }

private:
    int m_firstAxis;
};

constexpr const char* AlongX = "translation of I along Xj";
constexpr const char* AlongY = "translation of I along Yj";
constexpr const char* AlongZ = "translation of I along Zj";

}  // namespace

AtPoint::AtPoint(const Marker& I, const Marker& J, const std::string& name)
    : Primitive(new TranslationalImpl("ATPOINT", 0, {AlongX, AlongY, AlongZ}, I, J, name)) {}

InLine::InLine(const Marker& I, const Marker& J, const std::string& name)
    : Primitive(new TranslationalImpl("INLINE", 0, {AlongX, AlongY}, I, J, name)) {}

InPlane::InPlane(const Marker& I, const Marker& J, const std::string& name)
    : Primitive(new TranslationalImpl("INPLANE", 2, {AlongZ}, I, J, name)) {}

}  // namespace jprim
