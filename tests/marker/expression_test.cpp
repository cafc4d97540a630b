// SPDX-License-Identifier: Apache-2.0
// Expressions as programs use them: what they are, what they depend on, and what a program defines for them.
#include "jprim/marker/expression.h"

#include <gtest/gtest.h>

#include <cmath>

#include "jprim/force/marker_force.h"
#include "jprim/joint/motion.h"
#include "support/expect_error.h"

namespace jprim {
namespace {

using SimTK::Body;
using SimTK::GeneralForceSubsystem;
using SimTK::Inertia;
using SimTK::MassProperties;
using SimTK::MobilizedBody;
using SimTK::MultibodySystem;
using SimTK::Pi;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::SimbodyMatterSubsystem;
using SimTK::SpatialVec;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;
using SimTK::Vector;
using testing::catchError;

constexpr Real Rounding = 1e-13;

// Two free bodies in general position and motion.
struct Model {
    Model() {
        state = system.realizeTopology();
        a.setQToFitTransform(state, Transform(Rotation(0.7, Vec3(1, -2, 0.5)), Vec3(0.3, 1.1, -0.4)));
        b.setQToFitTransform(state, Transform(Rotation(-1.1, Vec3(0.2, 1, 0.5)), Vec3(-0.6, 0.2, 0.9)));
        a.setUToFitVelocity(state, SpatialVec(Vec3(0.3, 0.7, -1.2), Vec3(0.6, -0.2, 0.4)));
        state.setTime(0.35);
        system.realize(state, Stage::Acceleration);
    }

    Expression make(const std::string& text, const ExpressionDefinitions& definitions = {}) const {
        return Expression(text, {{1, Marker(a)}, {2, Marker(b)}}, definitions);
    }

    MultibodySystem system;
    SimbodyMatterSubsystem matter{system};
    GeneralForceSubsystem forces{system};
    Body::Rigid body{MassProperties(1.3, Vec3(0), Inertia(0.5, 0.6, 0.4))};
    MobilizedBody::Free a{matter.Ground(), body}, b{matter.Ground(), body};
    State state;
};

struct Dependence {
    const char* text;
    bool isVector;
    Stage::Level stage;
    bool ofTime, isLinear;
    std::vector<int> markers;
};

TEST(Expression, TellsWhatItIsAndWhatItDependsOn) {
    const Dependence cases[] = {{"1+2", false, Stage::Time, false, true, {}},
                                {"[TIME,1,2]", true, Stage::Time, true, true, {}},
                                {"DM(2,1)-0.5", false, Stage::Position, false, true, {1, 2}},
                                {"DXYZ(2)", true, Stage::Position, false, true, {2}},
                                {"VX(1)-WZ(1)*DY(2)", false, Stage::Velocity, false, true, {1, 2}},
                                {"VM(1)*TIME", false, Stage::Velocity, true, false, {1}},
                                {"ACCXYZ(1,2)", true, Stage::Acceleration, false, false, {1, 2}}};
    const Model model;
    for (const Dependence& c : cases) {
        SCOPED_TRACE(c.text);
        const Expression expression = model.make(c.text);
        EXPECT_EQ(expression.isVector(), c.isVector);
        EXPECT_EQ(expression.getDependsOnStage(), c.stage);
        EXPECT_EQ(expression.dependsOnTime(), c.ofTime);
        EXPECT_EQ(expression.isLinearInVelocity(), c.isLinear);
        EXPECT_EQ(expression.getMarkers(), c.markers);
    }
}

// Against Simbody's own vectors; the state of the stage that is told is enough.
TEST(Expression, HasVectorsForValues) {
    Model m;
    const Vec3 r = m.a.getBodyOriginLocation(m.state) - m.b.getBodyOriginLocation(m.state);
    const Vec3 v = m.a.getBodyOriginVelocity(m.state), w = m.a.getBodyAngularVelocity(m.state);
    const std::pair<const char*, Vec3> cases[] = {
        {"DXYZ(1,2)", r},
        {"DXYZ(1,2,1)", ~m.a.getBodyRotation(m.state) * r},
        {"VXYZ(1)%WXYZ(1)", v % w},
        {"2*UV(DXYZ(1,2))-[TIME,1,2]/4", 2 * r / r.norm() - Vec3(0.35, 1, 2) / 4},
        {"(VXYZ(1)*WXYZ(1))*UVX(2)", SimTK::dot(v, w) * Vec3(m.b.getBodyRotation(m.state).x())}};
    for (const auto& [text, expected] : cases) {
        const Expression expression = m.make(text);
        m.state.invalidateAll(Stage(int(expression.getDependsOnStage()) + 1));
        m.system.realize(m.state, expression.getDependsOnStage());
        EXPECT_LT((expression.calcVector(m.state) - expected).norm(), Rounding) << text;
    }
}

TEST(Expression, RefusesToBeWhatItIsNot) {
    const Model m;
    EXPECT_EQ(catchError([&] { m.make("DXYZ(1)").calcValue(m.state); }),
              "Expression::calcValue(): the expression is a vector; use calcVector()");
    EXPECT_EQ(catchError([&] { m.make("DM(1)").calcVector(m.state); }),
              "Expression::calcVector(): the expression is a number; use calcValue()");
}

//-------------------------------------------------------------------------------- what a program defines
TEST(Expression, HasSplinesAndVariablesOfTheProgram) {
    const Model m;
    ExpressionDefinitions definitions;
    definitions.splines.emplace(7, InterpolatingSpline("SPLINE/7", {-2, -1, 0, 1, 2}, {4, 1, 0, 1, 4}));
    definitions.variables = {{1, "DM(1,2)"}, {2, "VARVAL(1)**2+AKISPL(TIME,0,7)"}};
    const Real distance = m.make("DM(1,2)").calcValue(m.state);
    const InterpolatingSpline& spline = definitions.splines.at(7);
    const Real onSpline = spline.calcDerivative(InterpolatingSpline::Method::Akima, 0.35, 0, 0);
    EXPECT_NEAR(m.make("VARVAL(2)", definitions).calcValue(m.state), distance * distance + onSpline,
                Rounding);
    EXPECT_NEAR(m.make("CUBSPL(TIME,0,7,1)", definitions).calcValue(m.state),
                spline.calcDerivative(InterpolatingSpline::Method::Cubic, 0.35, 0, 1), Rounding);
}

// x^2 z + 3 x with its derivatives.
class Product : public SimTK::Function {
public:
    explicit Product(int derivatives = 2) : m_derivatives(derivatives) {}
    Real calcValue(const Vector& x) const override { return x[0] * x[0] * x[1] + 3 * x[0]; }
    Real calcDerivative(const SimTK::Array_<int>& by, const Vector& x) const override {
        if (by.size() == 1) return by[0] == 0 ? 2 * x[0] * x[1] + 3 : x[0] * x[0];
        return by[0] == by[1] ? (by[0] == 0 ? 2 * x[1] : 0) : 2 * x[0];
    }
    int getArgumentSize() const override { return 2; }
    int getMaxDerivativeOrder() const override { return m_derivatives; }

private:
    int m_derivatives;
};

// The same from the function and from the language: value, load and the accelerations it gives as an equation.
TEST(Expression, AFunctionOfTheProgramIsAsGoodAsTheLanguage) {
    const auto accelerate = [](const std::string& text, const ExpressionDefinitions& definitions) {
        Model m;
        const GeneralConstraint equation(m.make(text, definitions), "equation");
        State state = m.system.realizeTopology();
        state.updQ() = m.state.getQ();
        state.updU() = m.state.getU();
        state.setTime(0.35);
        m.system.realize(state, Stage::Acceleration);
        Vector all(state.getNU() + 2);
        all(0, state.getNU()) = state.getUDot();
        all[state.getNU()] = state.getQErr()[0];
        all[state.getNU() + 1] = state.getUErr()[0];
        return all;
    };
    ExpressionDefinitions definitions;
    definitions.functions["Product"] = std::make_shared<Product>();
    const Vector own = accelerate("DX(1,2)**2*DY(1,2,2)+3*DX(1,2)-TIME", {});
    const Vector given = accelerate("product(DX(1,2),DY(1,2,2))-TIME", definitions);
    EXPECT_GT(own.norm(), 1);
    EXPECT_LT((own - given).norm(), Rounding * own.norm() * 100);  // through a factored mass matrix
}

// A slider driven by Simbody's sinusoid, and a spring that is its function of the length.
TEST(Expression, MotionsAndForcesAreGivenByFunctions) {
    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    GeneralForceSubsystem forces(system);
    const Body::Rigid body(MassProperties(2, Vec3(0), Inertia(1)));
    MobilizedBody::Free driven(matter.Ground(), body), free(matter.Ground(), body);
    const Marker I(driven), J(matter.updGround()), F(free);
    const auto sine = std::make_shared<SimTK::Function::Sinusoid>(0.3, 2, 0.1);  // 0.3 sin(2 t + 0.1)
    const GeneralConstraint motion(makeCoordinate(I, J, Coordinate::Z), Expression::ofTime(sine),
                                   KinematicLevel::Position, 0, "motion");
    ExpressionDefinitions definitions;
    definitions.functions["K"] =
        std::make_shared<SimTK::Function::Linear>(Vector(SimTK::Vec2(-50, 20)));  // -50 x + 20
    ForceLaw law;
    law.force = Expression("K(DM(1,2))*UV(DXYZ(1,2))", {{1, F}, {2, J}}, definitions);
    const MarkerForce spring(forces, F, J, law, "spring");
    State state = system.realizeTopology();
    state.setTime(0.4);
    const Real phase = 2 * 0.4 + 0.1;
    driven.setQToFitTranslation(state, Vec3(0.1, 0.2, 0.3 * std::sin(phase)));
    driven.setUToFitLinearVelocity(state, Vec3(0, 0, 0.6 * std::cos(phase)));
    free.setQToFitTranslation(state, Vec3(0.2, -0.3, 0.6));
    system.realize(state, Stage::Acceleration);
    EXPECT_NEAR(state.getQErr()[0], 0, Rounding);
    EXPECT_NEAR(state.getUErr()[0], 0, Rounding);
    EXPECT_NEAR(driven.getBodyOriginAcceleration(state)[2], -1.2 * std::sin(phase), Rounding * 10);
    const Vec3 r(0.2, -0.3, 0.6);
    EXPECT_LT((spring.calcLoadOnI(state)[1] - (-50 * r.norm() + 20) * r / r.norm()).norm(), Rounding * 100);
}

//------------------------------------------------------------------------------------------ mistakes
TEST(Expression, MistakesAreExplained) {
    const Model m;
    const auto explain = [&m](const std::string& text, const ExpressionDefinitions& definitions) {
        return catchError([&] { m.make(text, definitions); });
    };
    const auto define = [](const std::string& name, const std::shared_ptr<const SimTK::Function>& function) {
        ExpressionDefinitions definitions;
        definitions.functions[name] = function;
        return definitions;
    };
    const auto product = std::make_shared<Product>();
    EXPECT_EQ(explain("P(1)", define("P", product)),
              "expression \"P(1)\": column 1: P takes 2 arguments, not 1");
    EXPECT_EQ(explain("1", define("dx", product)),
              "function 'dx': the name is taken; small and capital letters are the same");
    EXPECT_EQ(explain("1", define("Step", product)),
              "function 'Step': the name is taken; small and capital letters are the same");
    EXPECT_EQ(explain("1", define("P", nullptr)), "function 'P': it is a null pointer");
    EXPECT_EQ(explain("1", define("P", std::make_shared<SimTK::Function::Constant>(1, 3))),
              "function 'P': it takes 3 arguments; it must take 1 or 2");
    EXPECT_EQ(
        explain("2*JOINT(1,0,2)", {}),
        "expression \"2*JOINT(1,0,2)\": column 3: JOINT is known in datasets alone; a program asks the element "
        "itself, as by calcReactionOnI()");
    EXPECT_EQ(explain("DIF(1)", {}), "expression \"DIF(1)\": column 1: DIF is not supported");
    EXPECT_EQ(explain("VARVAL(3)", {}), "expression \"VARVAL(3)\": column 8: VARIABLE/3 does not exist");
    EXPECT_EQ(explain("1+VARVAL(3)", {{}, {{3, "2*VARVAL(3)"}}, {}}),
              "expression \"1+VARVAL(3)\": column 3: in VARIABLE/3: VARIABLE/3 depends on itself; implicit "
              "variables are not supported");
    EXPECT_EQ(explain("AKISPL(TIME,0,7)", {}),
              "expression \"AKISPL(TIME,0,7)\": column 15: there is no SPLINE/7");
    EXPECT_EQ(catchError([&] { Expression::ofTime(product); }),
              "function of TIME: it takes 2 arguments; it must take 1");
    EXPECT_EQ(catchError([] { Expression::ofTime(nullptr); }), "function of TIME: it is a null pointer");
}

// Derivatives that a function lacks are asked for where they are needed, not taken for zero.
TEST(Expression, LackingDerivativesAreRefusedWhereTheyAreNeeded) {
    Model m;
    ExpressionDefinitions definitions;
    definitions.functions["P"] = std::make_shared<Product>(0);
    const Expression value = m.make("P(DX(1),DY(2))", definitions);
    EXPECT_NO_THROW(value.calcValue(m.state));
    const std::string lacking =
        "a function in it has derivatives up to order 0, by its getMaxDerivativeOrder(); order ";
    EXPECT_EQ(catchError([&] { GeneralConstraint(value, "gcon"); }), "gcon: " + lacking + "2 is needed");
    ForceLaw law;
    law.potential = value;
    EXPECT_EQ(catchError([&] { MarkerForce(m.forces, Marker(m.a), Marker(m.b), law, "force"); }),
              "force: " + lacking + "1 is needed");
    law.potential.reset();
    law.force = m.make("[P(DX(1),DY(2)),0,0]", definitions);
    EXPECT_NO_THROW(MarkerForce(m.forces, Marker(m.a), Marker(m.b), law, "force"));
}

}  // namespace
}  // namespace jprim
