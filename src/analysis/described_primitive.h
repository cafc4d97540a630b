// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_ANALYSIS_DESCRIBED_PRIMITIVE_H_
#define JPRIM_SRC_ANALYSIS_DESCRIBED_PRIMITIVE_H_

#include "primitive/primitive_impl.h"

namespace jprim {

/// Opens Simbody's handle of a Custom constraint, which shows its Implementation to derived classes only.
struct CustomHandle : SimTK::Constraint::Custom {
    explicit CustomHandle(const Custom& constraint) : Custom(constraint) {}
    using Custom::getImplementation;
};

/// The primitive that a constraint is, or null.
inline const PrimitiveImpl* findPrimitive(const SimTK::Constraint& constraint) {
    using Custom = SimTK::Constraint::Custom;
    if (!Custom::isInstanceOf(constraint)) return nullptr;
    return dynamic_cast<const PrimitiveImpl*>(
        &CustomHandle(Custom::downcast(constraint)).getImplementation());
}

}  // namespace jprim

#endif
