// SPDX-License-Identifier: Apache-2.0
// Control systems against exact solutions.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "support/dataset_units.h"
#include "support/linear_flow.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using testing::buildOrFail;
using testing::calcDeviation;
using testing::DatasetUnits;
using testing::MetreSecond;

class Control : public testing::InBothUnits {};
JPRIM_INSTANTIATE_IN_BOTH_UNITS(Control);

// A body at rest that nothing moves, beside the statements.
std::string makeModel(const DatasetUnits& u, const std::string& statements) {
    return fmt::format(
        "control\n{}PART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=1,1,1\nMARKER/20\n{}\nEND\n",
        u.statement, statements);
}

SimulationOutcome runBy(const std::string& integrator, const Mechanism& mechanism, double end,
                        double accuracy) {
    SimulationOptions options;
    options.end = end;
    options.steps = 20;
    options.accuracy = accuracy;
    options.integrator = integrator;
    const SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
    EXPECT_EQ(outcome.failure, "");
    return outcome;
}

std::vector<double> getColumn(const SimulationOutcome& outcome, const std::string& name) {
    return outcome.results.requests.getColumn(name);
}

double calcDeviationOf(const DatasetUnits& u, const SimulationOutcome& outcome, const std::string& name,
                       double (*law)(double)) {
    return calcDeviation(getColumn(outcome, "time"), u.s, getColumn(outcome, name), 1, law);
}

// One period of cos and sin. Simbody's Verlet is of second order, and its semi-explicit Euler of first in such states.
TEST_P(Control, AnOscillatorOfTwoStatesByAllIntegrators) {
    struct Case {
        const char* integrator;
        double accuracy, tolerance;
    };
    const Mechanism mechanism =
        buildOrFail(makeModel(u, fmt::format("DIFF/1,IC=1,FUNCTION=-DIF(2)/{0}\nDIFF/2,FUNCTION=DIF(1)/{0}\n"
                                             "REQUEST/1,F2=DIF(1)\\F3=DIF(2)\\F4={0}*DIF1(1)",
                                             u.s)));
    for (const Case& c :
         {Case{"RungeKuttaMerson", 1e-9, 1e-7}, Case{"RungeKutta3", 1e-9, 1e-7}, Case{"CPodes", 1e-9, 1e-7},
          Case{"Verlet", 1e-8, 1e-5}, Case{"SemiExplicitEuler2", 1e-6, 1e-2}}) {
        SCOPED_TRACE(c.integrator);
        const SimulationOutcome outcome = runBy(c.integrator, mechanism, 2 * SimTK::Pi * u.s, c.accuracy);
        EXPECT_LT(calcDeviationOf(u, outcome, "R1.F2", [](double t) { return std::cos(t); }), c.tolerance);
        EXPECT_LT(calcDeviationOf(u, outcome, "R1.F3", [](double t) { return std::sin(t); }), c.tolerance);
        EXPECT_LT(calcDeviationOf(u, outcome, "R1.F4", [](double t) { return -std::sin(t); }), c.tolerance);
    }
}

// Errors are held against how large a state is: a millionth of the size comes out with as many digits.
TEST(ControlAccuracy, IsRelativeToTheSizeOfAState) {
    const Mechanism mechanism =
        buildOrFail(makeModel(MetreSecond,
                              "DIFF/1,IC=1E6,FUNCTION=-DIF(2)\nDIFF/2,FUNCTION=DIF(1)\n"
                              "DIFF/3,IC=1E-3,FUNCTION=-DIF(4)\nDIFF/4,FUNCTION=DIF(3)\n"
                              "REQUEST/1,F2=1E-6*DIF(1)\\F3=1E3*DIF(3)"));
    for (const char* integrator : {"RungeKuttaMerson", "CPodes"}) {
        const SimulationOutcome outcome = runBy(integrator, mechanism, 2 * SimTK::Pi, 1e-8);
        for (const char* name : {"R1.F2", "R1.F3"})
            EXPECT_LT(calcDeviationOf(MetreSecond, outcome, name, [](double t) { return std::cos(t); }), 2e-6)
                << integrator << name;
    }
}

// A cart under a constant force, held at a place by a PID controller whose derivative is filtered.
constexpr double Mass = 2, Load = -6, Target = 0.5, Kp = 40, Ki = 30, Kd = 8, Filter = 0.1, Start = 0.1;

std::string makeCart(const DatasetUnits& u, double ki = Ki) {
    return fmt::format(
        "cart\n{}ACCGRAV/IGRAV={}\nPART/1,GROUND\nMARKER/10,REULER=90D,90D,0\nPART/2,MASS={},CM=20,IP=1,1,1\n"
        ",QG={},0,0\nMARKER/20,REULER=90D,90D,0\nJOINT/1,TRANSLATIONAL,I=20,J=10\n"
        "VARIABLE/1,FUNCTION={}-DX(20)\nDIFF/1,FUNCTION=VARVAL(1)/{}\n"
        "DIFF/2,IC={},FUNCTION=(VARVAL(1)-DIF(2))/{}\n"
        "SFORCE/1,TRANSLATIONAL,ACTIONONLY,I=20,J=10\n,FUNCTION=({}*VARVAL(1)+{}*DIF(1)+{}*DIF1(2))\n"
        "REQUEST/1,F2=DIF(1)\\F3=DIF(2)\\F4=DX(20)\\F5=VX(20)\nEND\n",
        u.statement, Load / Mass * u.m / u.s / u.s, Mass, Start * u.m, Target * u.m, u.s,
        (Target - Start) * u.m, Filter * u.s, Kp / u.m, ki / u.m, Kd * u.s / u.m);
}

// x, v, the integral of e = target - x, and e filtered: m dv/dt = kp e + ki i + kd (e - f) / T + load.
Eigen::VectorXd calcCart(double t) {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(4, 4);
    Eigen::VectorXd b(4), start(4);
    const double direct = Kp + Kd / Filter;
    A(0, 1) = 1;
    A.row(1) << -direct / Mass, 0, Ki / Mass, -Kd / Filter / Mass;
    A(2, 0) = -1;
    A.row(3) << -1 / Filter, 0, 0, -1 / Filter;
    b << 0, (direct * Target + Load) / Mass, Target, Target / Filter;
    start << Start, 0, 0, Target - Start;
    return testing::flow(A, b, start, t);
}

double calcDeviationOfCart(const DatasetUnits& u, const SimulationOutcome& outcome) {
    const auto deviation = [&](const char* name, double unit, int k) {
        return calcDeviation(getColumn(outcome, "time"), u.s, getColumn(outcome, name), unit,
                             [k](double t) { return calcCart(t)[k]; });
    };
    return std::max({deviation("R1.F4", u.m, 0), deviation("R1.F5", u.m / u.s, 1), deviation("R1.F2", u.m, 2),
                     deviation("R1.F3", u.m, 3)});
}

constexpr double CartTolerance = 1e-7;  // at an accuracy of 1e-9

TEST_P(Control, APidControlledCartMovesAsTheMatrixExponentialSays) {
    for (const char* integrator : {"RungeKuttaMerson", "RungeKutta3", "CPodes"}) {
        const SimulationOutcome outcome = runBy(integrator, buildOrFail(makeCart(u)), 3 * u.s, 1e-9);
        EXPECT_LT(calcDeviationOfCart(u, outcome), CartTolerance) << integrator;
    }
}

// The controller's force has no potential, so its work is integrated.
TEST_P(Control, TheWorkOfAControllerIsInTheBalance) {
    for (const char* integrator : {"RungeKuttaMerson", "CPodes", "Verlet"}) {
        const SimulationSummary summary = runBy(integrator, buildOrFail(makeCart(u)), 3 * u.s, 1e-7).summary;
        EXPECT_GT(summary.largestEnergyChange, 0.1 * summary.energyScale);
        EXPECT_LT(summary.largestImbalance, 1e-4 * summary.energyScale) << integrator;
    }
}

TEST(ControlMutated, OnePercentMoreIntegralGainIsNoticed) {
    const Mechanism mechanism = buildOrFail(makeCart(MetreSecond, 1.01 * Ki));
    EXPECT_GT(calcDeviationOfCart(MetreSecond, runBy("RungeKuttaMerson", mechanism, 3, 1e-9)),
              1e3 * CartTolerance);
}

// 1 / (1 + 0.2 s) and (3 + s + 2 s^2) / (25 + 4 s + s^2), which goes through to the output at once.
constexpr double T = 0.2, B0 = 3, B1 = 1, B2 = 2, A0 = 25, A1 = 4;

double calcFirstOrder(double t) {
    return 1 - std::exp(-t / T);
}

double calcSecondOrder(double t) {
    const double sigma = A1 / 2, w = std::sqrt(A0 - sigma * sigma), decay = std::exp(-sigma * t);
    const double step = (1 - decay * (std::cos(w * t) + sigma / w * std::sin(w * t))) / A0;
    const double pulse = decay * std::sin(w * t) / w;
    return B2 + (B0 - A0 * B2) * step + (B1 - A1 * B2) * pulse;
}

TEST_P(Control, StepResponsesOfTransferFunctions) {
    const Mechanism mechanism = buildOrFail(makeModel(
        u,
        fmt::format("VARIABLE/1,FUNCTION=1\nARRAY/1,X,SIZE=1\nARRAY/2,U,VARIABLES=1\nARRAY/3,Y\nARRAY/4,X\n"
                    "ARRAY/5,Y,SIZE=1\nTFSISO/1,X=1,U=2,Y=3,NUMERATOR=1,DENOMINATOR=1,{0}\n"
                    "TFSISO/2,X=4,U=2,Y=5,NUM={1},{2},{3},DEN={4},{5},{6}\n"
                    "REQUEST/1,F2=ARYVAL(3,1)\\F3=ARYVAL(5,1)\\F4=ARYVAL(2,1)",
                    T * u.s, B0, B1 * u.s, B2 * u.s * u.s, A0, A1 * u.s, u.s * u.s)));
    for (const char* integrator : {"RungeKuttaMerson", "CPodes"}) {
        const SimulationOutcome outcome = runBy(integrator, mechanism, 2 * u.s, 1e-9);
        EXPECT_LT(calcDeviationOf(u, outcome, "R1.F2", calcFirstOrder), 1e-7) << integrator;
        EXPECT_LT(calcDeviationOf(u, outcome, "R1.F3", calcSecondOrder), 1e-7) << integrator;
        EXPECT_EQ(getColumn(outcome, "R1.F4").back(), 1);
    }
}

// 2 z' + exp(z' - 1) = 3 - z + t, which z = t satisfies; and cos and sin, where an explicit equation reads an implicit one.
TEST_P(Control, AnImplicitEquationIsSolvedForTheDerivative) {
    const Mechanism mechanism = buildOrFail(makeModel(
        u,
        fmt::format("DIFF/1,IC=0,{1},IMPLICIT,FUNCTION=2*{0}*DIF1(1)+EXP({0}*DIF1(1)-1)-3+DIF(1)-TIME/{0}\n"
                    "DIFF/2,IC=1,IMPLICIT,FUNCTION={0}*DIF1(2)+DIF(3)*{0}*DIF1(1)\n"
                    "DIFF/3,FUNCTION=-DIF1(2)*0+DIF(2)/{0}\nREQUEST/1,F2=DIF(1)\\F3=DIF(2)\\F4={0}*DIF1(2)",
                    u.s, 0.5 / u.s)));
    for (const char* integrator : {"RungeKuttaMerson", "CPodes"}) {
        const SimulationOutcome outcome = runBy(integrator, mechanism, 2 * u.s, 1e-9);
        EXPECT_LT(calcDeviationOf(u, outcome, "R1.F2", [](double t) { return t; }), 1e-7) << integrator;
        EXPECT_LT(calcDeviationOf(u, outcome, "R1.F3", [](double t) { return std::cos(t); }), 1e-7)
            << integrator;
        EXPECT_LT(calcDeviationOf(u, outcome, "R1.F4", [](double t) { return -std::sin(t); }), 1e-7)
            << integrator;
    }
}

// The same three equations by matrices and one by one.
TEST(ControlSystems, AnLseIsTheSameAsItsDiffs) {
    const Mechanism mechanism = buildOrFail(makeModel(
        MetreSecond,
        "VARIABLE/1,FUNCTION=SIN(3*TIME)\nVARIABLE/2,FUNCTION=DX(20)\nARRAY/1,X\nARRAY/2,U,VAR=1,2\nARRAY/3,Y\n"
        "ARRAY/4,IC,NUM=1,0,-2\nMATRIX/1,M=3,N=3,VALUES=-1,2,0, 0,-2,3, -4,0,-1\n"
        "MATRIX/2,FULL=CORDER,M=3,N=2,VALUES=1,0,2, 0,3,1\nMATRIX/3,SPARSE,M=2,N=3,VALUES=1,1,5, 2,3,-1, 2,2,4\n"
        "MATRIX/4,M=2,N=2,VALUES=0,7,8,0\nLSE/1,X=1,U=2,Y=3,IC=4,A=1,B=2,C=3,D=4\n"
        "SFORCE/1,TRANSLATIONAL,ACTIONONLY,I=20,J=11,FUNCTION=ARYVAL(3,2)\nMARKER/11,PART=1,REULER=90D,90D,0\n"
        "DIFF/1,IC=1,FUNCTION=-DIF(1)+2*DIF(2)+VARVAL(1)\nDIFF/2,FUNCTION=-2*DIF(2)+3*DIF(3)+3*DX(20)\n"
        "DIFF/3,IC=-2,FUNCTION=-4*DIF(1)-DIF(3)+2*VARVAL(1)+VARVAL(2)\n"
        "REQUEST/1,F2=ARYVAL(1,1)-DIF(1)\\F3=ARYVAL(1,2)-DIF(2)\\F4=ARYVAL(1,3)-DIF(3)"
        "\\F5=ARYVAL(3,1)-5*DIF(1)-7*DX(20)\\F6=ARYVAL(3,2)+DIF(3)-4*DIF(2)-8*VARVAL(1)\\F7=ARYVAL(1,1)"
        "\\F8=ARYVAL(4,3)"));
    const SimulationOutcome outcome = runBy("RungeKuttaMerson", mechanism, 2, 1e-7);
    constexpr double Rounding = 1e-12;
    for (const char* name : {"R1.F2", "R1.F3", "R1.F4", "R1.F5", "R1.F6"})
        for (const double difference : getColumn(outcome, name)) EXPECT_NEAR(difference, 0, Rounding) << name;
    EXPECT_LT(getColumn(outcome, "R1.F7")[10], 0.9) << "it moves";
    EXPECT_EQ(getColumn(outcome, "R1.F8").back(), -2);
}

}  // namespace
}  // namespace jprim
