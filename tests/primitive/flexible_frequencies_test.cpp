// SPDX-License-Identifier: Apache-2.0
// Vibrations of uniform beams as Simbody sees them, held by primitives in the ways of the textbook.
// Closed forms: Blevins, Formulas for Natural Frequency and Mode Shape, 1979, tables 8-1 and 8-16.
#include <gtest/gtest.h>

#include <cmath>

#include "jprim/jprim.h"
#include "support/linearize.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

using namespace testing;
using SimTK::Pi;
using SimTK::Rotation;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

constexpr double Tolerance = 1e-3;

struct Mesh {
    int elements;
    int fixedModes;
};
// The fifth bending modes need few of both.
constexpr Mesh ForBending{40, 30};
// The second axial and torsional modes lie above thirty bending modes, and 100 linear elements hold them to
// (2 pi/100)^2/24 = 2e-4.
constexpr Mesh ForStretchAndTwist{100, 110};
// The first mode alone; every further one makes the steps shorter.
constexpr Mesh ForMotion{20, 8};

ModalBasis makeBasis(const Mesh& mesh) {
    return reduceToModes(makeFiniteElementModel(makeSteelBeam(mesh.elements)),
                         {{{1}, 0, {}}, {{mesh.elements + 1}, 0, {}}}, mesh.fixedModes);
}

double getBendingFrequency(const UniformBeam& b, double root, double I) {
    return std::pow(root / b.length, 2) * std::sqrt(b.youngsModulus * I / (b.density * b.area));
}

double getAxialFrequency(const UniformBeam& b, double root) {
    return root / b.length * std::sqrt(b.youngsModulus / b.density);
}

double getTorsionalFrequency(const UniformBeam& b, double root) {
    return root / b.length *
           std::sqrt(b.shearModulus * b.torsionConstant / (b.density * (b.secondMomentY + b.secondMomentZ)));
}

struct Support {
    const char* name;
    std::vector<double> bending, axial, torsional;  // roots: beta L
    void (*hold)(const Marker& start, const Marker& end, const Marker& groundAtStart,
                 const Marker& groundAtEnd);
};

std::ostream& operator<<(std::ostream& out, const Support& s) {
    return out << s.name;
}

const Support Supports[] = {
    {"FreeFree",
     {4.730040744862704, 7.853204624095838, 10.995607838001671, 14.137165491257464, 17.27875965739948},
     {Pi, 2 * Pi},
     {Pi, 2 * Pi},
     [](const Marker&, const Marker&, const Marker&, const Marker&) {}},
    {"Clamped",
     {1.875104068711961, 4.694091132974175, 7.854757438237613, 10.995540734875467, 14.13716839104647},
     {Pi / 2, 3 * Pi / 2},
     {Pi / 2, 3 * Pi / 2},
     [](const Marker& start, const Marker&, const Marker& groundAtStart, const Marker&) {
         AtPoint(start, groundAtStart);
         Orientation(start, groundAtStart);
     }},
    {"Pinned",
     {Pi, 2 * Pi, 3 * Pi, 4 * Pi, 5 * Pi},
     {Pi / 2, 3 * Pi / 2},
     {Pi, 2 * Pi},
     [](const Marker& start, const Marker& end, const Marker& groundAtStart, const Marker& groundAtEnd) {
         AtPoint(start, groundAtStart);
         InLine(end, groundAtEnd);
     }}};

/// An undamped beam in Ground, held at its ends.
struct HeldBeam {
    HeldBeam(const Support& support, const Mesh& mesh) {
        const ModalBasis basis = makeBasis(mesh);
        const std::vector<double> undamped(size_t(basis.getNumModes()), 0.);
        beam = FlexibleBody(system.matter, system.forces, basis, {InertiaCoupling::Partial, undamped});
        const Rotation zAlongBeam(Pi / 2, SimTK::YAxis);
        const Marker ground(system.matter.Ground());
        support.hold(Marker(beam, 1), Marker(beam, mesh.elements + 1), ground,
                     ground.withPose(Transform(zAlongBeam, Vec3(2, 0, 0))));
        state = system.system.realizeTopology();
    }

    FlexibleSystem system;
    FlexibleBody beam;
    State state;
};

class FlexibleBeam : public ::testing::TestWithParam<Support> {};

TEST_P(FlexibleBeam, BendsAtTheFrequenciesOfTheTextbook) {
    const UniformBeam b = makeSteelBeam(1);
    const HeldBeam held(GetParam(), ForBending);
    const std::vector<double> frequencies = calcFrequencies(held.system, held.state);
    for (const double root : GetParam().bending)
        for (const double I : {b.secondMomentY, b.secondMomentZ})
            expectFrequency(frequencies, getBendingFrequency(b, root, I), Tolerance);
    EXPECT_NEAR(frequencies[0] / getBendingFrequency(b, GetParam().bending[0], b.secondMomentY), 1,
                Tolerance);
}

TEST_P(FlexibleBeam, StretchesAndTwistsAtTheFrequenciesOfTheTextbook) {
    const UniformBeam b = makeSteelBeam(1);
    const HeldBeam held(GetParam(), ForStretchAndTwist);
    const std::vector<double> frequencies = calcFrequencies(held.system, held.state);
    for (const double root : GetParam().axial)
        expectFrequency(frequencies, getAxialFrequency(b, root), Tolerance);
    for (const double root : GetParam().torsional)
        expectFrequency(frequencies, getTorsionalFrequency(b, root), Tolerance);
}

// Started with the velocities of the first mode, the middle is back where it was after half a period.
TEST_P(FlexibleBeam, SwingsInTheTimeOfTheTextbook) {
    HeldBeam held(GetParam(), ForMotion);
    const SimTK::Vector mode = calcFirstMode(held.system, held.state);
    held.state.updU() = 1e-3 * mode;
    const Marker middle(held.beam, ForMotion.elements / 2 + 1);
    const auto getHeight = [&](const State& s) {
        held.system.system.realize(s, SimTK::Stage::Position);
        return middle.findPoseInGround(s).p()[2];
    };
    const double half =
        Pi / getBendingFrequency(makeSteelBeam(1), GetParam().bending[0], makeSteelBeam(1).secondMomentY);
    double crossing = 0, previousTime = 0, previousHeight = 0;
    integrate(held.system, held.state, 1.1 * half, 1e-8, [&](const State& s) {
        const double height = getHeight(s);
        if (s.getTime() > 0.5 * half && height * previousHeight < 0)
            crossing =
                previousTime + (s.getTime() - previousTime) * previousHeight / (previousHeight - height);
        previousTime = s.getTime();
        previousHeight = height;
    });
    EXPECT_NEAR(crossing / half, 1, Tolerance);
}

INSTANTIATE_TEST_SUITE_P(Each, FlexibleBeam, ::testing::ValuesIn(Supports),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace jprim
