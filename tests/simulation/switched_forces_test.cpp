// SPDX-License-Identifier: Apache-2.0
// Forces that a command file switches off and on: a free body gains speed only while its load is on.
#include <gtest/gtest.h>

#include "jprim/dataset/commands.h"
#include "jprim/simulation/run_commands.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

constexpr double Mass = 2, Moment = 0.5, Load = 3, Exact = 1e-9;

struct Case {
    const char* name;       // of the kind of statement
    const char* statement;  // a load of 3 on PART/2 along or about x
    bool turns = false;
};

std::string write(const Case& c) {
    return "switched\nPART/1,GROUND\nMARKER/10,REULER=90D,90D,0\nMARKER/11,QP=-1,0,0\nMARKER/12,FLOATING\n"
           "PART/2,MASS=2,CM=20,IP=0.5,0.5,0.5\nMARKER/20\n" +
           std::string(c.statement) + "\nEND\n";
}

CommandsOutcome run(const Mechanism& mechanism, const std::string& commands) {
    Diagnostics diagnostics;
    const CommandFile file = readCommands("model\n\n" + commands, diagnostics);
    EXPECT_EQ(testing::formatAll(diagnostics), "");
    SimulationOptions options;
    options.accuracy = 1e-10;
    return runCommands(mechanism, file.commands, options);
}

class SwitchedForces : public ::testing::TestWithParam<Case> {};

TEST_P(SwitchedForces, LoadOnlyWhileTheyAreOn) {
    const Case& c = GetParam();
    const Mechanism mechanism = testing::buildOrFail(write(c));
    const std::string element = std::string(c.name) + ", ID=7\n";
    const CommandsOutcome outcome =
        run(mechanism, "SIMULATE/DYNAMICS, END=0.4, STEPS=1\nDEACTIVATE/" + element +
                           "SIMULATE/DYNAMICS, END=1, STEPS=1\nACTIVATE/" + element +
                           "SIMULATE/DYNAMICS, END=1.3, STEPS=1\n");
    EXPECT_EQ(outcome.failure, "");
    const std::vector<double> speed = outcome.results.parts.getColumn(c.turns ? "PART/2.WX" : "PART/2.VX");
    const double a = Load / (c.turns ? Moment : Mass);
    ASSERT_EQ(speed.size(), 6u);  // the moments of switching twice
    EXPECT_NEAR(speed[1], a * 0.4, Exact);
    EXPECT_NEAR(speed[3], a * 0.4, Exact);
    EXPECT_NEAR(speed[5], a * 0.7, Exact);
}

TEST_P(SwitchedForces, AreSilentInRequestsWhileTheyAreOff) {
    const Mechanism mechanism = testing::buildOrFail(write(GetParam()));
    const Element& force = mechanism.getElements()[0];
    SimTK::State state = mechanism.makeGivenState();
    mechanism.getSystem().realize(state, SimTK::Stage::Acceleration);
    EXPECT_NEAR(force.onI(state).norm(), Load, Exact);
    force.disable(state);
    mechanism.getSystem().realize(state, SimTK::Stage::Acceleration);
    EXPECT_TRUE(force.isDisabled(state));
    EXPECT_EQ(force.onI(state).norm(), 0);
    EXPECT_EQ(force.onJ(state).norm(), 0);
    EXPECT_EQ(mechanism.getSystem().calcPotentialEnergy(state), 0);
    force.enable(state);
    mechanism.getSystem().realize(state, SimTK::Stage::Acceleration);
    EXPECT_NEAR(force.onI(state).norm(), Load, Exact);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, SwitchedForces,
    ::testing::Values(Case{"SFORCE", "SFORCE/7,TRANSLATIONAL,I=20,J=11,FUNCTION=3"},
                      Case{"VFORCE", "VFORCE/7,I=20,JFLOAT=12,RM=11,FX=3\\FY=0\\FZ=0"},
                      Case{"VTORQUE", "VTORQUE/7,I=20,JFLOAT=12,RM=11,TX=3\\TY=0\\TZ=0", true},
                      Case{"GFORCE", "GFORCE/7,I=20,JFLOAT=12,RM=10,FX=0\\FY=0\\FZ=3\\TX=0\\TY=0\\TZ=0"},
                      Case{"SPRINGDAMPER", "SPRINGDAMPER/7,TRANSLATIONAL,I=20,J=11,K=0,C=0,FORCE=3"},
                      Case{"BUSHING", "BUSHING/7,I=20,J=11,K=0,0,0,C=0,0,0,KT=0,0,0,CT=0,0,0,FORCE=3,0,0"}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace jprim
