// SPDX-License-Identifier: Apache-2.0
// Forces and measures are evaluated without taking memory.
#include <gtest/gtest.h>

#include "jprim/flexible/reduce_to_modes.h"
#include "jprim/force/expression_measure.h"
#include "jprim/force/marker_force.h"
#include "support/allocations.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

using SimTK::MobilizedBody;
using SimTK::SpatialVec;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;
using testing::getNumAllocations;

enum class Kind { Nothing, Rigid, Flexible };

/// Stands where a force would: what Simbody itself takes for one.
class NoForce : public SimTK::Force::Custom::Implementation {
    void calcForce(const State&, SimTK::Vector_<SpatialVec>&, SimTK::Vector_<Vec3>&,
                   SimTK::Vector&) const override {}
    SimTK::Real calcPotentialEnergy(const State&) const override { return 0; }
};

/// Two bodies with a force between them, which depends on all that a force may.
struct Pair {
    explicit Pair(Kind kind) : body(makeBody()), I(body, Transform(Vec3(0.1, 0.2, -0.3))), J(makeJ(kind)) {
        const std::map<int, Marker> markers{{1, I}, {2, J}};
        law.force = Expression("DXYZ(1,2)*(3+AZ(1,2))+VXYZ(1,2,2,2)%UVX(1)", markers);
        law.moment = Expression("[WX(1,2),STEP(TIME,0,1,1,2),MAX(YAW(1,2),DM(1,2))]", markers);
        law.potential = Expression("AZ(1,2)**2", markers);
        if (kind == Kind::Nothing) {
            SimTK::Force::Custom(forces, new NoForce());
        } else {
            force = MarkerForce(forces, I, J, law, "GFORCE/1");
        }
        state = system.realizeTopology();
        realizeAt(0.2);
    }

    MobilizedBody::Free makeBody() {
        return MobilizedBody::Free(matter.Ground(), SimTK::Body::Rigid(SimTK::MassProperties(
                                                        2, Vec3(0), SimTK::Inertia(0.3, 0.4, 0.5))));
    }

    Marker makeJ(Kind kind) {
        if (kind == Kind::Rigid) return Marker(makeBody(), Transform(Vec3(0.3)));
        const ModalBasis basis =
            reduceToModes(makeFiniteElementModel(testing::makeSteelBeam(3)), {{{4}, 0, {}}}, 3);
        return Marker(FlexibleBody(matter, forces, basis), 4);
    }

    void realizeAt(double time) {
        state.updTime() = time;
        for (int k = 0; k < state.getNU(); ++k) state.updU()[k] = time + 0.01 * k;
        system.realize(state, Stage::Acceleration);
    }

    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    SimTK::GeneralForceSubsystem forces{system};
    MobilizedBody::Free body;
    Marker I, J;
    ForceLaw law;
    MarkerForce force;
    State state;
};

TEST(ForceAllocation, LoadsAndMeasuresTakeNoMemory) {
    for (const Kind kind : {Kind::Rigid, Kind::Flexible}) {
        SCOPED_TRACE(int(kind));
        Pair pair(kind);
        const ExpressionMeasure measure(pair.forces,
                                        Expression("ACCX(1,2)+AZ(1,2)", {{1, pair.I}, {2, pair.J}}));
        pair.state = pair.system.realizeTopology();
        pair.realizeAt(0.3);
        const int before = getNumAllocations();
        const SpatialVec onI = pair.force.calcLoadOnI(pair.state), onJ = pair.force.calcLoadOnJ(pair.state);
        const double value = measure.calcValue(pair.state);
        EXPECT_EQ(getNumAllocations(), before);
        Expression("DX(1,2)", {{1, pair.I}, {2, pair.J}}).calcValue(pair.state);
        EXPECT_GT(getNumAllocations(), before)
            << "without a place in the State it takes some; the counter counts";
        EXPECT_GT(onI[1].norm() * onJ[1].norm() * std::abs(value), 0.1);
    }
}

// Realizing anew takes as much as Simbody does for a force that does nothing.
TEST(ForceAllocation, RealizingTakesNoMemoryOfOurs) {
    const auto count = [](Kind kind) {
        Pair pair(kind);
        const int before = getNumAllocations();
        pair.realizeAt(0.4);
        return getNumAllocations() - before;
    };
    EXPECT_EQ(count(Kind::Flexible), count(Kind::Nothing));
}

}  // namespace
}  // namespace jprim
