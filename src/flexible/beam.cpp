// SPDX-License-Identifier: Apache-2.0
#include "jprim/flexible/beam.h"

#include <cmath>

#include "base/format.h"
#include "jprim/base/error.h"

namespace jprim {

using SimTK::Mat44;
using SimTK::Vec3;

namespace {

void checkProperties(const UniformBeam& beam) {
    const std::pair<const char*, double> positive[] = {{"length", beam.length},
                                                       {"number of elements", beam.elements},
                                                       {"youngsModulus", beam.youngsModulus},
                                                       {"shearModulus", beam.shearModulus},
                                                       {"density", beam.density},
                                                       {"area", beam.area},
                                                       {"secondMomentY", beam.secondMomentY},
                                                       {"secondMomentZ", beam.secondMomentZ},
                                                       {"torsionConstant", beam.torsionConstant}};
    const auto requireFinite = [](const char* name, double value) {
        if (std::isinf(value)) throw Error("beam", fmt::format("{} is {}; it must be finite", name, value));
    };
    for (const auto& [name, value] : positive) {
        requireFinite(name, value);
        if (!(value > 0)) throw Error("beam", fmt::format("{} is {}; it must be positive", name, value));
    }
    for (const auto& [name, value] :
         {std::pair("shearFactorY", beam.shearFactorY), std::pair("shearFactorZ", beam.shearFactorZ)}) {
        requireFinite(name, value);
        if (!(value >= 0)) throw Error("beam", fmt::format("{} is {}; it must not be negative", name, value));
    }
}

// Bending on (deflection, slope) at both ends of an element of length L, with phi = 12 EI / (kappa G A L^2).
Mat44 makeBendingStiffness(double EI, double phi, double L) {
    const double a = 4 + phi, b = 2 - phi;
    return EI / ((1 + phi) * L * L * L) *
           Mat44(12, 6 * L, -12, 6 * L,                //
                 6 * L, a * L * L, -6 * L, b * L * L,  //
                 -12, -6 * L, 12, -6 * L,              //
                 6 * L, b * L * L, -6 * L, a * L * L);
}

Mat44 makeBendingMass(double mass, double L) {
    return mass / 420 *
           Mat44(156, 22 * L, 54, -13 * L,               //
                 22 * L, 4 * L * L, 13 * L, -3 * L * L,  //
                 54, 13 * L, 156, -22 * L,               //
                 -13 * L, -3 * L * L, -22 * L, 4 * L * L);
}

/// Adds element matrices at their places in the structure's.
class Assembly {
public:
    explicit Assembly(std::vector<MatrixTerm>& terms) : m_terms(terms) {}

    // On one freedom of both nodes: factor * [diagonal, off; off, diagonal].
    void addPair(int node, int freedom, double diagonal, double off) {
        const int i = 6 * node + freedom, j = i + 6;
        m_terms.insert(m_terms.end(), {{i, i, diagonal}, {j, j, diagonal}, {i, j, off}, {j, i, off}});
    }

    // On (deflection, slope) of both nodes; the slope is the rotation or, in the xz plane, minus it.
    void addBending(int node, int deflection, int rotation, double slopeSign, const Mat44& matrix) {
        const int freedoms[] = {6 * node + deflection, 6 * node + rotation, 6 * node + 6 + deflection,
                                6 * node + 6 + rotation};
        const double signs[] = {1, slopeSign, 1, slopeSign};
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                m_terms.push_back({freedoms[i], freedoms[j], signs[i] * signs[j] * matrix(i, j)});
    }

private:
    std::vector<MatrixTerm>& m_terms;
};

enum Freedom { X, Y, Z, AboutX, AboutY, AboutZ };

}  // namespace

FiniteElementModel makeFiniteElementModel(const UniformBeam& beam) {
    checkProperties(beam);
    FiniteElementModel model;
    model.name = "beam";
    const double L = beam.length / beam.elements;
    for (int i = 0; i <= beam.elements; ++i) model.nodes.push_back({i + 1, Vec3(i * L, 0, 0)});

    const double EIy = beam.youngsModulus * beam.secondMomentY, EIz = beam.youngsModulus * beam.secondMomentZ;
    const auto calcPhi = [&](double EI, double factor) {
        return factor > 0 ? 12 * EI / (factor * beam.shearModulus * beam.area * L * L) : 0;
    };
    const double EA = beam.youngsModulus * beam.area, GJ = beam.shearModulus * beam.torsionConstant;
    const double mass = beam.density * beam.area * L;
    const double polar = beam.density * (beam.secondMomentY + beam.secondMomentZ) * L;
    const Mat44 Kxy = makeBendingStiffness(EIz, calcPhi(EIz, beam.shearFactorY), L);
    const Mat44 Kxz = makeBendingStiffness(EIy, calcPhi(EIy, beam.shearFactorZ), L);
    const Mat44 bendingMass = makeBendingMass(mass, L);

    Assembly stiffness(model.stiffness), inertia(model.mass);
    for (int node = 0; node < beam.elements; ++node) {
        stiffness.addPair(node, X, EA / L, -EA / L);
        stiffness.addPair(node, AboutX, GJ / L, -GJ / L);
        stiffness.addBending(node, Y, AboutZ, 1, Kxy);
        stiffness.addBending(node, Z, AboutY, -1, Kxz);
        inertia.addPair(node, X, mass / 3, mass / 6);
        inertia.addPair(node, AboutX, polar / 3, polar / 6);
        inertia.addBending(node, Y, AboutZ, 1, bendingMass);
        inertia.addBending(node, Z, AboutY, -1, bendingMass);
    }
    return model;
}

}  // namespace jprim
