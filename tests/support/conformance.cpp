// SPDX-License-Identifier: Apache-2.0
#include "support/conformance.h"

#include "jprim/flexible/reduce_to_modes.h"
#include "support/steel_beam.h"

namespace jprim::testing {

using namespace SimTK;

Vec3 makeRandomVec3(Random& random) {
    return {random.getValue(), random.getValue(), random.getValue()};
}

// Shoemake: four normal deviates give a quaternion that is uniform on the sphere.
Rotation makeRandomRotation(Random& random) {
    const auto normal = [&random] {
        const Real u = (random.getValue() + 1) / 2, v = random.getValue();
        return std::sqrt(-2 * std::log(std::max(u, TinyReal))) * std::cos(Pi * v);
    };
    const Vec4 q(normal(), normal(), normal(), normal());
    return Rotation(Quaternion(q / q.norm()));
}

namespace {

// Poses of the markers on what carries them, unlike each other and unlike anything simple.
const Transform PoseI(Rotation(0.7, Vec3(1, -2, 0.5)), Vec3(0.4, -0.1, 0.25));
const Transform PoseJ(Rotation(-1.1, Vec3(0.3, 1, 2)), Vec3(-0.2, 0.35, 0.15));

// A beam with five modes of all kinds; those of its second interface turn where it does not move much.
const ModalBasis& getBasis() {
    static const ModalBasis basis =
        reduceToModes(makeFiniteElementModel(makeSteelBeam(3)), {{{4}, 0, {}}}, 5);
    return basis;
}

class Fixture {
public:
    Fixture(const AddConstraint& add, Tree tree) : m_matter(m_system), m_forces(m_system) {
        const Body::Rigid body(MassProperties(1.7, Vec3(0.1, -0.2, 0.05), Inertia(0.5, 0.6, 0.4)));
        const Transform X_PF(Rotation(0.4, XAxis), Vec3(0.3, 0.1, -0.2));
        MobilizedBody::Free ancestor(m_matter.Ground(), body);
        MobilizedBody::Free first(ancestor, X_PF, body, Transform(Vec3(0.1, 0.2, 0.3)));
        MobilizedBody::Ball second(ancestor, Transform(), body, X_PF);
        Marker I(first, PoseI), J(second, PoseJ);
        if (tree == Tree::IOnGround) I = Marker(m_matter.updGround(), PoseI);
        if (tree == Tree::JOnGround) J = Marker(m_matter.updGround(), PoseJ);
        if (tree == Tree::FlexibleI || tree == Tree::FlexibleBoth)
            I = Marker(FlexibleBody(m_matter, m_forces, getBasis()), 4, PoseI);
        if (tree == Tree::FlexibleJ || tree == Tree::FlexibleBoth)
            J = Marker(FlexibleBody(m_matter, m_forces, getBasis()), 2, PoseJ);
        m_constraint = add(I, J);
        m_state = m_system.realizeTopology();
        // Without quaternions every q is free, and a polynomial in time is a possible motion.
        m_matter.setUseEulerAngles(m_state, true);
        m_system.realizeModel(m_state);
    }

    Conformance measure(int seed) {
        Random::Uniform random(-1, 1);
        random.setSeed(seed);
        chooseMotion(random);
        Conformance result;
        compareDerivatives(result);
        comparePower(random, result);
        return result;
    }

private:
    // q(t) = q0 + q1 t + q2 t^2/2, off the manifold with probability 1.
    void chooseMotion(Random& random) {
        const int nq = m_state.getNQ();
        for (Vector* v : {&m_q0, &m_q1, &m_q2}) {
            v->resize(nq);
            for (int i = 0; i < nq; ++i) (*v)[i] = random.getValue();
        }
    }

    void moveTo(Real t) {
        m_state.updTime() = t;
        m_state.updQ() = m_q0 + t * m_q1 + (t * t / 2) * m_q2;
        m_system.realize(m_state, Stage::Position);
        Vector u;
        m_matter.multiplyByNInv(m_state, false, Vector(m_q1 + t * m_q2), u);
        m_state.updU() = u;
        m_system.realize(m_state, Stage::Velocity);
    }

    // d2q/dt2 = N du/dt + dN/dt u
    Vector calcUDot() {
        Vector NDotU, udot;
        m_matter.multiplyByNDot(m_state, false, m_state.getU(), NDotU);
        m_matter.multiplyByNInv(m_state, false, Vector(m_q2 - NDotU), udot);
        return udot;
    }

    Vector calcErrors(Real t) {
        moveTo(t);
        return m_constraint.getPositionErrorsAsVector(m_state);
    }

    Vector calcRates(Real t) {
        moveTo(t);
        return m_constraint.getVelocityErrorsAsVector(m_state);
    }

    // Central difference of sixth order: with this step truncation and rounding are both below 1e-11.
    template <class Function>
    Vector differentiate(Function f) {
        const Real h = 2e-3;
        const Vector d1 = f(h) - f(-h), d2 = f(2 * h) - f(-2 * h), d3 = f(3 * h) - f(-3 * h);
        return (45. * d1 - 9. * d2 + d3) / (60 * h);
    }

    void compareDerivatives(Conformance& result) {
        const bool hasErrors = calcErrors(0).size() > 0;  // a constraint of velocities has none
        const Vector accelerationDifference = differentiate([this](Real t) { return calcRates(t); });
        const Vector rate = calcRates(0);
        Vector acceleration;
        m_matter.calcConstraintAccelerationErrors(m_state, calcUDot(), acceleration);
        if (hasErrors) {
            const Vector rateDifference = differentiate([this](Real t) { return calcErrors(t); });
            result.rateError = (rate - rateDifference).norm() / (1 + rate.norm());
        }
        result.accelerationError = (acceleration - accelerationDifference).norm() / (1 + acceleration.norm());
    }

    void comparePower(Random& random, Conformance& result) {
        Matrix G, Gt;
        m_matter.calcG(m_state, G);            // from the errors
        m_matter.calcGTranspose(m_state, Gt);  // from the forces
        result.equations = G.nrow();
        result.powerError = (G - ~Gt).norm() / G.norm();
        result.rank = FactorQTZ(G, 1e-9).getRank();

        Vector lambda(G.nrow()), mobilityForces;
        for (int i = 0; i < lambda.size(); ++i) lambda[i] = random.getValue();
        Vector_<SpatialVec> forces_A;
        m_constraint.calcConstraintForcesFromMultipliers(m_state, lambda, forces_A, mobilityForces);
        result.netLoad = calcNetLoad(forces_A, makeRandomVec3(random) * 10);
    }

    // Sum of the forces, each at its body's origin, moved to `point`; everything in the ancestor's frame.
    Real calcNetLoad(const Vector_<SpatialVec>& forces_A, const Vec3& point) {
        const Transform X_GA = m_constraint.getAncestorMobilizedBody().getBodyTransform(m_state);
        SpatialVec sum(Vec3(0), Vec3(0));
        Real size = 0;
        for (ConstrainedBodyIndex b(0); b < forces_A.size(); ++b) {
            const MobilizedBody& body = m_constraint.getMobilizedBodyFromConstrainedBody(b);
            const Vec3 p_AB = ~X_GA * body.getBodyOriginLocation(m_state);
            sum += shiftForceBy(forces_A[b], point - p_AB);
            size += forces_A[b].norm();
        }
        return sum.norm() / size;
    }

    MultibodySystem m_system;
    SimbodyMatterSubsystem m_matter;
    GeneralForceSubsystem m_forces;
    Constraint m_constraint;
    State m_state;
    Vector m_q0, m_q1, m_q2;
};

}  // namespace

const char* getName(Tree tree) {
    static const char* const names[] = {"AncestorMoves", "IOnGround", "JOnGround",
                                        "FlexibleI",     "FlexibleJ", "FlexibleBoth"};
    return names[int(tree)];
}

Conformance measureConformance(const AddConstraint& add, Tree tree, int seed) {
    return Fixture(add, tree).measure(seed);
}

}  // namespace jprim::testing
