// SPDX-License-Identifier: Apache-2.0
// Equations written as expressions beside Simbody's built-ins for the same.
#include "contest.h"
#include "jprim/jprim.h"

namespace {

using jprim::Marker;
using jprim::benchmarks::AddConstraint;
using jprim::benchmarks::Contest;
using jprim::benchmarks::StationOnI;
using SimTK::Constraint;
using SimTK::MobilizedBody;
using SimTK::Transform;

// Markers 1 and 2 are I and J.
AddConstraint makeGeneral(const std::string& text) {
    return [text](MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
        const Marker markerI(I, Transform(StationOnI)), markerJ(J, X_BJ);
        jprim::GeneralConstraint(jprim::Expression(text, {{1, markerI}, {2, markerJ}}));
    };
}

const std::vector<Contest> Contests = {
    {"DM(1,2)-0.3", "Rod", makeGeneral("DM(1,2)-0.3"),
     [](MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
         Constraint::Rod(J, X_BJ.p(), I, StationOnI, 0.3);
     }},
    {"DZ(1,2,2)", "PointInPlane", makeGeneral("DZ(1,2,2)"), jprim::benchmarks::addPointInPlane},
    {"UVZ(1)*UVZ(2)", "ConstantAngle", makeGeneral("UVZ(1)*UVZ(2)"), jprim::benchmarks::addRightAngle}};

}  // namespace

int main(int argc, char** argv) {
    jprim::benchmarks::runContests(Contests, argc, argv);
    return 0;
}
