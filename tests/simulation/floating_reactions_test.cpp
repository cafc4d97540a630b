// SPDX-License-Identifier: Apache-2.0
// Forces with a floating marker: the load on I, and the opposite one on the part of JFLOAT at the place of I.
#include <gtest/gtest.h>

#include "base/format.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::SpatialVec;
using SimTK::Stage;
using SimTK::State;
using SimTK::Vec3;

constexpr double Rounding = 1e-12;
const Vec3 F(2, -3, 0.7), T(-0.4, 1.1, 0.6);  // along the axes of marker 10

struct Case {
    const char* name;
    const char* keyword;
    bool hasForce, hasTorque;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.name;
}

std::string write(const Case& c, int jfloat) {
    std::string text = fmt::format("{}/1,I=21,JFLOAT={},RM=10", c.keyword, jfloat);
    if (c.hasForce) text += fmt::format(",FX={}\\FY={}\\FZ={}", F[0], F[1], F[2]);
    if (c.hasTorque) text += fmt::format("{}TX={}\\TY={}\\TZ={}", c.hasForce ? "\\" : ",", T[0], T[1], T[2]);
    return text + "\n";
}

Mechanism build(const std::string& force) {
    return testing::buildOrFail(
        "floating\nPART/1,GROUND\nMARKER/10,REULER=0.3,0.4,0.5\nMARKER/11,FLOATING\n"
        "PART/2,MASS=2,CM=20,IP=0.5,0.4,0.3,QG=0.3,0.2,0.9,WX=1,VY=2\nMARKER/20\nMARKER/21,QP=0.5,-0.1,0.2,REULER=1,2,3\n"
        "PART/3,MASS=3,CM=30,IP=0.8,0.6,0.7,QG=0.7,-0.4,0.1,WZ=-1\nMARKER/30\nMARKER/31,FLOATING\n" +
        force + "END\n");
}

/// What acts on each part, in Ground about Ground's origin.
std::vector<SpatialVec> calcLoads(const Mechanism& mechanism, State& state) {
    mechanism.getSystem().realize(state, Stage::Dynamics);
    const auto& forces = mechanism.getSystem().getRigidBodyForces(state, Stage::Dynamics);
    std::vector<SpatialVec> loads;
    for (const MechanismPart& part : mechanism.getParts()) {
        const Vec3 origin = part.body.getBodyOriginLocation(state);
        loads.push_back(SimTK::shiftForceBy(forces[part.body.getMobilizedBodyIndex()], -origin));
    }
    return loads;
}

/// The distance from the loads that are due: on I, on the part of JFLOAT `counter` times that, on others none.
double calcDefect(const Case& c, int jfloat, double sign, double counter) {
    const Mechanism mechanism = build(write(c, jfloat));
    EXPECT_EQ(mechanism.getLengthUnit(), 1);
    State state = assemble(mechanism).state;
    const std::vector<SpatialVec> loads = calcLoads(mechanism, state);
    const SimTK::Rotation& R = mechanism.getMarker(10).getPose().R();
    const Vec3 place = mechanism.getMarker(21).findPoseInGround(state).p();
    const SpatialVec onI(c.hasTorque ? R * T : Vec3(0), c.hasForce ? R * F : Vec3(0));
    const SpatialVec due = sign * SimTK::shiftForceBy(onI, -place);
    const size_t floating = jfloat == 11 ? 0 : 2, other = 2 - floating;
    return (loads[1] - due).norm() + (loads[floating] - counter * due).norm() + loads[other].norm();
}

class FloatingReactions : public ::testing::TestWithParam<std::tuple<Case, int>> {};

TEST_P(FloatingReactions, AreTheOppositeLoadAtThePlaceOfI) {
    const auto& [c, jfloat] = GetParam();
    EXPECT_LT(calcDefect(c, jfloat, 1, -1), Rounding);
    EXPECT_GT(calcDefect(c, jfloat, 1, 1), 1);    // a counter-load of the wrong sign,
    EXPECT_GT(calcDefect(c, jfloat, 1, 0), 1);    // none,
    EXPECT_GT(calcDefect(c, jfloat, -1, -1), 1);  // and a load of the wrong sign are noticed
}

// What is reported on JFLOAT has no lever, as it is where I is.
TEST_P(FloatingReactions, AreReportedWithoutALever) {
    const auto& [c, jfloat] = GetParam();
    const Mechanism mechanism = build(write(c, jfloat));
    State state = assemble(mechanism).state;
    mechanism.getSystem().realize(state, Stage::Acceleration);
    const ElementList& elements = mechanism.getElements();
    const Element& element = elements[elements.size() - 1];
    EXPECT_GT(element.onI(state).norm(), 1);
    EXPECT_LT((element.onI(state) + element.onJ(state)).norm(), Rounding);
}

INSTANTIATE_TEST_SUITE_P(Forces, FloatingReactions,
                         ::testing::Combine(::testing::Values(Case{"Vforce", "VFORCE", true, false},
                                                              Case{"Vtorque", "VTORQUE", false, true},
                                                              Case{"Gforce", "GFORCE", true, true}),
                                            ::testing::Values(11, 31)),
                         [](const auto& info) {
                             return std::get<0>(info.param).name +
                                    std::string(std::get<1>(info.param) == 11 ? "OnGround" : "OnAPart");
                         });

}  // namespace
}  // namespace jprim
