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
if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  # What counts is the opinion of g++: a release of clang that has others of its own keeps nothing from running.
  target_compile_options(axisd_options INTERFACE -Wno-error)
elseif(AXISD_FUZZ)
  message(FATAL_ERROR "AXISD_FUZZ needs clang++: scripts/fuzz.sh")
endif()
if(AXISD_SANITIZE OR AXISD_SANITIZE_THREADS)
  # The sanitizers' code keeps g++ from seeing that std::regex and others initialise what they copy.
  target_compile_options(axisd_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()
if(AXISD_SANITIZE)
  # Behind the rest, which it restricts: sources of tests are compiled a third faster without the second one. AXISD_EDGE:
  # what reads options and writes JSON is compiled twice as fast without optimisation and without what the second one says of
  # pointers, which is mostly what the first one says.
  target_compile_options(axisd_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
    $<$<BOOL:$<TARGET_PROPERTY:AXISD_TEST_SOURCES>>:-fno-sanitize=undefined>
    "$<$<BOOL:$<TARGET_PROPERTY:AXISD_EDGE>>:-O0;-fno-sanitize=null,alignment,object-size,vptr>")
  target_link_options(axisd_options INTERFACE -fsanitize=address,undefined)
endif()
if(AXISD_FUZZ AND NOT AXISD_SANITIZE)
  # Tools of the build are not the fuzzer: this runtime has what their libraries would count with.
  target_link_options(axisd_options INTERFACE -fsanitize=undefined)
endif()
if(AXISD_SANITIZE_THREADS)
  target_compile_options(axisd_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(axisd_options INTERFACE -fsanitize=thread)
endif()

# What makes a mistake in memory an end of the program and not the work of somebody else: for everything that is installed.
# Executables are position independent, addresses are bound at the start, stacks and buffers are watched where the compiler
# optimises (FORTIFY_SOURCE needs that), and what the processor offers against jumps to elsewhere is used.
#
# Two properties keep the price of it out of the cycle, where bench/callgrind.sh counts instructions. AXISD_NUMBERS_ONLY: a
# target that is given numbers and no bytes of anybody, so that its stacks need no watch. AXISD_IN_CYCLE: one that works in
# every cycle or frame; returns are protected there, which costs no instruction, and calls are not marked.
include(CheckCXXCompilerFlag)
include(CheckPIESupported)
check_pie_supported(LANGUAGES CXX C)
add_library(axisd_hardening INTERFACE)
if(NOT AXISD_SANITIZE AND NOT AXISD_SANITIZE_THREADS AND NOT AXISD_FUZZ)
  check_cxx_compiler_flag(-fstack-clash-protection AXISD_HAS_STACK_CLASH_PROTECTION)
  check_cxx_compiler_flag(-fcf-protection=full AXISD_HAS_CF_PROTECTION)
  target_compile_options(axisd_hardening INTERFACE
    $<$<NOT:$<BOOL:$<TARGET_PROPERTY:AXISD_NUMBERS_ONLY>>>:-fstack-protector-strong>
    $<$<BOOL:${AXISD_HAS_STACK_CLASH_PROTECTION}>:-fstack-clash-protection>
    $<$<BOOL:${AXISD_HAS_CF_PROTECTION}>:-fcf-protection=$<IF:$<BOOL:$<TARGET_PROPERTY:AXISD_IN_CYCLE>>,return,full>>)
  target_compile_options(axisd_hardening INTERFACE
    $<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:-U_FORTIFY_SOURCE> $<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:-D_FORTIFY_SOURCE=3>)
  target_link_options(axisd_hardening INTERFACE LINKER:-z,relro LINKER:-z,now)
endif()

# axisd_library(NAME SOURCE...): a static library with the options above.
function(axisd_library name)
  add_library(${name} STATIC ${ARGN})
  target_link_libraries(${name} PRIVATE axisd_options axisd_hardening)
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
endfunction()

# axisd_program(NAME SOURCE...): a program in build/<preset>/bin.
function(axisd_program name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE axisd_options axisd_hardening)
endfunction()
