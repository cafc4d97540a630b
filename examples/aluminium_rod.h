// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_EXAMPLES_ALUMINIUM_ROD_H_
#define JPRIM_EXAMPLES_ALUMINIUM_ROD_H_

#include <jprim/jprim.h>

/// The rod that bends in the examples: 1 m of aluminium, 20 mm wide along z and 10 mm thick along y, its body
/// frame at node 1 with x along the rod; E I / (rho A) = 216 m^4/s^2.
struct AluminiumRod {
    static constexpr int Elements = 10;
    static constexpr int Start = 1, Middle = Elements / 2 + 1, End = Elements + 1;  // node ids

    static jprim::UniformBeam makeBeam() {
        jprim::UniformBeam beam;
        beam.length = 1;  // m
        beam.elements = Elements;
        beam.youngsModulus = 7e10;                   // Pa
        beam.shearModulus = 2.6e10;                  // Pa
        beam.density = 2700;                         // kg/m^3
        beam.area = 0.02 * 0.01;                     // m^2
        beam.secondMomentY = 0.01 * 8e-6 / 12;       // m^4
        beam.secondMomentZ = 0.02 * 1e-6 / 12;       // m^4
        beam.torsionConstant = 0.229 * 0.02 * 1e-6;  // m^4
        return beam;
    }

    /// Interfaces at both ends, four modes between them.
    static jprim::ModalBasis makeBasis() {
        return jprim::reduceToModes(jprim::makeFiniteElementModel(makeBeam()),
                                    {{{Start}, 0, {}}, {{End}, 0, {}}}, 4);
    }

    /// E I / (rho A) [m^4/s^2] for bending in the xy plane.
    static double getStiffness() {
        const jprim::UniformBeam b = makeBeam();
        return b.youngsModulus * b.secondMomentZ / (b.density * b.area);
    }

    /// How far the middle is off the straight line between the ends, along the rod's y axis [m].
    static double findDeflection(const jprim::FlexibleBody& rod, const SimTK::State& state) {
        const auto place = [&](int node) { return jprim::Marker(rod, node).findPoseInGround(state).p(); };
        const SimTK::Vec3 start = place(Start), end = place(End);
        const SimTK::Vec3 across = SimTK::Vec3(0, 0, 1) % (end - start).normalize();
        return SimTK::dot(place(Middle) - (start + end) / 2, across);
    }
};

#endif
