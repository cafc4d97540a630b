// SPDX-License-Identifier: Apache-2.0
#include "jprim/marker/typed_handle.h"

#include "base/format.h"
#include "jprim/base/error.h"

namespace jprim {

namespace {

[[noreturn]] void throwNotInstanceOf(const char* className, const std::string& element) {
    throw Error(element, fmt::format("is no {}; ask {}::isInstanceOf() first", className, className));
}

}  // namespace

void throwNotInstance(const SimTK::Constraint& constraint, const char* className) {
    const bool isKnown = !constraint.isEmptyHandle() && constraint.isInSubsystem();
    throwNotInstanceOf(className, isKnown ? fmt::format("constraint {}", int(constraint.getConstraintIndex()))
                                          : "constraint");
}

void throwNotInstance(const SimTK::Force& force, const char* className) {
    throwNotInstanceOf(className,
                       force.isEmptyHandle() ? "force" : fmt::format("force {}", int(force.getForceIndex())));
}

}  // namespace jprim
