// SPDX-License-Identifier: Apache-2.0
// Whether a mechanism is known to keep its energy, statement by statement: what decides if a change is a warning.
#include <gtest/gtest.h>

#include "support/run_dataset.h"

namespace jprim {
namespace {

struct Case {
    const char* statement;
    bool isConservative;
};

class Conservation : public ::testing::TestWithParam<Case> {};

TEST_P(Conservation, IsKnown) {
    const std::string text =
        "t\nPART/1,GROUND\nMARKER/10\nMARKER/11,REULER=0,90D,0\nPART/2,MASS=2,CM=20,IP=1,1,1\nMARKER/20\nMARKER/21,QP=0.5,0,0\n"
        "PART/3,MASS=2,CM=30,IP=1,1,1,QG=1,0,0\nMARKER/30\nMARKER/31,FLOATING\nACCGRAV/KGRAV=-9.8\n"
        "JOINT/1,REVOLUTE,I=20,J=10\nJOINT/2,CYLINDRICAL,I=30,J=10\n";
    EXPECT_EQ(testing::buildOrFail(text + GetParam().statement + "\nEND\n").isConservative(),
              GetParam().isConservative)
        << GetParam().statement;
}

INSTANTIATE_TEST_SUITE_P(
    Statements, Conservation,
    ::testing::Values(
        // Constraints without time.
        Case{"JOINT/3,SCREW,PITCH=0.1,I=30,J=10", true}, Case{"JOINT/3,RACKPIN,PD=0.1,I=20,J=11", true},
        Case{"COUPLER/1,JOINTS=1,2,TYPE=R:R,SCALES=1,2", true}, Case{"GCON/1,FUNCTION=DM(21,30)-0.5", true},
        // Velocities: no work if rest is allowed, wherever the mechanism stands.
        Case{"GCON/1,FUNCTION=VX(30)-0.2*WY(30)+VY(30)*DX(30)", true},
        Case{"GCON/1,FUNCTION=VR(30,10)", true}, Case{"GCON/1,FUNCTION=WX(20)-2.5*DTOR", false},
        Case{"GCON/1,FUNCTION=VX(30)-DZ(30)", false},
        // Whatever follows time.
        Case{"GCON/1,FUNCTION=DM(21,30)-0.5*(1+TIME)", false}, Case{"MOTION/1,JOINT=1,FUNCTION=0", false},
        Case{"MOTION/1,JOINT=1,VELOCITY,FUNCTION=1", false},
        // Forces with a potential, and without.
        Case{"SPRINGDAMPER/1,TRANSLATIONAL,I=21,J=30,K=2,LENGTH=0.3,FORCE=1", true},
        Case{"SPRINGDAMPER/1,ROTATIONAL,I=20,J=10,KT=2,ANGLE=9D,TORQUE=1", true},
        Case{"SPRINGDAMPER/1,TRANSLATIONAL,I=21,J=30,K=2,C=0.1", false},
        Case{"SPRINGDAMPER/1,ROTATIONAL,I=20,J=10,KT=2,CT=0.1", false},
        Case{"BUSHING/1,I=20,J=30,K=1,2,3,FORCE=1,0,0", true},
        Case{"BUSHING/1,I=20,J=30,K=1,2,3,C=0,1,0", false},
        Case{"BUSHING/1,I=20,J=30,KT=1,2,3", false},  // a potential only while the angles are small
        Case{"SFORCE/1,TRANSLATIONAL,I=21,J=30,FUNCTION=1", false},
        Case{"VFORCE/1,I=20,JFLOAT=31,FX=1", false}, Case{"VTORQUE/1,I=20,JFLOAT=31,TX=1", false},
        Case{"GFORCE/1,I=20,JFLOAT=31,TX=1", false},
        // What only looks on.
        Case{"SENSOR/1,VALUE=1,HALT,FUNCTION=TIME", true}, Case{"REQUEST/1,F2=TIME", true},
        Case{"VARIABLE/1,FUNCTION=TIME", true}));

}  // namespace
}  // namespace jprim
