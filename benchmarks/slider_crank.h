// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_BENCHMARKS_SLIDER_CRANK_H_
#define JPRIM_BENCHMARKS_SLIDER_CRANK_H_

#include "jprim/jprim.h"

/// @file
/// A slider-crank, stretched at the start, whose crank turns steadily and whose rod is a beam of 20 modes.
namespace jprim::benchmarks {

constexpr double CrankRadius = 0.2, RodLength = 1;  // m
constexpr double CrankSpeed = 3;                    // rad/s
constexpr double SmallMass = 0.1;                   // of crank and slider [kg]
constexpr double SmallInertia = 1e-3;               // of crank and slider [kg m^2]

/// The rod, along x, its nodes numbered from 1 to RodEnd.
const ModalBasis& getRodBasis();
constexpr int RodEnd = 21;

/// The mechanism with the flexible rod, from a dataset.
Mechanism buildSliderCrank();
constexpr int MiddleOfRod = 32;  // a marker

}  // namespace jprim::benchmarks

#endif
