# SPDX-License-Identifier: Apache-2.0
# Before Simbody 3.8 the size of SimTK::StateImpl depends on NDEBUG, so a program compiled with NDEBUG
# crashes on a Simbody library that was compiled without it (Debian's is). CMake's Release and
# RelWithDebInfo add -DNDEBUG; this asks jprim and its users to take it back, for those libraries only. Whom the
# option does not reach, jprim/simbody_abi.h stops.
set(JPRIM_SIMBODY_ABI_OPTIONS "")
set(JPRIM_SIMBODY_FORBIDS_NDEBUG 0)
if(Simbody_VERSION VERSION_LESS 3.8)
  get_target_property(simbody_configurations SimTKsimbody IMPORTED_CONFIGURATIONS)
  if(NOT "${simbody_configurations}" MATCHES "RELEASE|RELWITHDEBINFO|MINSIZEREL")
    set(JPRIM_SIMBODY_ABI_OPTIONS -UNDEBUG)
    set(JPRIM_SIMBODY_FORBIDS_NDEBUG 1)
  endif()
endif()
