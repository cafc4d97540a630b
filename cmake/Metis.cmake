# SPDX-License-Identifier: Apache-2.0
# METIS orders the matrices of large meshes. Whoever links a static jprim links it too, by the name that the library
# has without its development files: those are needed to build jprim, not to use it.
find_library(JPRIM_METIS_LIBRARY NAMES libmetis.so.5 metis DOC "METIS's library")
mark_as_advanced(JPRIM_METIS_LIBRARY)
if(JPRIM_METIS_LIBRARY AND NOT TARGET jprim::metis)
  add_library(jprim::metis UNKNOWN IMPORTED GLOBAL)
  set_target_properties(jprim::metis PROPERTIES IMPORTED_LOCATION ${JPRIM_METIS_LIBRARY})
endif()
