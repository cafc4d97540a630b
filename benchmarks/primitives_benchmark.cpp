// SPDX-License-Identifier: Apache-2.0
// Each primitive beside Simbody's nearest built-in, and a joint beside Simbody's and beside its own primitives.
#include "contest.h"
#include "jprim/jprim.h"

namespace {

using jprim::Marker;
using jprim::benchmarks::Contest;
using jprim::benchmarks::StationOnI;
using SimTK::Constraint;
using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::Transform;

template <class Primitive>
void addPrimitive(MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
    Primitive(Marker(I, Transform(StationOnI)), Marker(J, X_BJ));
}

template <jprim::Joint (*Make)(const Marker&, const Marker&, const std::string&)>
void addJoint(MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
    Make(Marker(I, Transform(StationOnI)), Marker(J, X_BJ), "");
}

const std::vector<Contest> Contests = {
    {"AtPoint", "Ball", addPrimitive<jprim::AtPoint>,
     [](MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
         Constraint::Ball(J, X_BJ.p(), I, StationOnI);
     }},
    {"InLine", "PointOnLine", addPrimitive<jprim::InLine>,
     [](MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
         Constraint::PointOnLine(J, X_BJ.z(), X_BJ.p(), I, StationOnI);
     }},
    {"InPlane", "PointInPlane", addPrimitive<jprim::InPlane>, jprim::benchmarks::addPointInPlane},
    {"Orientation", "ConstantOrientation", addPrimitive<jprim::Orientation>,
     [](MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
         Constraint::ConstantOrientation(J, X_BJ.R(), I, Rotation());
     }},
    {"ParallelAxes", "2 ConstantAngle", addPrimitive<jprim::ParallelAxes>,
     [](MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
         Constraint::ConstantAngle(J, X_BJ.x(), I, SimTK::UnitVec3(SimTK::ZAxis), SimTK::Pi / 2);
         Constraint::ConstantAngle(J, X_BJ.y(), I, SimTK::UnitVec3(SimTK::ZAxis), SimTK::Pi / 2);
     }},
    {"Perpendicular", "ConstantAngle", addPrimitive<jprim::Perpendicular>, jprim::benchmarks::addRightAngle},
    {"Fixed", "Weld", addJoint<jprim::Joint::Fixed>,
     [](MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
         Constraint::Weld(J, X_BJ, I, Transform(StationOnI));
     }},
    {"Revolute", "AtPoint and ParallelAxes", addJoint<jprim::Joint::Revolute>,
     [](MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
         addPrimitive<jprim::AtPoint>(J, I, X_BJ);
         addPrimitive<jprim::ParallelAxes>(J, I, X_BJ);
     }}};

}  // namespace

int main(int argc, char** argv) {
    jprim::benchmarks::runContests(Contests, argc, argv);
    return 0;
}
