// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_STEEL_BEAM_H_
#define JPRIM_TESTS_SUPPORT_STEEL_BEAM_H_

#include "jprim/flexible/beam.h"

namespace jprim::testing {

/// A beam of 2 m in SI, no two of whose properties are equal.
inline UniformBeam makeSteelBeam(int elements) {
    UniformBeam beam;
    beam.length = 2;
    beam.elements = elements;
    beam.youngsModulus = 2.1e11;
    beam.shearModulus = 8e10;
    beam.density = 7850;
    beam.area = 6e-4;
    beam.secondMomentY = 2e-8;
    beam.secondMomentZ = 4.5e-8;
    beam.torsionConstant = 5e-8;
    return beam;
}

}  // namespace jprim::testing

#endif
