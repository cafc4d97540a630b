// SPDX-License-Identifier: Apache-2.0
// Functions of REQUESTs: loads of elements by each of their names, net loads, Euler parameters.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "support/dataset_units.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::Vec3;
using testing::buildOrFail;
using testing::DatasetUnits;

class FunctionRequests : public testing::InBothUnits {};
JPRIM_INSTANTIATE_IN_BOTH_UNITS(FunctionRequests);

// Rounding of loads of up to about 100 N and N m.
constexpr double Tolerance = 1e-9;

/// An element between markers 21 and 31, and the name of its function.
struct Element {
    const char* function;
    std::string statement;
    bool isFloating = false;  ///< it reacts on 32
};

std::vector<Element> getElements(const DatasetUnits& u) {
    return {{"JPRIM", "JPRIM/7,ATPOINT,I=21,J=31"},
            {"JPRIM", "JPRIM/7,INPLANE,I=21,J=31"},
            {"JOINT", "JOINT/7,FIXED,I=21,J=31"},
            {"JOINT", "JOINT/7,CONVEL,I=21,J=31"},
            {"JOINT", fmt::format("JOINT/7,SCREW,PITCH={},I=21,J=31", 0.3 * u.m)},
            {"GCON", fmt::format("GCON/7,I=21,FUNCTION=DM(21,31)-{}", 0.5 * u.m)},
            {"MOTION", "MOTION/7,I=21,J=31,B2,FUNCTION=0.1"},
            {"MOTION", fmt::format("MOTION/7,I=21,J=31,VELOCITY,X,FUNCTION={}", 0.3 * u.m / u.s)},
            {"SFORCE", "SFORCE/7,TRANSLATIONAL,I=21,J=31,FUNCTION=3"},
            {"SFORCE", fmt::format("SFORCE/7,ROTATIONAL,I=21,J=31,FUNCTION={}", 2 * u.m)},
            {"SPDP", fmt::format("SPRINGDAMPER/7,TRANSLATIONAL,I=21,J=31,K={},FORCE=9", 20 / u.m)},
            {"BUSH", fmt::format("BUSHING/7,I=21,J=31,K={0},{0},0,KT={1},0,{1}", 20 / u.m, 4 * u.m)},
            {"GFORCE", fmt::format("GFORCE/7,I=21,JFLOAT=32,RM=31,FXYZ=[1,2,3]\\TY={}", 3 * u.m), true},
            {"VFORCE", "VFORCE/7,I=21,JFLOAT=32,FX=1\\FZ=-4", true},
            {"VTORQ", fmt::format("VTORQUE/7,I=21,JFLOAT=32,TXYZ={}*[1,-2,3]", u.m), true}};
}

// Two bodies that fall, spin and are bound to nothing else. F2 … F8 are the components 2 … 4 and 6 … 8.
std::string makeBodies(const DatasetUnits& u, const Element& element) {
    const auto list = [&](int request, const std::string& function, const std::string& end) {
        std::string text = fmt::format("REQUEST/{}", request), separator = ",";
        for (const int k : {2, 3, 4, 6, 7, 8}) {
            text += fmt::format("{}F{}={}{}{}", separator, k, function, k, end);
            separator = "\\";
        }
        return text + "\n";
    };
    const std::string name = std::string(element.function) + "(7,";
    const bool isVelocity = element.statement.find("VELOCITY") != std::string::npos;
    return fmt::format(
               "bodies\n{0}ACCGRAV/KGRAV={1}\nPART/1,GROUND\nMARKER/10,REULER=0.3,0.2,0.4\n"
               "PART/2,MASS=2,CM=20,IP={2},{3},{4},WX={5},WZ={6}\nMARKER/20\nMARKER/21,QP={7},0,{8},REULER=0.1,0.2,0\n",
               u.statement, -9.8 * u.m / u.s / u.s, 0.2 * u.m * u.m, 0.3 * u.m * u.m, 0.4 * u.m * u.m,
               2 / u.s, -1 / u.s, 0.4 * u.m, 0.1 * u.m) +
           fmt::format(
               "PART/3,MASS=3,CM=30,IP={0},{0},{1},QG={2},{3},0,WY={4}\nMARKER/30\nMARKER/31,QP={3},0,0\n"
               "MARKER/32,FLOATING\n{5}\nSFORCE/9,TRANSLATIONAL,ACTIONONLY,I=20,J=10,FUNCTION=5\n",
               0.3 * u.m * u.m, 0.2 * u.m * u.m, 0.7 * u.m, 0.2 * u.m, (isVelocity ? 0 : 1.5) / u.s,
               element.statement) +
           list(1, name + "0,", ",10)") + list(2, name + "1,", ",10)") + list(3, name + "0,", ")") +
           "REQUEST/4,F2=" + name + "0,1)\\F3=" + name + "1,5,10)\n" +
           (element.isFloating
                ? "REQUEST/5,F2=FX(21,32,10)\\F3=FY(21,32,10)\\F4=FZ(21,32,10)\\F6=TX(21,32,10)"
                  "\\F7=TY(21,32,10)\\F8=TZ(21,32,10)\n"
                : "REQUEST/5,F2=FX(21,31,10)\\F3=FY(21,31,10)\\F4=FZ(21,31,10)\\F6=TX(21,31,10)"
                  "\\F7=TY(21,31,10)\\F8=TZ(21,31,10)\n") +
           "REQUEST/6,F2=DX(21,31,10)\\F3=DY(21,31,10)\\F4=DZ(21,31,10)\nREQUEST/7,F2=SFORCE(9,0,4,10)\\F3=FM(20)\n" +
           "REQUEST/8,F2=2*ACCX(20)\\F3=2*ACCY(20)\\F4=2*ACCZ(20)\n" +
           fmt::format("REQUEST/9,F2=UVZ(10)*[5,0,0]\\F3=UVZ(10)*[0,5,0]\\F4=UVZ(10)*[0,0,5]-{}\nEND\n",
                       2 * 9.8);
}

// PART/2's equation of motion in ground: m a = load of the element + SFORCE/9 + weight.
void checkNewton(const Table& r, const DatasetUnits& u) {
    for (const char* column : {"F2", "F3", "F4"}) {
        const auto at = [&](const char* request) { return r.getColumn(request + std::string(column))[0]; };
        EXPECT_NEAR(at("R8.") * u.s * u.s / u.m, at("R3.") + at("R9."), 1e-7);
    }
}

TEST_P(FunctionRequests, GiveTheLoadOfEveryElement) {
    for (const Element& element : getElements(u)) {
        SCOPED_TRACE(element.statement);
        const Table r =
            testing::run(buildOrFail(makeBodies(u, element)), 0.02 * u.s, 1, 1e-8).results.requests;
        const auto get = [&r](int request, int first) {
            const auto at = [&](int k) { return r.getColumn(fmt::format("R{}.F{}", request, first + k))[0]; };
            return Vec3(at(0), at(1), at(2));
        };
        const Vec3 F = get(1, 2), T = get(1, 6);
        const Vec3 lever = element.isFloating ? Vec3(0) : get(6, 2);  // a floating marker is where I is
        EXPECT_GT(F.norm() + T.norm() / u.m, 0.05);
        EXPECT_LT((get(2, 2) + F).norm(), Tolerance);  // on J
        EXPECT_LT((get(2, 6) + T + lever % F).norm(), Tolerance * u.m);
        EXPECT_NEAR(get(3, 2).norm(), F.norm(), Tolerance);  // in ground
        EXPECT_NEAR(r.getColumn("R4.F2")[0], F.norm(), Tolerance);
        EXPECT_NEAR(r.getColumn("R4.F3")[0], get(2, 6).norm(), Tolerance * u.m);
        EXPECT_LT((get(5, 2) - F).norm(), Tolerance);  // all between the markers
        EXPECT_LT((get(5, 6) - T).norm(), Tolerance * u.m);
        EXPECT_NEAR(r.getColumn("R7.F2")[0], 5, Tolerance);
        EXPECT_NEAR(r.getColumn("R7.F3")[0], 5, Tolerance);
        checkNewton(r, u);
    }
}

// Between two markers everything counts that acts there, and on one marker alone what has no other.
TEST_P(FunctionRequests, NetLoadsAddUp) {
    const Element element = {"SFORCE",
                             "SFORCE/7,TRANSLATIONAL,I=21,J=31,FUNCTION=3\n"
                             "SFORCE/8,TRANSLATIONAL,I=31,J=21,FUNCTION=4"};
    const Table r = testing::run(buildOrFail(makeBodies(u, element)), 0.02 * u.s, 1, 1e-8).results.requests;
    EXPECT_NEAR(r.getColumn("R4.F2")[0], 3, Tolerance);
    EXPECT_NEAR(r.getColumn("R5.F2")[0], 7. / 3 * r.getColumn("R1.F2")[0], Tolerance);
    EXPECT_GT(std::abs(r.getColumn("R1.F2")[0]), 0.1);
}

// Up to their common sign, which nothing determines, the same as those of the part.
TEST_P(FunctionRequests, EulerParametersAreThoseOfTheMarkers) {
    std::string text = makeBodies(u, {"SFORCE", "SFORCE/7,TRANSLATIONAL,I=21,J=31,FUNCTION=3"});
    text.replace(text.find("END\n"), 4,
                 "REQUEST/11,F2=ORIENT(27,1,20)\\F3=ORIENT(27,2,20)\\F4=ORIENT(27,3,20)\\F5=ORIENT(27,4,20)\n"
                 "REQUEST/12,F2=ORIENT(27,1,20,10)\\F3=2*ORIENT(27,2,20,10)*ORIENT(27,4,20,10)"
                 "+2*ORIENT(27,1,20,10)*ORIENT(27,3,20,10)\\F4=UVZ(20)*UVX(10)\nEND\n");
    const Results results = testing::run(buildOrFail(text), 0.8 * u.s, 4, 1e-8).results;
    for (size_t row = 0; row < 5; ++row) {
        SimTK::Vec4 ofMarker, ofPart;
        for (int k = 0; k < 4; ++k) {
            ofMarker[k] = results.requests.getColumn(fmt::format("R11.F{}", k + 2))[row];
            ofPart[k] = results.parts.getColumn(fmt::format("PART/2.E{}", k))[row];
        }
        EXPECT_NEAR(std::abs(SimTK::dot(ofMarker, ofPart)), 1, Tolerance);
        // 2 (e1 e3 + e0 e2) is the element of the rotation that says where z points along x.
        EXPECT_NEAR(results.requests.getColumn("R12.F3")[row], results.requests.getColumn("R12.F4")[row],
                    Tolerance);
    }
    EXPECT_GT(std::abs(results.requests.getColumn("R12.F4").back()), 0.1);
}

}  // namespace
}  // namespace jprim
