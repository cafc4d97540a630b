// SPDX-License-Identifier: Apache-2.0
// What the diagnosis of constraints costs: a row of four-bars on free bodies, each standing on the coupler of
// the one before, so that all hang together; three of 20 equations are redundant in each.
#include <vector>

#include "base/format.h"
#include "jprim/jprim.h"
#include "measure.h"

namespace {

using jprim::Joint;
using jprim::Marker;
using jprim::benchmarks::measureSeconds;
using SimTK::MobilizedBody;
using SimTK::Transform;
using SimTK::Vec3;

class RowOfFourBars {
public:
    explicit RowOfFourBars(int length) {
        MobilizedBody base = matter.Ground();
        for (int k = 0; k < length; ++k) base = addFourBar(base, Vec3(0.1 * k, 1.2 * k, 0));
    }

    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};

private:
    // Drawn in Ground with its first pin at p; all bodies' frames are Ground's. Returns the coupler.
    MobilizedBody addFourBar(const MobilizedBody& base, const Vec3& p) {
        const SimTK::Body::Rigid body(SimTK::MassProperties(1, Vec3(0), SimTK::Inertia(1)));
        const std::vector<Vec3> pins = {Vec3(0), Vec3(0.3, 1.1, 0), Vec3(1.4, 1.3, 0), Vec3(2, 0.2, 0)};
        std::vector<MobilizedBody> links = {base};
        for (int k = 0; k < 3; ++k) links.push_back(MobilizedBody::Free(matter.Ground(), body));
        links.push_back(base);
        for (int k = 0; k < 4; ++k)
            Joint::Revolute(Marker(links[size_t(k) + 1], Transform(p + pins[size_t(k)])),
                            Marker(links[size_t(k)], Transform(p + pins[size_t(k)])));
        return links[2];
    }
};

}  // namespace

int main() {
    fmt::print("equations    speeds  redundant     count [s]   diagnosis [s]\n");
    for (const int length : {1, 5, 10, 25, 50}) {
        RowOfFourBars row(length);
        const SimTK::State state = row.system.realizeTopology();
        row.system.realize(state, SimTK::Stage::Position);
        jprim::ConstraintReport report;
        const double counting = measureSeconds([&] { jprim::countFreedoms(row.matter, state); });
        const double diagnosis =
            measureSeconds([&] { report = jprim::analyzeConstraints(row.matter, state); });
        fmt::print("{:>9}{:>10}{:>11}{:>14.4f}{:>16.4f}\n", report.numEquations, report.numMobilities,
                   report.redundant.size(), counting, diagnosis);
    }
    return 0;
}
