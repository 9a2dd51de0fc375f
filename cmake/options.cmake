# Language level, warnings and sanitizers of every target of the project.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

add_library(axisd_options INTERFACE)
target_compile_options(axisd_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Werror
  $<$<COMPILE_LANGUAGE:CXX>:-Wconversion -Wsign-conversion -Wdouble-promotion -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual>)
target_include_directories(axisd_options INTERFACE ${PROJECT_SOURCE_DIR})
if(AXISD_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    message(FATAL_ERROR "AXISD_FUZZ needs clang++: scripts/fuzz.sh")
  endif()
endif()
if(AXISD_SANITIZE)
  # The sanitizers' code keeps g++ from seeing that std::regex initialises what it copies.
  target_compile_options(axisd_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  # Behind the rest, which it restricts: sources of tests are compiled a third faster without the second one.
  target_compile_options(axisd_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
    $<$<BOOL:$<TARGET_PROPERTY:AXISD_TEST_SOURCES>>:-fno-sanitize=undefined>)
  target_link_options(axisd_options INTERFACE -fsanitize=address,undefined)
endif()

# axisd_library(NAME SOURCE...): a static library with the options above.
function(axisd_library name)
  add_library(${name} STATIC ${ARGN})
  target_link_libraries(${name} PRIVATE axisd_options)
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
endfunction()

# axisd_program(NAME SOURCE...): a program in build/<preset>/bin.
function(axisd_program name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE axisd_options)
endfunction()
