# cmake -D SOURCE=FILE -D PART=FILE -D VERSION=VERSION -D OUTPUT=FILE -P fill_in.cmake: the man page SOURCE with PART in place of
# its line @COMMAND_LINE@, and @VERSION@.
cmake_minimum_required(VERSION 3.25)
file(READ ${SOURCE} page)
file(READ ${PART} part)
string(REPLACE "@VERSION@" "${VERSION}" page "${page}")
string(FIND "${page}" "@COMMAND_LINE@\n" at)
if(at EQUAL -1)
  message(FATAL_ERROR "${SOURCE}: no line @COMMAND_LINE@")
endif()
string(REGEX REPLACE "\n+$" "\n" part "${part}")
string(REPLACE "@COMMAND_LINE@\n" "${part}" page "${page}")
file(WRITE ${OUTPUT} "${page}")
