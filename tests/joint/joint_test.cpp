// SPDX-License-Identifier: Apache-2.0
// Each joint of the catalogue against the Simbody mobilizer that allows the same motion: same accelerations
// and reactions at any admissible state, same motion over time.
#include "jprim/joint/joint.h"

#include <gtest/gtest.h>

#include <memory>

#include "jprim/base/error.h"
#include "support/conformance.h"
#include "support/expect_error.h"

namespace jprim {
namespace {

using SimTK::Body;
using SimTK::MobilizedBody;
using SimTK::Pi;
using SimTK::Random;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

// Forces of order 100 N through a factored mass matrix and back.
constexpr double ReactionTolerance = 1e-9;
constexpr double AccelerationTolerance = 1e-9;
// Two integrations at this accuracy, of different equations, over half a second.
constexpr double IntegratorAccuracy = 1e-9;
constexpr double MotionTolerance = 1e-6;

// One body on a moving base, mobilized in one of two ways.
struct Model {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    SimTK::GeneralForceSubsystem forces{system};
    SimTK::Force::Gravity gravity{forces, matter, SimTK::UnitVec3(0.2, -1, 0.1), 9.81};
    Body::Rigid rigid{SimTK::MassProperties(2, Vec3(0.1, 0.05, -0.2), SimTK::Inertia(1, 2, 1.5))};
    MobilizedBody::Free base{matter.Ground(), rigid};
    MobilizedBody body;
    std::vector<Joint> joints;
    State state;

    // Frames of the mobilizer, in general position.
    const Transform X_PF{Rotation(0.4, Vec3(1, 2, -1)), Vec3(0.3, -0.2, 0.1)};
    const Transform X_BM{Rotation(-0.7, Vec3(0, 1, 1)), Vec3(-0.4, 0.2, 0.3)};
};

using AddMobilizer = MobilizedBody (*)(Model&);
using AddJoint = Joint (*)(const Marker&, const Marker&, const std::string&);

struct Case {
    const char* name;
    AddMobilizer addMobilizer;
    AddJoint addJoint;
    Rotation R_MI;  // the joint's markers in the mobilizer's frames
    Rotation R_FJ;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.name;
}

template <class Mobilizer>
MobilizedBody addMobilizer(Model& m) {
    return Mobilizer(m.base, m.X_PF, m.rigid, m.X_BM);
}

// Rotations whose named axis is another axis of the mobilizer.
const Rotation ZtoX(Pi / 2, SimTK::YAxis);   // z of the marker is x of the mobilizer
const Rotation ZtoY(-Pi / 2, SimTK::XAxis);  // z of the marker is y of the mobilizer
const Rotation XtoY(Pi / 2, SimTK::ZAxis);   // x of the marker is y of the mobilizer
const Rotation YtoX(-Pi / 2, SimTK::ZAxis);  // y of the marker is x of the mobilizer

// Simbody's Slider moves along x; its Universal has the bars x_F and y_M.
const Case Cases[] = {
    {"Spherical", addMobilizer<MobilizedBody::Ball>, &Joint::Spherical, {}, {}},
    {"Revolute", addMobilizer<MobilizedBody::Pin>, &Joint::Revolute, {}, {}},
    {"Cylindrical", addMobilizer<MobilizedBody::Cylinder>, &Joint::Cylindrical, {}, {}},
    {"Translational", addMobilizer<MobilizedBody::Slider>, &Joint::Translational, ZtoX, ZtoX},
    {"Planar", addMobilizer<MobilizedBody::Planar>, &Joint::Planar, {}, {}},
    {"Fixed", addMobilizer<MobilizedBody::Weld>, &Joint::Fixed, {}, {}},
    {"Universal", addMobilizer<MobilizedBody::Universal>, &Joint::Universal, ZtoY, ZtoX},
    {"Hooke", addMobilizer<MobilizedBody::Universal>, &Joint::Hooke, XtoY, YtoX}};

class JointAgainstMobilizer : public ::testing::TestWithParam<Case> {
protected:
    JointAgainstMobilizer() {
        m_tree.body = GetParam().addMobilizer(m_tree);
        m_joined.body = MobilizedBody::Free(m_joined.base, m_joined.rigid);
        const Marker I(m_joined.body, m_joined.X_BM * Transform(GetParam().R_MI));
        const Marker J(m_joined.base, m_joined.X_PF * Transform(GetParam().R_FJ));
        m_joined.joints.push_back(GetParam().addJoint(I, J, "JOINT/5"));
        m_tree.state = m_tree.system.realizeTopology();
        m_joined.state = m_joined.system.realizeTopology();
    }

    const Joint& getJoint() const { return m_joined.joints.front(); }

    // A random state of the tree, and the same for the joined bodies.
    void chooseState(int seed) {
        Random::Uniform random(-1, 1);
        random.setSeed(seed);
        for (int i = 0; i < m_tree.state.getNQ(); ++i) m_tree.state.updQ()[i] = random.getValue();
        for (int i = 0; i < m_tree.state.getNU(); ++i) m_tree.state.updU()[i] = random.getValue();
        m_tree.system.realize(m_tree.state, Stage::Acceleration);
        m_joined.base.setQToFitTransform(m_joined.state, m_tree.base.getBodyTransform(m_tree.state));
        m_joined.base.setUToFitVelocity(m_joined.state, m_tree.base.getBodyVelocity(m_tree.state));
        m_joined.body.setQToFitTransform(
            m_joined.state, m_tree.body.findBodyTransformInAnotherBody(m_tree.state, m_tree.base));
        m_joined.system.realize(m_joined.state, Stage::Position);
        m_joined.body.setUToFitVelocity(m_joined.state,
                                        m_tree.body.findBodyVelocityInAnotherBody(m_tree.state, m_tree.base));
        m_joined.system.realize(m_joined.state, Stage::Acceleration);
    }

    Model m_tree, m_joined;
};

TEST_P(JointAgainstMobilizer, SameAccelerationsAndReactions) {
    for (int seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        chooseState(seed);
        ASSERT_LT(m_joined.state.getQErr().norm(), 1e-12)
            << "the mobilizer's state does not satisfy the joint";
        ASSERT_LT(m_joined.state.getUErr().norm(), 1e-12);
        const SpatialVec acceleration = m_tree.body.getBodyAcceleration(m_tree.state);
        EXPECT_LT((m_joined.body.getBodyAcceleration(m_joined.state) - acceleration).norm(),
                  AccelerationTolerance * (1 + acceleration.norm()));

        const SpatialVec onI = m_tree.body.findMobilizerReactionOnBodyAtMInGround(m_tree.state);
        const SpatialVec onJ = m_tree.body.findMobilizerReactionOnParentAtFInGround(m_tree.state);
        EXPECT_GT(onI.norm(), 0.1);
        EXPECT_LT((getJoint().calcReactionOnI(m_joined.state) - onI).norm(),
                  ReactionTolerance * (1 + onI.norm()));
        EXPECT_LT((getJoint().calcReactionOnJ(m_joined.state) - onJ).norm(),
                  ReactionTolerance * (1 + onJ.norm()));
    }
}

TEST_P(JointAgainstMobilizer, SameMotion) {
    chooseState(1);
    for (Model* model : {&m_tree, &m_joined}) {
        SimTK::RungeKuttaMersonIntegrator integrator(model->system);
        integrator.setAccuracy(IntegratorAccuracy);
        SimTK::TimeStepper stepper(model->system, integrator);
        stepper.initialize(model->state);
        stepper.stepTo(0.5);
        model->state = stepper.getState();
        model->system.realize(model->state, Stage::Position);
    }
    const Transform expected = m_tree.body.getBodyTransform(m_tree.state);
    const Transform actual = m_joined.body.getBodyTransform(m_joined.state);
    EXPECT_LT((actual.p() - expected.p()).norm(), MotionTolerance);
    EXPECT_LT((actual.R().asMat33() - expected.R().asMat33()).norm(), MotionTolerance);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, JointAgainstMobilizer, ::testing::ValuesIn(Cases),
                         [](const auto& info) { return std::string(info.param.name); });

// The comparison can fail: HOOKE and UNIVERSAL on each other's markers do not fit the mobilizer's motion.
TEST(JointMutant, WrongBarsAreNoticed) {
    Model m;
    m.body = addMobilizer<MobilizedBody::Universal>(m);
    const Joint wrong = Joint::Hooke(Marker(m.body, m.X_BM * Transform(ZtoY)),
                                     Marker(m.base, m.X_PF * Transform(ZtoX)), "JOINT/5");
    m.state = m.system.realizeTopology();
    m.state.updQ() = 0.4;
    m.system.realize(m.state, Stage::Position);
    EXPECT_GT(std::abs(wrong.getPairConstraint()->calcEquationError(m.state, 3)), 0.1);
}

TEST(Joint, DisablesAllItsEquations) {
    Model m;
    m.body = MobilizedBody::Free(m.base, m.rigid);
    const Joint joint = Joint::Fixed(Marker(m.body), Marker(m.base), "JOINT/1");
    m.state = m.system.realizeTopology();
    joint.disable(m.state);
    EXPECT_TRUE(joint.isDisabled(m.state));
    m.system.realize(m.state, Stage::Acceleration);
    EXPECT_EQ(m.state.getNMultipliers(), 0);
    EXPECT_EQ(joint.calcReactionOnI(m.state).norm(), 0);
    joint.enable(m.state);
    EXPECT_FALSE(joint.isDisabled(m.state));
    m.system.realize(m.state, Stage::Acceleration);
    EXPECT_EQ(m.state.getNMultipliers(), 6);
}

TEST(Joint, AdamsFunctionAndAxes) {
    Model m;
    m.body = MobilizedBody::Free(m.base, m.rigid);
    const Marker other(m.base, m.X_PF);
    const Joint joint = Joint::Revolute(Marker(m.body, m.X_BM), Marker(m.base, m.X_PF), "JOINT/7");
    m.state = m.system.realizeTopology();
    m.system.realize(m.state, Stage::Acceleration);
    const SpatialVec onI = joint.calcReactionOnI(m.state, other);
    const SpatialVec onJ = joint.calcReactionOnJ(m.state, other);
    EXPECT_DOUBLE_EQ(joint.JOINT(m.state, 0, 4, other), onI[1][2]);
    EXPECT_DOUBLE_EQ(joint.JOINT(m.state, 1, 7, other), onJ[0][1]);
    EXPECT_DOUBLE_EQ(joint.JOINT(m.state, 0, 1), onI[1].norm());
    EXPECT_LT((joint.calcReactionOnJAtI(m.state, other) + onI).norm(), 1e-12);
    EXPECT_EQ(
        testing::catchError([&] { joint.JOINT(m.state, 0, 0); }),
        "JOINT/7 REVOLUTE: component 0 of a reaction does not exist; use 1 to 8 for FM FX FY FZ TM TX TY TZ");
}

}  // namespace
}  // namespace jprim
