// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_MUTANTS_H_
#define JPRIM_TESTS_SUPPORT_MUTANTS_H_

#include "jprim/marker/marker.h"

namespace jprim::testing {

enum class Defect {
    None,
    RateOmitsRotationOfJ,
    AccelerationOmitsCoriolis,
    ForceTwiceTooLarge,
    ForceOmitsLever,
    SameEquationTwice
};

/// INLINE written once more, straight from the formulas and sharing nothing with the library, with a defect
/// of choice. Without one it is a second route to the same constraint.
class MutantInLine : public SimTK::Constraint::Custom::Implementation {
    using Real = SimTK::Real;
    using Vec3 = SimTK::Vec3;
    using SpatialVec = SimTK::SpatialVec;
    using Transform = SimTK::Transform;
    using State = SimTK::State;
    using Body = SimTK::ConstrainedBodyIndex;
    template <class T, class Index = unsigned>
    using Array = SimTK::Array_<T, Index>;
    using Qs = Array<Real, SimTK::ConstrainedQIndex>;

public:
    MutantInLine(Defect defect, const Marker& I, const Marker& J)
        : Implementation(const_cast<SimTK::SimbodyMatterSubsystem&>(I.getBody().getMatterSubsystem()), 2, 0,
                         0),
          m_defect(defect),
          m_X_BI(I.getPose()),
          m_X_BJ(J.getPose()),
          m_I(addConstrainedBody(I.getBody())),
          m_J(addConstrainedBody(J.getBody())) {}

    Implementation* clone() const override { return new MutantInLine(*this); }

    void calcPositionErrors(const State&, const Array<Transform, Body>& X, const Qs&,
                            Array<Real>& e) const override {
        const Transform X_AJ = X[m_J] * m_X_BJ;
        put(~X_AJ.R() * ((X[m_I] * m_X_BI).p() - X_AJ.p()), e);
    }

    void calcPositionDotErrors(const State& s, const Array<SpatialVec, Body>& V, const Qs&,
                               Array<Real>& e) const override {
        const Transform X_AJ = getBodyTransformFromState(s, m_J) * m_X_BJ;
        const Vec3 r = calcR(s);
        const Vec3 v =
            findStationVelocity(s, V, m_I, m_X_BI.p()) - findStationVelocity(s, V, m_J, m_X_BJ.p());
        const Vec3 turning = m_defect == Defect::RateOmitsRotationOfJ ? Vec3(0) : Vec3(V[m_J][0] % r);
        put(~X_AJ.R() * (v - turning), e);
    }

    void calcPositionDotDotErrors(const State& s, const Array<SpatialVec, Body>& A, const Qs&,
                                  Array<Real>& e) const override {
        const Transform X_AJ = getBodyTransformFromState(s, m_J) * m_X_BJ;
        const Vec3 r = calcR(s);
        const Vec3 w = getBodyAngularVelocityFromState(s, m_J);
        const Vec3 v = findStationVelocityFromState(s, m_I, m_X_BI.p()) -
                       findStationVelocityFromState(s, m_J, m_X_BJ.p());
        const Vec3 a =
            findStationAcceleration(s, A, m_I, m_X_BI.p()) - findStationAcceleration(s, A, m_J, m_X_BJ.p());
        const Real coriolis = m_defect == Defect::AccelerationOmitsCoriolis ? 0 : 2;
        put(~X_AJ.R() * (a - A[m_J][0] % r - w % (w % r) - coriolis * (w % (v - w % r))), e);
    }

    void addInPositionConstraintForces(const State& s, const Array<Real>& lambda, Array<SpatialVec, Body>& F,
                                       Qs&) const override {
        const Transform X_AJ = getBodyTransformFromState(s, m_J) * m_X_BJ;
        const Real size = m_defect == Defect::ForceTwiceTooLarge ? 2 : 1;
        const bool twice = m_defect == Defect::SameEquationTwice;
        const Vec3 f_J = twice ? Vec3(lambda[0] + lambda[1], 0, 0) : Vec3(lambda[0], lambda[1], 0);
        const Vec3 f = size * (X_AJ.R() * f_J);
        addInStationForce(s, m_I, m_X_BI.p(), f, F);
        addInStationForce(s, m_J, m_X_BJ.p(), -f, F);
        if (m_defect != Defect::ForceOmitsLever) addInBodyTorque(s, m_J, -calcR(s) % f, F);
    }

private:
    Vec3 calcR(const State& s) const {
        return findStationLocationFromState(s, m_I, m_X_BI.p()) -
               findStationLocationFromState(s, m_J, m_X_BJ.p());
    }

    void put(const Vec3& inJ, Array<Real>& e) const {
        e[0] = inJ[0];
        e[1] = m_defect == Defect::SameEquationTwice ? inJ[0] : inJ[1];
    }

    Defect m_defect;
    Transform m_X_BI, m_X_BJ;
    Body m_I, m_J;
};

}  // namespace jprim::testing

#endif
