// SPDX-License-Identifier: Apache-2.0
// A shared object that carries a static jprim in it, as plug-ins and Python modules do.
#include <jprim/jprim.h>

static_assert(JPRIM_VERSION_NUMBER >= JPRIM_MAKE_VERSION(0, 1, 0), "the version is a number");

extern "C" int countEquations() {
    using namespace SimTK;
    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    MobilizedBody::Free rod(matter.Ground(), Body::Rigid(MassProperties(2, Vec3(0), Inertia(0.1))));
    const jprim::AtPoint point(jprim::Marker(rod), jprim::Marker(matter.Ground()));
    State state = system.realizeTopology();
    system.realize(state, Stage::Position);
    return point.getNumEquations();
}
