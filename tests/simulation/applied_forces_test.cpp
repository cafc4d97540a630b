// SPDX-License-Identifier: Apache-2.0
// SFORCE, VFORCE, VTORQUE and GFORCE, and what their functions are made of: VARVAL and splines.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "support/dataset_units.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::Rotation;
using SimTK::Vec3;
using testing::buildOrFail;
using testing::DatasetUnits;
using testing::MetreSecond;

// The integrator's accuracy of 1e-10 over smooth motions of order one.
constexpr double Tolerance = 1e-8;

class AppliedForces : public testing::InBothUnits {};
JPRIM_INSTANTIATE_IN_BOTH_UNITS(AppliedForces);

Results runFor(const std::string& text, const DatasetUnits& u, double seconds, int steps = 10) {
    return testing::run(buildOrFail(text + "END\n"), seconds * u.s, steps, 1e-10).results;
}

Vec3 getLast(const Table& table, const std::string& prefix, const char* x, const char* y, const char* z) {
    return {table.getColumn(prefix + x).back(), table.getColumn(prefix + y).back(),
            table.getColumn(prefix + z).back()};
}

// Rz(a) Rx(b) Rz(c)
Rotation makeRotation(double a, double b, double c) {
    const Rotation R(SimTK::BodyRotationSequence, a, SimTK::ZAxis, b, SimTK::XAxis);
    return R * Rotation(c, SimTK::ZAxis);
}

// Two free bodies, PART/2 with marker 20 at its mass centre and PART/3 with 30, and a tilted marker 10 on ground.
std::string makeBodies(const DatasetUnits& u) {
    return fmt::format(
        "bodies\n{0}PART/1,GROUND\nMARKER/10,REULER=0.3,0.4,0.5\n"
        "PART/2,MASS=2,CM=20,IP={1},{1},{1}\nMARKER/20\nMARKER/21,QP={2},0,0\nMARKER/22,FLOATING\n"
        "PART/3,MASS=3,CM=30,IP={3},{3},{3},QG={4},{5},0\nMARKER/30\nMARKER/31,FLOATING\n",
        u.statement, 0.5 * u.m * u.m, 0.3 * u.m, 0.8 * u.m * u.m, 0.7 * u.m, -0.4 * u.m);
}

//---------------------------------------------------------------------------------------------- SFORCE
// Towards z of a marker on ground, growing with time: v = F t^2/(2 m), x = F t^3/(6 m).
TEST_P(AppliedForces, AnActionOnlyForcePointsAlongZOfJ) {
    const std::string text =
        makeBodies(u) + fmt::format("SFORCE/1,TRANSLATIONAL,ACTIONONLY,I=20,J=10,FUNCTION=5*TIME/{}\n", u.s);
    const Table p = runFor(text, u, 2).parts;
    const Vec3 z = makeRotation(0.3, 0.4, 0.5) * Vec3(0, 0, 1);
    EXPECT_LT((getLast(p, "PART/2.", "X", "Y", "Z") / u.m - 5 * 8. / 12 * z).norm(), Tolerance);
    EXPECT_LT((getLast(p, "PART/2.", "VX", "VY", "VZ") * u.s / u.m - 5 * 4. / 4 * z).norm(), Tolerance);
    EXPECT_LT(getLast(p, "PART/3.", "VX", "VY", "VZ").norm(), Tolerance);
}

// Positive pushes the markers apart; marker 20 and 30 are in line with nothing else.
TEST_P(AppliedForces, AForceBetweenMarkersPushesThemApart) {
    const std::string text = makeBodies(u) + "SFORCE/1,TRANSLATIONAL,I=20,J=30,FUNCTION=6\n";
    const Table p = runFor(text, u, 1).parts;
    const Vec3 apart = Vec3(-0.7, 0.4, 0) / std::hypot(0.7, 0.4);
    EXPECT_LT((getLast(p, "PART/2.", "VX", "VY", "VZ") * u.s / u.m - 3 * apart).norm(), Tolerance);
    EXPECT_LT((getLast(p, "PART/3.", "VX", "VY", "VZ") * u.s / u.m + 2 * apart).norm(), Tolerance);
}

TEST_P(AppliedForces, ATorqueTurnsIAboutZOfJAndJBack) {
    const std::string text =
        makeBodies(u) + fmt::format("SFORCE/1,ROTATIONAL,I=20,J=30,FUNCTION={}\n", 4 * u.m);
    const Table p = runFor(text, u, 1).parts;
    EXPECT_LT((getLast(p, "PART/2.", "WX", "WY", "WZ") * u.s - Vec3(0, 0, 4 / 0.5)).norm(), Tolerance);
    EXPECT_LT((getLast(p, "PART/3.", "WX", "WY", "WZ") * u.s + Vec3(0, 0, 4 / 0.8)).norm(), Tolerance);
}

//-------------------------------------------------------------------------------- forces by components
// The opposite force acts on PART/3 at the place of marker 21: both momenta are kept, and there is a lever.
TEST_P(AppliedForces, AVforceReactsWhereIIs) {
    const std::string text =
        makeBodies(u) +
        fmt::format("VFORCE/1,I=21,JFLOAT=31,RM=10,FX=2\\FY=3*COS(TIME/{})\\\n,FZ=-1\n", u.s) +
        "REQUEST/1,F2=VFORCE(1,0,2,10)\\F3=VFORCE(1,0,3,10)\\F4=VFORCE(1,0,4,10)\\F6=VFORCE(1,1,2,10)"
        "\\F7=FX(21,31,10)\\F8=FM(31,21)\n";
    const Results results = runFor(text, u, 1.5);
    const Table& p = results.parts;
    const Vec3 impulse = makeRotation(0.3, 0.4, 0.5) * Vec3(2 * 1.5, 3 * std::sin(1.5), -1.5);
    const Vec3 v2 = getLast(p, "PART/2.", "VX", "VY", "VZ") * u.s / u.m;
    const Vec3 v3 = getLast(p, "PART/3.", "VX", "VY", "VZ") * u.s / u.m;
    EXPECT_LT((2 * v2 - impulse).norm(), Tolerance);
    EXPECT_LT((3 * v3 + impulse).norm(), Tolerance);
    const Vec3 w2 = getLast(p, "PART/2.", "WX", "WY", "WZ") * u.s,
               w3 = getLast(p, "PART/3.", "WX", "WY", "WZ") * u.s;
    const Vec3 x2 = getLast(p, "PART/2.", "X", "Y", "Z") / u.m,
               x3 = getLast(p, "PART/3.", "X", "Y", "Z") / u.m;
    EXPECT_LT((2 * x2 % v2 + 0.5 * w2 + 3 * x3 % v3 + 0.8 * w3).norm(), Tolerance);
    EXPECT_GT(w3.norm(), 0.5);

    const Table& r = results.requests;
    EXPECT_NEAR(r.getColumn("R1.F2").back(), 2, Tolerance);
    EXPECT_NEAR(r.getColumn("R1.F3").back(), 3 * std::cos(1.5), Tolerance);
    EXPECT_NEAR(r.getColumn("R1.F4").back(), -1, Tolerance);
    EXPECT_NEAR(r.getColumn("R1.F6").back(), -2, Tolerance);
    EXPECT_NEAR(r.getColumn("R1.F7").back(), 2, Tolerance);
    EXPECT_NEAR(r.getColumn("R1.F8").back(), std::hypot(2, 1, 3 * std::cos(1.5)), Tolerance);
}

TEST_P(AppliedForces, AVtorqueAddsNoForce) {
    const std::string text =
        makeBodies(u) +
        fmt::format("VTORQUE/1,I=21,JFLOAT=31,RM=10,TX={}\\TZ={}\nREQUEST/1,F2=VTORQ(1,1,6,10)\n", 2 * u.m,
                    -1 * u.m);
    const Results results = runFor(text, u, 1.5);
    const Vec3 impulse = makeRotation(0.3, 0.4, 0.5) * Vec3(3, 0, -1.5);
    EXPECT_LT((getLast(results.parts, "PART/2.", "WX", "WY", "WZ") * u.s - impulse / 0.5).norm(), Tolerance);
    EXPECT_LT((getLast(results.parts, "PART/3.", "WX", "WY", "WZ") * u.s + impulse / 0.8).norm(), Tolerance);
    EXPECT_LT(getLast(results.parts, "PART/2.", "VX", "VY", "VZ").norm(), Tolerance);
    EXPECT_NEAR(results.requests.getColumn("R1.F2").back(), -2 * u.m, Tolerance * u.m);
}

// One law in three wordings: vectors, components, and a BUSHING, which has the same stiffness in all directions and
// so pulls along the line.
std::string makeBound(const DatasetUnits& u, int wording) {
    const double k = 30 / u.m, c = 2 * u.s / u.m, ct = 0.4 * u.m * u.s;
    switch (wording) {
        case 0:
            return fmt::format(
                "GFORCE/1,I=21,JFLOAT=31,RM=30,FXYZ=-{}*DXYZ(21,30,30)-{}*VXYZ(21,30,30,30)\\\n"
                ",TXYZ=-{}*WXYZ(21,30,30)\n",
                k, c, ct);
        case 1:
            return fmt::format(
                "GFORCE/1,I=21,JFLOAT=31,RM=30,FX=-{0}*DX(21,30,30)-{1}*VX(21,30,30,30)\\"
                "FY=-{0}*DY(21,30,30)-{1}*VY(21,30,30,30)\\FZ=-{0}*DZ(21,30,30)\n"
                ",-{1}*VZ(21,30,30,30)\\TX=-{2}*WX(21,30,30)\\TY=-{2}*WY(21,30,30)\\TZ=-{2}*WZ(21,30,30)\n",
                k, c, ct);
        default:
            return fmt::format("BUSHING/1,I=21,J=30,K={0},{0},{0},C={1},{1},{1},CT={2},{2},{2}\n", k, c, ct);
    }
}

TEST_P(AppliedForces, VectorsAndComponentsAndABushingAgree) {
    const std::string start = makeBodies(u) + "SFORCE/9,TRANSLATIONAL,ACTIONONLY,I=20,J=10,FUNCTION=3\n";
    const Table first = runFor(start + makeBound(u, 0), u, 2).parts;
    for (int wording = 1; wording < 3; ++wording) {
        const Table other = runFor(start + makeBound(u, wording), u, 2).parts;
        for (const char* name : {"PART/2.X", "PART/2.WY", "PART/3.Y", "PART/3.E2", "PART/3.VZ"})
            EXPECT_NEAR(first.getColumn(name).back(), other.getColumn(name).back(), Tolerance * u.m)
                << wording << name;
    }
    EXPECT_GT(std::abs(first.getColumn("PART/3.E2").back()), 0.01);
}

TEST(AppliedForcesMutated, ASlightlyWeakerBushingIsNoticed) {
    std::string text = makeBound(MetreSecond, 2);
    text.replace(text.find("K=30"), 4, "K=29.99");
    const Table a = runFor(makeBodies(MetreSecond) + makeBound(MetreSecond, 0), MetreSecond, 2).parts;
    const Table b = runFor(makeBodies(MetreSecond) + text, MetreSecond, 2).parts;
    EXPECT_GT(std::abs(a.getColumn("PART/3.Y").back() - b.getColumn("PART/3.Y").back()), 100 * Tolerance);
}

//------------------------------------------------------------------------------------ VARVAL, splines
// x" = -k x/m through a chain of variables, declared in any order and named twice.
TEST_P(AppliedForces, VariablesStandForTheirFunctions) {
    const std::string text =
        makeBodies(u) + fmt::format(
                            "VARIABLE/3,FUNCTION=VARVAL(2)+VARVAL(1)\nVARIABLE/1,FUNCTION=-{}*DX(20)\n"
                            "VARIABLE/2,FUNCTION=2*VARVAL(1)\n"
                            "GFORCE/1,I=20,JFLOAT=31,FX=VARVAL(3)+1\nREQUEST/1,F2=VARVAL(3)/VARVAL(1)\n",
                            4 / u.m);
    const Results results = runFor(text, u, 1);
    // PART/3 moves away meanwhile; DX is against ground.
    EXPECT_NEAR(results.parts.getColumn("PART/2.X").back() / u.m, (1 - std::cos(std::sqrt(6))) / 12,
                Tolerance);
    EXPECT_NEAR(results.requests.getColumn("R1.F2").back(), 3, 1e-12);
}

// Outside of its domain a function is no number, and that is said at once.
TEST(AppliedForces, AForceThatIsNoNumberIsAFailure) {
    const Mechanism mechanism =
        buildOrFail(makeBodies(MetreSecond) + "GFORCE/1,I=20,JFLOAT=31,FX=SQRT(DZ(20)-1)\nEND\n");
    SimulationOptions options;
    options.end = 1;
    EXPECT_EQ(
        simulate(mechanism, assemble(mechanism), options).failure,
        "at time 0: the simulation cannot go on: GFORCE/1: its function is infinite or not a number here, as a "
        "quotient by zero or a root of a negative number are");
}

// Akima's curve through points of a parabola is that parabola, also with unequal tables of x: a spring that
// stiffens, against the same law as a formula.
std::string makeStiffening(const DatasetUnits& u, const std::string& force) {
    std::string x, y;
    for (int k = -3; k <= 5; ++k) {
        x += fmt::format(",{}", 0.5 * k * u.m);
        y += fmt::format(",{}", -3 * 0.5 * k - 2 * 0.25 * k * k);
    }
    return makeBodies(u) + "SPLINE/7,X=" + x.substr(1) + "\n,Y=" + y.substr(1) +
           fmt::format("\nSPLINE/8,X=-1,0,2,3,LINEAR_EXTRAPOLATE,Y={},0,{},{}\n", -1, 2, 3) +
           "GFORCE/1,I=20,JFLOAT=31,FX=2+" + force + "\n";
}

TEST_P(AppliedForces, ASplineIsTheParabolaThatItSamples) {
    const std::string formula = fmt::format("(-3*DX(20)/{0}-2*(DX(20)/{0})**2)", u.m);
    const double exact = runFor(makeStiffening(u, formula), u, 2).parts.getColumn("PART/2.X").back();
    const Table p = runFor(makeStiffening(u, "AKISPL(DX(20),0,7)"), u, 2).parts;
    EXPECT_NEAR(p.getColumn("PART/2.X").back(), exact, 1e-7 * u.m);
    EXPECT_GT(exact, 0.1 * u.m);
}

// A natural spline bends at its ends unless what it samples is straight there.
TEST_P(AppliedForces, ACubicSplineIsTheStraightLineThatItSamples) {
    const std::string formula = fmt::format("(1*(DX(20)/{}))", u.m);
    const double exact = runFor(makeStiffening(u, formula), u, 3).parts.getColumn("PART/2.X").back();
    const std::string spline = fmt::format("CUBSPL(DX(20)/{},0,8)", u.m);
    EXPECT_NEAR(runFor(makeStiffening(u, spline), u, 3).parts.getColumn("PART/2.X").back(), exact,
                1e-7 * u.m);
    EXPECT_GT(exact, 3 * u.m);  // beyond the last point, where it goes on straight
}

// A family of straight lines y = z x, and a spline's derivatives.
TEST_P(AppliedForces, AFamilyOfSplinesIsLinearInBoth) {
    const std::string text =
        makeBodies(u) + "SPLINE/7,X=0,1,2,4,Y=1,0,1,2,4,Y=3,0,3,6,12\n" +
        fmt::format(
            "REQUEST/1,F2=AKISPL(3.3,1+TIME/{0},7)\\F3=CUBSPL(3.3,1+TIME/{0},7)\\F4=CUBSPL(5,2.5,7,1)\\",
            u.s) +
        "F6=AKISPL(3,9,7)\\F7=AKISPL(3.3,2,7,2)\n";
    const Table r = runFor(text, u, 0.7, 1).requests;
    EXPECT_NEAR(r.getColumn("R1.F2").back(), 1.7 * 3.3, 1e-12);
    EXPECT_NEAR(r.getColumn("R1.F3").back(), 1.7 * 3.3, 1e-12);
    EXPECT_NEAR(r.getColumn("R1.F4").back(), 2.5, 1e-12);
    EXPECT_NEAR(r.getColumn("R1.F6").back(), 9, 1e-12);
    EXPECT_NEAR(r.getColumn("R1.F7").back(), 0, 1e-12);
}

// Travel a t^2/2 from a table of time: its derivative, of first order, is the velocity.
TEST_P(AppliedForces, AMotionFollowsASplineOfTime) {
    std::string x, y;
    for (int k = 0; k <= 6; ++k) {
        x += fmt::format(",{}", 0.5 * k * u.s);
        y += fmt::format(",{}", 0.7 * 0.25 * k * k * u.m);
    }
    const std::string text =
        makeBodies(u) + "SPLINE/7,X=" + x.substr(1) + "\n,Y=" + y.substr(1) +
        "\nMARKER/11,PART=1\nJOINT/1,TRANSLATIONAL,I=20,J=11\nMOTION/1,JOINT=1,FUNCTION=AKISPL(TIME,0,7)\n"
        "REQUEST/1,F2=DZ(20)\\F3=VZ(20)-AKISPL(TIME,0,7,1)\\F4=MOTION(1,0,4)\n";
    const Table r = runFor(text, u, 2.2).requests;
    EXPECT_NEAR(r.getColumn("R1.F2").back() / u.m, 0.7 * 2.2 * 2.2, 1e-7);
    EXPECT_NEAR(r.getColumn("R1.F3").back() * u.s / u.m, 0, 1e-7);
    EXPECT_NEAR(r.getColumn("R1.F4").back(), 2 * 1.4, 1e-6);
}

}  // namespace
}  // namespace jprim
