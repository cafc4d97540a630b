// SPDX-License-Identifier: Apache-2.0
#include "mechanism/check_axes.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"

namespace jprim {

using SimTK::Real;
using SimTK::Rotation;

namespace {

// What the given orientations of I and J must be like for the type to assemble as meant.
enum class Need { Nothing, ZAxesAlike, AllAxesAlike, ZAxesCrossed, BarsCrossed };

Need getNeed(JprimType type) {
    switch (type) {
        case JprimType::ParallelAxes: return Need::ZAxesAlike;
        case JprimType::Orientation: return Need::AllAxesAlike;
        case JprimType::Perpendicular: return Need::ZAxesCrossed;
        default: return Need::Nothing;
    }
}

Need getNeed(JointType type) {
    switch (type) {
        case JointType::Revolute:
        case JointType::Cylindrical:
        case JointType::Planar: return Need::ZAxesAlike;
        case JointType::Translational:
        case JointType::Fixed: return Need::AllAxesAlike;
        case JointType::Rackpin:
        case JointType::Universal: return Need::ZAxesCrossed;
        case JointType::Hooke: return Need::BarsCrossed;
        default: return Need::Nothing;
    }
}

// Axes that should be alike, given nearer to opposite.
std::string describeFlip(const char* axes, Real angle, int i, int j) {
    if (angle <= SimTK::Pi / 2) return "";
    return fmt::format(
        "the {} of I={} and J={} are {:.4g} degrees apart, nearer to opposite than to equal; turn one "
        "of the markers so that they point the same way",
        axes, i, j, angle * SimTK_RADIAN_TO_DEGREE);
}

// Axes that should be perpendicular, given parallel: there is no telling which way to turn them.
std::string describeParallel(const char* axisI, const char* axisJ, Real cosine, int i, int j) {
    constexpr Real Parallel = 1 - 1e-6;
    if (std::abs(cosine) < Parallel) return "";
    return fmt::format(
        "the {} axis of I={} and the {} axis of J={} must be perpendicular but are parallel; turn one "
        "of the markers",
        axisI, i, axisJ, j);
}

std::string findMisalignment(Need need, const Rotation& R_GI, const Rotation& R_GJ, int i, int j) {
    const Rotation R = ~R_GJ * R_GI;
    switch (need) {
        case Need::ZAxesAlike: return describeFlip("z axes", std::acos(std::clamp(R.z()[2], -1., 1.)), i, j);
        case Need::AllAxesAlike:
            return describeFlip("axes", std::abs(R.convertRotationToAngleAxis()[0]), i, j);
        case Need::ZAxesCrossed: return describeParallel("z", "z", R.z()[2], i, j);
        case Need::BarsCrossed: return describeParallel("x", "y", R.x()[1], i, j);
        case Need::Nothing: break;
    }
    return "";
}

}  // namespace

void checkAxes(const Dataset& dataset, const GivenPoses& poses, Reporter& reporter) {
    const auto check = [&](const auto& statements, const char* keyword) {
        for (const auto& s : statements) {
            if (!poses.isDefined(s.i) || !poses.isDefined(s.j)) continue;
            const std::string problem =
                findMisalignment(getNeed(s.type), poses.getPose(s.i).R(), poses.getPose(s.j).R(), s.i, s.j);
            if (!problem.empty())
                reporter.addError(s.where,
                                  fmt::format("{}/{} {}: {}", keyword, s.id, getAdamsName(s.type), problem));
        }
    };
    check(dataset.jprims, "JPRIM");
    check(dataset.joints, "JOINT");
}

}  // namespace jprim
