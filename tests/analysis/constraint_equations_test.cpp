// SPDX-License-Identifier: Apache-2.0
// Names and words of equations, and systems that are not made of ours.
#include "jprim/analysis/constraint_equations.h"

#include <gtest/gtest.h>

#include "analysis/free_bodies.h"
#include "support/expect_error.h"

namespace jprim {
namespace {

using SimTK::Body;
using SimTK::Constraint;
using SimTK::MobilizedBody;
using SimTK::MobilizerUIndex;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::Vec3;
using testing::FreeBodies;
using testing::getRedundantTexts;
using testing::getTexts;
using testing::makePrimitive;
constexpr int Ground = FreeBodies::Ground;

//------------------------------------------------------------------------------------------ words
Vec3 getAxis(char letter) {
    return Vec3(letter == 'X', letter == 'Y', letter == 'Z');
}

// What the words talk about, for I at pose X in J: "translation of I along Xj", "rotation about Zj",
// "rotation between Zi and Xj".
double measure(const std::string& words, const Transform& X) {
    const Vec3 ofJ = getAxis(words[words.size() - 2]);
    if (words.find("translation of I along ") == 0) return SimTK::dot(X.p(), ofJ);
    if (words.find("rotation about ") == 0) return SimTK::dot(X.R().x(), ofJ % Vec3(1, 0, 0));
    EXPECT_EQ(words.find("rotation between "), 0u) << words;
    return SimTK::dot(X.R() * getAxis(words[17]), ofJ);
}

struct WordsCase {
    const char* name;
    FreeBodies::Make make;
    bool isCrossed;  // z axes at right angles where assembled
};

class EquationWords : public ::testing::TestWithParam<WordsCase> {};

// Each equation changes as what its words say, up to the sense, for every small motion of I.
TEST_P(EquationWords, AreTrue) {
    constexpr double Small = 1e-6, SecondOrder = 1e-11;
    FreeBodies pair;
    pair.addBody();
    const Transform X_GJ(Rotation(0.8, SimTK::UnitVec3(0.6, 0, 0.8)), Vec3(0.3, -0.2, 0.5));
    const Transform X_JI = Rotation(GetParam().isCrossed ? SimTK::Pi / 2 : 0, SimTK::YAxis);
    pair.addJoint(GetParam().make, pair.mark(0, X_GJ * X_JI), pair.mark(Ground, X_GJ));
    pair.draw();
    MobilizedBody body = pair.matter.getMobilizedBody(SimTK::MobilizedBodyIndex(1));
    for (int direction = 0; direction < 6; ++direction) {
        const Vec3 step = Small * Vec3(direction % 3 == 0, direction % 3 == 1, direction % 3 == 2);
        const Transform small =
            direction < 3 ? Transform(step) : Transform(Rotation(Small, SimTK::UnitVec3(step / Small)));
        SimTK::State state = pair.system.realizeTopology();
        body.setQToFitTransform(state, X_GJ * small * ~X_GJ);  // I's body was at Ground's frame
        pair.system.realize(state, SimTK::Stage::Position);
        for (const ConstraintEquation& equation :
             findEquations(pair.matter, state, nameElements(pair.joints))) {
            const double expected = measure(equation.words, small * X_JI) - measure(equation.words, X_JI);
            EXPECT_NEAR(std::abs(state.getQErr()[equation.multiplier]), std::abs(expected), SecondOrder)
                << equation.getText() << ", direction " << direction;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EquationWords,
                         ::testing::Values(WordsCase{"AtPoint", makePrimitive<AtPoint>, false},
                                           WordsCase{"InLine", makePrimitive<InLine>, false},
                                           WordsCase{"InPlane", makePrimitive<InPlane>, false},
                                           WordsCase{"Orientation", makePrimitive<Orientation>, false},
                                           WordsCase{"ParallelAxes", makePrimitive<ParallelAxes>, false},
                                           WordsCase{"Perpendicular", makePrimitive<Perpendicular>, true},
                                           WordsCase{"Translational", Joint::Translational, false},
                                           WordsCase{"Hooke", Joint::Hooke, false}),
                         [](const auto& info) { return info.param.name; });

TEST(ConstraintEquations, JointsAndPrimitivesByTheirNames) {
    FreeBodies pair;
    pair.addBody();
    pair.addJoint(Joint::Hooke, 0, Ground, Transform());
    pair.addJoint(makePrimitive<ParallelAxes>, 0, Ground, Transform());
    pair.joints[1] = Joint(ParallelAxes(pair.mark(0, Vec3(0)), pair.mark(Ground, Vec3(0)), "JPRIM/12"));
    const SimTK::State state = pair.draw();
    const ElementNames names = nameElements({pair.joints[0]});
    const std::vector<ConstraintEquation> equations = findEquations(pair.matter, state, names);
    ASSERT_EQ(equations.size(), 8u);
    EXPECT_EQ(equations[0].getText(), "JOINT/1 HOOKE: translation of I along Xj");
    EXPECT_EQ(equations[3].getText(), "JOINT/1 HOOKE: rotation between Xi and Yj");
    EXPECT_EQ(equations[7].getText(), "JPRIM/12 PARALLEL_AXES: rotation between Zi and Xj");
    EXPECT_EQ(equations[0].dimension, Dimension::Length);
    EXPECT_EQ(equations[3].dimension, Dimension::Angle);
    EXPECT_STREQ(getEquationKind(equations[7].level), "holonomic");
}

TEST(ConstraintEquations, WordsThatDoNotExist) {
    FreeBodies pair;
    pair.addBody();
    pair.addJoint(Joint::Revolute, 0, Ground, Transform());
    const PairConstraint& revolute = *pair.joints[0].getPairConstraint();
    EXPECT_EQ(revolute.describeEquation(4), "rotation between Zi and Xj");
    EXPECT_EQ(testing::catchError([&] { revolute.describeEquation(5); }),
              "JOINT/1 REVOLUTE: has no equation 5; use 0 to 4");
    EXPECT_EQ(testing::catchError([&] { revolute.isTranslational(-1); }),
              "JOINT/1 REVOLUTE: has no equation -1; use 0 to 4");
}

//--------------------------------------------------------------------------- Simbody's constraints
class SimbodyOnly : public ::testing::Test {
protected:
    std::vector<ConstraintEquation> findAll() {
        state = system.realizeTopology();
        system.realize(state, SimTK::Stage::Velocity);
        return findEquations(matter, state);
    }
    std::vector<std::string> nameAll() {
        std::vector<std::string> names;
        for (const ConstraintEquation& e : findAll())
            if (e.number == 0) names.push_back(e.element);
        return names;
    }

    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    Body::Rigid rigid{SimTK::MassProperties(1, Vec3(0), SimTK::Inertia(1))};
    MobilizedBody::Free a{matter.Ground(), rigid}, b{matter.Ground(), rigid};
    MobilizedBody::Pin pin{matter.Ground(), rigid};
    SimTK::State state;
};

TEST_F(SimbodyOnly, AreNamedByClassAndIndex) {
    const SimTK::UnitVec3 z(SimTK::ZAxis);
    Constraint::Rod(a, Vec3(0.1, 0, 0), b, Vec3(-0.2, 0, 1), 1.1);
    Constraint::Ball(a, b);
    Constraint::Weld(a, b);
    Constraint::PointInPlane(a, z, 0, b, Vec3(0));
    Constraint::PointOnLine(a, z, Vec3(0), b, Vec3(0));
    Constraint::ConstantAngle(a, z, b, SimTK::UnitVec3(SimTK::XAxis));
    Constraint::ConstantOrientation(a, Rotation(), b, Rotation());
    Constraint::NoSlip1D(matter.updGround(), Vec3(0), z, a, b);
    Constraint::ConstantCoordinate(pin, 0.);
    Constraint::ConstantSpeed(pin, 0.);
    Constraint::ConstantAcceleration(pin, 0.);
    Constraint::CoordinateCoupler(matter, new SimTK::Function::Linear(SimTK::Vector(2, 1.)),
                                  SimTK::Array_<SimTK::MobilizedBodyIndex>(1, pin.getMobilizedBodyIndex()),
                                  SimTK::Array_<SimTK::MobilizerQIndex>(1, SimTK::MobilizerQIndex(0)));
    const std::vector<std::string> expected = {"Rod (constraint 0)",
                                               "Ball (constraint 1)",
                                               "Weld (constraint 2)",
                                               "PointInPlane (constraint 3)",
                                               "PointOnLine (constraint 4)",
                                               "ConstantAngle (constraint 5)",
                                               "ConstantOrientation (constraint 6)",
                                               "NoSlip1D (constraint 7)",
                                               "ConstantCoordinate (constraint 8)",
                                               "ConstantSpeed (constraint 9)",
                                               "ConstantAcceleration (constraint 10)",
                                               "CoordinateCoupler (constraint 11)"};
    EXPECT_EQ(nameAll(), expected);
}

// A ball says nothing that a weld at the same place has not said. Levels differ: a constant speed implies
// its acceleration.
TEST_F(SimbodyOnly, RedundancyAcrossTypesAndLevels) {
    Constraint::ConstantAcceleration(pin, 0.);
    Constraint::Weld(matter.updGround(), a);
    Constraint::Ball(matter.updGround(), a);
    Constraint::ConstantSpeed(pin, 0.);
    const std::vector<ConstraintEquation> equations = findAll();
    EXPECT_EQ(equations.front().level, KinematicLevel::Acceleration);
    EXPECT_EQ(equations.back().level, KinematicLevel::Velocity);
    EXPECT_STREQ(getEquationKind(equations.front().level), "acceleration");
    EXPECT_STREQ(getEquationKind(equations.back().level), "nonholonomic");
    const ConstraintReport report = analyzeConstraints(matter, state);
    EXPECT_EQ(report.getGrueblerCount(), 13 - 11);
    EXPECT_EQ(report.getDegreesOfFreedom(), 6);
    EXPECT_EQ(getRedundantTexts(report),
              (std::set<std::string>{"Ball (constraint 2): equation 1", "Ball (constraint 2): equation 2",
                                     "Ball (constraint 2): equation 3",
                                     "ConstantSpeed (constraint 3): equation 1"}));
    for (const RedundantEquation& r : report.redundant)
        for (const std::string& text : getTexts(report, r.dependsOn))
            EXPECT_EQ(text.find(report.equations[size_t(r.equation)].element[0] == 'B'
                                    ? "Weld (constraint 1): "
                                    : "ConstantAcceleration (constraint 0): "),
                      0u)
                << text;
}

TEST_F(SimbodyOnly, GivenNamesComeFirst) {
    const Constraint::Rod rod(a, Vec3(0.1, 0, 0), b, Vec3(-0.2, 0, 1), 1.1);
    state = system.realizeTopology();
    system.realize(state, SimTK::Stage::Velocity);
    const ElementNames names = {{rod.getConstraintIndex(), {"GCON/3", {"DM(1,2)-L"}}}};
    EXPECT_EQ(findEquations(matter, state, names)[0].getText(), "GCON/3: DM(1,2)-L");
}

}  // namespace
}  // namespace jprim
