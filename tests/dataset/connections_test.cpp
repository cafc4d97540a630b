// SPDX-License-Identifier: Apache-2.0
// What constraints, forces, and the data and events that go with them become.
#include <cmath>

#include "dataset/reading.h"

namespace jprim {
namespace {

constexpr double Pi = 3.14159265358979323846;

TEST(DatasetReader, PointMasses) {
    const Dataset dataset = readGood(
        "POINT_MASS/2, QG=1,2,3, REULER=90D,0,0, MASS=0.75, CM=30, VX=4, VZ=-5, EXACT=Z:X\n"
        "MARKER/30, QP=6,7,8\nMARKER/31, POINT_MASS=2\nMARKER/32, PART=2\nPOI/3, ZG=1,2,4, XG=2,2,3");
    ASSERT_EQ(dataset.pointMasses.size(), 2u);
    const PointMassStatement& p = dataset.pointMasses[0];
    EXPECT_EQ(p.id, 2);
    EXPECT_EQ(p.where.line, 3);
    EXPECT_EQ(p.qg, (Triple{1, 2, 3}));
    EXPECT_EQ(p.reuler, (Triple{Pi / 2, 0, 0}));
    EXPECT_EQ(p.mass, 0.75);
    EXPECT_EQ(p.cm, 30);
    EXPECT_EQ(p.v[0], 4.0);
    EXPECT_FALSE(p.v[1]);
    EXPECT_EQ(p.v[2], -5.0);
    EXPECT_EQ(p.exact, (std::array<bool, 6>{true, false, true, false, false, false}));
    EXPECT_EQ(dataset.pointMasses[1].zg, (Triple{1, 2, 4}));
    EXPECT_EQ(dataset.pointMasses[1].xg, (Triple{2, 2, 3}));
    EXPECT_EQ(dataset.markers[2].pointMass, 2);  // the nearest body before it
    EXPECT_EQ(dataset.markers[2].part, 0);
    EXPECT_EQ(dataset.markers[3].pointMass, 2);
    EXPECT_EQ(dataset.markers[4].part, 2);  // PART/2 is another body
    EXPECT_EQ(dataset.markers[4].pointMass, 0);
}

TEST(DatasetReader, JointsWithValuesOfTheirOwn) {
    const Dataset dataset = readGood(
        "JOINT/1, SCREW, PITCH=-2.5, I=1, J=2\nJOINT/2, RACKPIN, PD=40, I=1, J=2\nJOINT/3, CONV, I=1, J=2\n"
        "JOINT/4, REV, IC=90D, -180D, I=1, J=2\nJOINT/5, TRA, IC=3, I=1, J=2\n"
        "JOINT/6, CYL, ICT=4,5, ICROT=-90D, I=1, J=2");
    EXPECT_EQ(dataset.joints[0].type, JointType::Screw);
    EXPECT_EQ(dataset.joints[0].pitch, -2.5);
    EXPECT_FALSE(dataset.joints[0].diameter || dataset.joints[0].ic);
    EXPECT_EQ(dataset.joints[1].type, JointType::Rackpin);
    EXPECT_EQ(dataset.joints[1].diameter, 40.0);
    EXPECT_EQ(dataset.joints[2].type, JointType::Convel);
    EXPECT_EQ(dataset.joints[3].ic->displacement, Pi / 2);
    EXPECT_EQ(dataset.joints[3].ic->velocity, -Pi);
    EXPECT_EQ(dataset.joints[4].ic->displacement, 3);
    EXPECT_FALSE(dataset.joints[4].ic->velocity);
    EXPECT_EQ(dataset.joints[5].icTranslation->displacement, 4);
    EXPECT_EQ(dataset.joints[5].icTranslation->velocity, 5.0);
    EXPECT_EQ(dataset.joints[5].icRotation->displacement, -Pi / 2);
    EXPECT_FALSE(dataset.joints[5].icRotation->velocity || dataset.joints[5].ic);
}

// The example of a reaction on a rod, and a distance.
TEST(DatasetReader, Gcons) {
    const Dataset dataset = readGood("GCON/1, I=02, FUNC=UVZ(2)*UVX(1)\nGC/02, FUNCTION = DM(2,1)-2, I=0");
    ASSERT_EQ(dataset.gcons.size(), 2u);
    EXPECT_EQ(dataset.gcons[0].id, 1);
    EXPECT_EQ(dataset.gcons[0].i, 2);
    EXPECT_EQ(dataset.gcons[0].function.text, "UVZ(2)*UVX(1)");
    EXPECT_EQ(dataset.gcons[1].i, 0);
    EXPECT_EQ(dataset.gcons[1].function.text, "DM(2,1)-2");
    EXPECT_EQ(dataset.gcons[1].function.getPosition(0).column, 19);
}

TEST(DatasetReader, MotionsOfJoints) {
    const Dataset dataset = readGood(  // the joints come later
        "MOTION/1, JOINT=3, FUNCTION=30D*TIME\nMO/2, FUNCTION=1\\ROTATION, JOINT=5\n"
        "MOTION/3\n, TRANSLATIONAL\n, JOINT=5\n, VELOCITY\n, ICDISP = 2\n, FUNCTION = 3 * time\n"
        "MOTION/4, JOINT=4, ACC, ICD=1, ICV=-2, FUN=4\nMOTION/5, ROT, JOINT=3, DISP, FUNCTION=0\n"
        "MOTION/6, JOINT=3, VEL, ICDISP=180D, FUNCTION=0\n"
        "JOINT/3, REV, I=1, J=2; JOINT/4, TRA, I=1, J=2; JOINT/5, CYL, I=1, J=2");
    ASSERT_EQ(dataset.motions.size(), 6u);
    const auto& m = dataset.motions;
    EXPECT_EQ(m[0].joint, 3);
    EXPECT_EQ(m[0].axis, MotionAxis::Joint);
    EXPECT_EQ(m[0].level, KinematicLevel::Position);
    EXPECT_EQ(m[0].function.text, "30D*TIME");
    EXPECT_FALSE(m[0].icdisp || m[0].icvel);
    EXPECT_EQ(m[1].axis, MotionAxis::Rotation);
    EXPECT_EQ(m[2].axis, MotionAxis::Translation);
    EXPECT_EQ(m[2].level, KinematicLevel::Velocity);
    EXPECT_EQ(m[2].icdisp, 2.0);
    EXPECT_EQ(m[2].function.text, "3 * time");
    EXPECT_EQ(m[3].level, KinematicLevel::Acceleration);
    EXPECT_EQ(m[3].icdisp, 1.0);
    EXPECT_EQ(m[3].icvel, -2.0);
    EXPECT_EQ(m[4].axis, MotionAxis::Rotation);
    EXPECT_EQ(m[5].icdisp, Pi);
}

TEST(DatasetReader, MotionsBetweenMarkers) {
    const MotionAxis axes[] = {MotionAxis::X,  MotionAxis::Y,  MotionAxis::Z,
                               MotionAxis::B1, MotionAxis::B2, MotionAxis::B3};
    for (const MotionAxis axis : axes) {
        const Dataset dataset =
            readGood("MOTION/7, J=1, " + std::string(getAdamsName(axis)) + ", I=2, FUNCTION=TIME**2");
        ASSERT_EQ(dataset.motions.size(), 1u);
        EXPECT_EQ(dataset.motions[0].axis, axis);
        EXPECT_EQ(dataset.motions[0].i, 2);
        EXPECT_EQ(dataset.motions[0].j, 1);
        EXPECT_EQ(dataset.motions[0].joint, 0);
    }
}

TEST(DatasetReader, Couplers) {
    using T = CouplerType;
    const Dataset dataset = readGood(
        "JOINT/1, REV, I=1, J=2; JOINT/2, TRA, I=1, J=2; JOINT/3, CYL, I=1, J=2\n"
        "COUPLER/1, JOINTS=01,2, SCALES=1,-2\nCOUPLER/2, JOINTS=2,1,2, SCALES=3,4\n"
        "COU/3, SCALES=-1, 0.25, 2, TYPE = R:TRANSLATION:r, JOINTS=1,3,3");
    ASSERT_EQ(dataset.couplers.size(), 3u);
    EXPECT_EQ(dataset.couplers[0].joints, (std::vector<int>{1, 2}));
    EXPECT_EQ(dataset.couplers[0].types, (std::vector<T>{T::Rotational, T::Translational}));
    EXPECT_EQ(dataset.couplers[0].scales, (std::vector<double>{1, -2}));
    EXPECT_EQ(dataset.couplers[1].types, (std::vector<T>{T::Translational, T::Rotational, T::Translational}));
    EXPECT_EQ(dataset.couplers[1].scales, (std::vector<double>{1, 3, 4}));  // one fewer: the first is 1
    EXPECT_EQ(dataset.couplers[2].types, (std::vector<T>{T::Rotational, T::Translational, T::Rotational}));
    EXPECT_EQ(dataset.couplers[2].scales, (std::vector<double>{-1, 0.25, 2}));
}

TEST(DatasetReader, SingleForces) {
    const Dataset dataset = readGood(
        "MARKER/3, PART=2\nsforce/1, TRANSLATION, i=2, j=1, function=-3*(DM(2,1)-4)\n"
        "SFORCE/2\n, ROTATIONAL\n, ACTIONONLY\n, I = 2\n, J = 3\n, FUNCTION = 5");
    ASSERT_EQ(dataset.sforces.size(), 2u);
    EXPECT_EQ(dataset.sforces[0].i, 2);
    EXPECT_EQ(dataset.sforces[0].j, 1);
    EXPECT_FALSE(dataset.sforces[0].rotational || dataset.sforces[0].actionOnly);
    EXPECT_EQ(dataset.sforces[0].function.text, "-3*(DM(2,1)-4)");
    EXPECT_TRUE(dataset.sforces[1].rotational && dataset.sforces[1].actionOnly);
    EXPECT_EQ(dataset.sforces[1].j, 3);  // J may be on the same part: without reaction it is a direction
}

TEST(DatasetReader, VectorForces) {
    const Dataset dataset = readGood(
        "MARKER/3, PART=1, FLOATING\nVFORCE/1, I=2, JFLOAT=3, RM=1, FX=1\\ FY=2*TIME\\FZ=3\n"
        "VTORQUE/1, I=2, JFLOAT=3, TZ=4, TX=5\n"
        "GFORCE/1, I=2, JFL=3, FXYZ=[1,2,3]\\ TXYZ=\n, [4,5,6]\\ RM=0");
    ASSERT_EQ(dataset.vectorForces.size(), 3u);
    const auto& f = dataset.vectorForces;
    EXPECT_EQ(f[0].type, VectorForceType::Vforce);
    EXPECT_EQ(f[0].i, 2);
    EXPECT_EQ(f[0].jfloat, 3);
    EXPECT_EQ(f[0].rm, 1);
    EXPECT_EQ(f[0].components[0]->text, "1");
    EXPECT_EQ(f[0].components[1]->text, "2*TIME");
    EXPECT_EQ(f[0].components[2]->text, "3");
    EXPECT_FALSE(f[0].components[3] || f[0].fxyz || f[0].txyz);
    EXPECT_EQ(f[1].type, VectorForceType::Vtorque);
    EXPECT_FALSE(f[1].components[0] || f[1].components[4]);
    EXPECT_EQ(f[1].components[3]->text, "5");
    EXPECT_EQ(f[1].components[5]->text, "4");
    EXPECT_EQ(f[2].type, VectorForceType::Gforce);
    EXPECT_EQ(f[2].fxyz->text, "[1,2,3]");
    EXPECT_EQ(f[2].txyz->text, "[4,5,6]");
    EXPECT_EQ(f[2].txyz->getPosition(0).line, 7);
    EXPECT_TRUE(dataset.markers[2].floating);
    EXPECT_FALSE(dataset.markers[1].floating);
}

TEST(DatasetReader, SpringsAndBushings) {
    const Dataset dataset = readGood(
        "SPRINGDAMPER/1, TRANSLATION, I=2, J=1, K=100, C=2.5, LENGTH=3, FORCE=-4\n"
        "SPR/2, I=2, J=1, ROT, KT=5, CT=6, ANGLE=45D, TORQUE=7\nSPR/3, I=2, J=1, TRANS\n"
        "BUSHING/1, I=2, J=1, K=1,2,3, C=4,5,6, KT=7,8,9, CT=10,11,12, FORCE=13,14,15, TORQUE=16,17,18\n"
        "BU/2, I=1, J=2");
    ASSERT_EQ(dataset.springdampers.size(), 3u);
    const SpringdamperStatement& line = dataset.springdampers[0];
    EXPECT_FALSE(line.rotational);
    EXPECT_EQ(line.i, 2);
    EXPECT_EQ(line.j, 1);
    EXPECT_EQ(line.stiffness, 100);
    EXPECT_EQ(line.damping, 2.5);
    EXPECT_EQ(line.freeLength, 3);
    EXPECT_EQ(line.preload, -4);
    const SpringdamperStatement& turn = dataset.springdampers[1];
    EXPECT_TRUE(turn.rotational);
    EXPECT_EQ(turn.stiffness, 5);
    EXPECT_EQ(turn.damping, 6);
    EXPECT_EQ(turn.freeLength, Pi / 4);
    EXPECT_EQ(turn.preload, 7);
    EXPECT_EQ(dataset.springdampers[2].stiffness, 0);
    const BushingStatement& b = dataset.bushings.at(0);
    EXPECT_EQ(b.k, (Triple{1, 2, 3}));
    EXPECT_EQ(b.c, (Triple{4, 5, 6}));
    EXPECT_EQ(b.kt, (Triple{7, 8, 9}));
    EXPECT_EQ(b.ct, (Triple{10, 11, 12}));
    EXPECT_EQ(b.force, (Triple{13, 14, 15}));
    EXPECT_EQ(b.torque, (Triple{16, 17, 18}));
    EXPECT_EQ(dataset.bushings.at(1).kt, Triple{});
}

TEST(DatasetReader, VariablesAndSplines) {
    const Dataset dataset = readGood(
        "VARIABLE/1, IC=2, FUNCTION=VARVAL(1)/2+1\nVAR/2, FUNC=3\n"
        "SPLINE/1\n, X = -1, 0, 2\n, 3, 5.5\n, Y = 1, 4\n, 9, 16, 25, LINEAR_EXTRAPOLATE\n"
        "SPL/2, X=1,2,3,4, Y=-1,10,20,30,40, Y=7,50,60,70,80\nSPLINE/3, X=1,2,3,4, Y=5,1,2,3,4");
    EXPECT_EQ(dataset.variables.at(0).ic, 2.0);
    EXPECT_EQ(dataset.variables.at(0).function.text, "VARVAL(1)/2+1");
    EXPECT_FALSE(dataset.variables.at(1).ic);
    ASSERT_EQ(dataset.splines.size(), 3u);
    using Curves = std::vector<std::pair<double, std::vector<double>>>;
    EXPECT_EQ(dataset.splines[0].x, (std::vector<double>{-1, 0, 2, 3, 5.5}));
    EXPECT_EQ(dataset.splines[0].curves, (Curves{{0, {1, 4, 9, 16, 25}}}));
    EXPECT_TRUE(dataset.splines[0].linearExtrapolate);
    EXPECT_EQ(dataset.splines[1].curves, (Curves{{-1, {10, 20, 30, 40}}, {7, {50, 60, 70, 80}}}));
    EXPECT_FALSE(dataset.splines[1].linearExtrapolate);
    EXPECT_EQ(dataset.splines[2].curves, (Curves{{5, {1, 2, 3, 4}}}));  // a family of one
}

TEST(DatasetReader, Sensors) {
    const Dataset dataset = readGood(
        "SENSOR/1, GE, VALUE=90D, ERROR=0.25, HALT, FUNCTION=AZ(2,1)\n"
        "SE/2, FUNCTION=TIME\\ LE, VALUE=3, RETURN\nSENSOR/3, HALT, RETURN, VALUE=-1, FUNC=DX(1)");
    ASSERT_EQ(dataset.sensors.size(), 3u);
    const auto& s = dataset.sensors;
    EXPECT_EQ(s[0].comparison, SensorComparison::GreaterOrEqual);
    EXPECT_EQ(s[0].value, Pi / 2);
    EXPECT_EQ(s[0].error, 0.25);
    EXPECT_TRUE(s[0].halt);
    EXPECT_FALSE(s[0].endsCommand);
    EXPECT_EQ(s[0].function.text, "AZ(2,1)");
    EXPECT_EQ(s[1].comparison, SensorComparison::LessOrEqual);
    EXPECT_EQ(s[1].error, 1e-3);  // Adams' default
    EXPECT_FALSE(s[1].halt);
    EXPECT_TRUE(s[1].endsCommand);
    EXPECT_EQ(s[2].comparison, SensorComparison::Equal);
}

TEST(DatasetReader, WhatConcernsOnlyTheSolverIsIgnored) {
    const Dataset dataset = readGood(
        "INTEGRATOR/GSTIFF, ERROR=1.0E-03\nIC/ERROR=1E-10\nEQUILIBRIUM/MAXIT=50\nKINEMATICS/\n"
        "DEBUG/EPRINT\nPREFERENCES/SOLVER=CXX\nLSOLVER/CALAHAN\nSTRING/1, STRING=a name (of a file)");
    EXPECT_EQ(dataset.counts.ignored, 8);
    EXPECT_EQ(dataset.ignored[0].keyword, "INTEGRATOR");
    EXPECT_EQ(dataset.ignored[0].arguments, "GSTIFF, ERROR=1.0E-03");
    EXPECT_EQ(dataset.ignored[7].id, 1);
}

}  // namespace
}  // namespace jprim
