// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MARKER_FIND_IMPLEMENTATION_H_
#define JPRIM_SRC_MARKER_FIND_IMPLEMENTATION_H_

#include "SimTKsimbody.h"

namespace jprim {

/// Opens the handle of a Custom constraint or force, which shows its Implementation to derived classes only.
template <class Custom>
struct OpenHandle : Custom {
    explicit OpenHandle(const Custom& handle) : Custom(handle) {}
    using Custom::getImplementation;
};

/// The Implementation of a SimTK::Constraint or Force, if it is a Custom one of this class; else null.
template <class Impl, class Handle>
const Impl* findImplementation(const Handle& handle) {
    using Custom = typename Handle::Custom;
    if (handle.isEmptyHandle() || !Custom::isInstanceOf(handle)) return nullptr;
    return dynamic_cast<const Impl*>(&OpenHandle<Custom>(Custom::downcast(handle)).getImplementation());
}

}  // namespace jprim

#endif
