// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MARKER_CACHE_ENTRY_H_
#define JPRIM_SRC_MARKER_CACHE_ENTRY_H_

#include "SimTKcommon.h"

namespace jprim {

/// A cache entry that its constraint allocated itself, as a T, without SimTK's checked downcast and validity
/// test, which cost more than the few dot products they would guard: Simbody asks every constraint once per
/// multiplier of the whole system. Whether the value is up to date is for the owner to know.
template <class T>
T& updEntry(const SimTK::State& state, SimTK::SubsystemIndex subsystem, SimTK::CacheEntryIndex index) {
    return static_cast<SimTK::Value<T>&>(state.updCacheEntry(subsystem, index)).upd();
}

}  // namespace jprim

#endif
