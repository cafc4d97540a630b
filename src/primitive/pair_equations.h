// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_PRIMITIVE_PAIR_EQUATIONS_H_
#define JPRIM_SRC_PRIMITIVE_PAIR_EQUATIONS_H_

#include <vector>

#include "jprim/marker/marker_pair.h"

namespace jprim {

/// The equations of a primitive, on the motion [w, v] of marker I relative to J: e, its derivatives and its load, at
/// any position. All vectors are in J. They hold no data of a mechanism; constraints share them.
class PairEquations {
public:
    static constexpr int MaxEquations = 3;

    virtual ~PairEquations() = default;
    PairEquations(const PairEquations&) = delete;
    PairEquations& operator=(const PairEquations&) = delete;

    /// e_k for k = 0 … getNumEquations() - 1; so are all outputs below.
    virtual void calcErrors(const MarkerPair& pair, SimTK::Real* e) const = 0;
    /// d_k = [t, f] with de_k/dt = t.w + f.v; lambda_k d_k is also the load on I at I's origin.
    virtual void calcDirections(const MarkerPair& pair, SimTK::SpatialVec* d) const = 0;
    /// The part of d2e/dt2 that depends on velocity: d2e_k/dt2 = t.dw/dt + f.dv/dt + bias_k.
    virtual void calcBias(const MarkerPair& pair, const SimTK::SpatialVec& V_J, SimTK::Real* bias) const = 0;

    int getNumEquations() const { return int(m_words.size()); }
    /// True if the equations are lengths and the loads forces, false if they are angles and torques.
    bool isTranslational() const { return m_isTranslational; }
    /// What equation k holds, in words.
    const char* describe(int k) const { return m_words.at(size_t(k)); }

protected:
    enum class Kind { Translational, Rotational };
    /// One entry of words for each equation.
    PairEquations(Kind kind, const std::vector<const char*>& words)
        : m_isTranslational(kind == Kind::Translational), m_words(words) {}

private:
    bool m_isTranslational;
    std::vector<const char*> m_words;
};

/// @name The equations of each primitive
///@{
const PairEquations& getAtPointEquations();
const PairEquations& getInLineEquations();
const PairEquations& getInPlaneEquations();
const PairEquations& getOrientationEquations();
const PairEquations& getParallelAxesEquations();
const PairEquations& getPerpendicularEquations();
///@}

/// x_I . y_J = 0: PERPENDICULAR for the bars of a HOOKE.
const PairEquations& getCrossedBarsEquations();
/// x_I . y_J = y_I . x_J, or opposed x_I . y_J = -y_I . x_J: shafts that turn together.
const PairEquations& getConstantVelocityEquations(bool opposed);

}  // namespace jprim

#endif
