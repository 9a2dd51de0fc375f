# cmake -D SOURCE=FOLDER -D NUMBER=VERSION -D OUTPUT=FILE -P write_version.cmake: writes the header with the version and the
# commit of the repository whose top is SOURCE. It is touched only if something has changed, so that nothing is compiled in vain.
find_program(git git)
set(commit)
if(git AND EXISTS ${SOURCE}/.git)
  # --exclude '*': no tag, however near. What git cannot or will not read is no commit.
  execute_process(COMMAND ${git} -C ${SOURCE} describe --always --dirty --abbrev=10 --exclude *
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#pragma once

namespace version {
inline constexpr const char* kNumber = "@NUMBER@";
inline constexpr const char* kCommit = "@commit@";
}  // namespace version
]])
