# SPDX-License-Identifier: Apache-2.0
# Writes a line JPRIM_PUBLIC_TYPE(Name) for each type that the headers in INCLUDE declare at the beginning of a line, but
# for templates (Typed...) and for what is declared without being defined.
function(write_public_types include output)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${include}/*.h)
  set(names "")
  foreach(header ${headers})
    file(STRINGS ${header} lines REGEX "^(class|struct|enum class|using) [A-Za-z0-9]+ [:{=]")
    foreach(line ${lines})
      string(REGEX REPLACE "^(class|struct|enum class|using) ([A-Za-z0-9]+) .*" "\\2" name "${line}")
      list(APPEND names ${name})
    endforeach()
  endforeach()
  list(FILTER names EXCLUDE REGEX "^Typed")
  list(TRANSFORM names REPLACE "(.+)" "JPRIM_PUBLIC_TYPE(\\1)\n")
  list(JOIN names "" text)
  file(CONFIGURE OUTPUT ${output} CONTENT "${text}" @ONLY)
endfunction()
