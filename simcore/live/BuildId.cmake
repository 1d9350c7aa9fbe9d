# Writes OUT (a C++ source) with the build's name; touches it only when the name has changed.
# Called at build time: cmake -DOUT=… -DVERSION=… -DSOURCE=… -P BuildId.cmake
set(id "${VERSION}")
execute_process(COMMAND git -C "${SOURCE}" rev-parse --short=10 HEAD OUTPUT_VARIABLE commit
  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(NOT failed AND commit)
  string(APPEND id "+${commit}")
  execute_process(COMMAND git -C "${SOURCE}" diff --quiet HEAD -- RESULT_VARIABLE changed ERROR_QUIET OUTPUT_QUIET)
  if(changed)
    string(APPEND id "-changed")
  endif()
endif()
set(text "// Made by BuildId.cmake.
#include \"simcore/live/BuildId.h\"
namespace glenoid {
const char* buildId() { return \"${id}\"; }
const char* versionId() { return \"${VERSION}\"; }
}  // namespace glenoid
")
set(old "")
if(EXISTS "${OUT}")
  file(READ "${OUT}" old)
endif()
if(NOT old STREQUAL text)
  file(WRITE "${OUT}" "${text}")
endif()
