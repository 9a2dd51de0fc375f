# Most of the time to compile a small source goes into the headers that it includes. With AXISD_FAST_COMPILE, which builds of
# the whole have, sources of a folder are therefore compiled several at a time, and the headers of the largest folders once.
# That hides an include that a source lacks: the debug build and clang-tidy, which have each source by itself, show it.
option(AXISD_FAST_COMPILE "Precompile headers, and compile sources of a folder several at a time" OFF)

# lld links in a third of the time. What is installed is linked as everything else of its system.
find_program(AXISD_LLD ld.lld)
if(AXISD_SANITIZE AND AXISD_LLD)
  add_link_options(-fuse-ld=lld)
endif()

# axisd_precompile(TARGET HEADER): HEADER, named relative to the top of the tree, is one that most sources of TARGET include.
function(axisd_precompile target header)
  if(AXISD_FAST_COMPILE)
    target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/${header})
  endif()
endfunction()

set(AXISD_UNITED 12)  # how many at most: with more of them the last file of a program has the compiler for itself

# axisd_write_united(FILE SOURCE...): writes the sources, named relative to the top of the tree, one after the other into FILE.
#
# All that a source of tests has is in unnamed namespaces. Each of these gets a namespace of its source around it, so that
# names of one source are unknown in the next. Lines keep their numbers, and the compiler names the source, not FILE.
function(axisd_write_united file)
  set(text "")
  foreach(source IN LISTS ARGN)
    file(READ ${PROJECT_SOURCE_DIR}/${source} lines)
    cmake_path(GET source STEM stem)
    string(MAKE_C_IDENTIFIER "within_${stem}" own)
    string(REPLACE "\nnamespace {\n" "\nnamespace ${own} { namespace {\n" lines "\n${lines}")
    string(REPLACE "\n}  // namespace\n" "\n}}  // namespace\n" lines "${lines}")
    string(APPEND text "#line 1 \"${source}\"${lines}")
  endforeach()
  set(former "")
  if(EXISTS ${file})
    file(READ ${file} former)
  endif()
  if(NOT text STREQUAL former)  # a file that is written anew is compiled anew
    file(WRITE ${file} "${text}")
  endif()
endfunction()

# axisd_unite(TARGET RESULT SOURCE...): what TARGET is to be made of instead of SOURCE...: files that hold several *_test.cpp
# each, and the others as they are. Without AXISD_FAST_COMPILE all as they are.
function(axisd_unite target result)
  set(tests ${ARGN})
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  list(LENGTH tests count)
  if(NOT AXISD_FAST_COMPILE OR count LESS 2)
    set(${result} ${ARGN} PARENT_SCOPE)
    return()
  endif()
  set(united ${ARGN})
  list(FILTER united EXCLUDE REGEX "_test\\.cpp$")
  # Equal shares: 13 are 7 and 6, not 12 and 1.
  math(EXPR files "(${count} + ${AXISD_UNITED} - 1) / ${AXISD_UNITED}")
  math(EXPR share "(${count} + ${files} - 1) / ${files}")
  set(begin 0)
  while(begin LESS count)
    list(SUBLIST tests ${begin} ${share} some)
    set(sources)
    foreach(source IN LISTS some)
      cmake_path(ABSOLUTE_PATH source NORMALIZE)
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
      cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
      list(APPEND sources ${source})
    endforeach()
    set(file ${CMAKE_CURRENT_BINARY_DIR}/united/${target}_${begin}.cpp)
    axisd_write_united(${file} ${sources})
    list(APPEND united ${file})
    math(EXPR begin "${begin} + ${share}")
  endwhile()
  set(${result} ${united} PARENT_SCOPE)
endfunction()

# Sources with names in their unnamed namespaces that others of their folder have, too; coroutines with types of their own.
set(AXISD_ALONE
  axis_parameters.cpp bash_script.cpp completion.cpp fault_table.cpp fish_script.cpp inertia_test.cpp leader.cpp link_monitor.cpp lint_command.cpp magnet_flux_test.cpp
  make_commands.cpp many_messages.cpp module_rules.cpp motor_file.cpp node_guarding.cpp object_reader.cpp
  parameter_reader.cpp plant_step.cpp predefined_connections.cpp provocation.cpp rotor_test.cpp
  runner_aftercare.cpp saturation_test.cpp script_tables.cpp sdo_match.cpp socket_can.cpp standard_rules.cpp standard_wiring.cpp
  standstill_measurement.cpp start_hub.cpp status_printer.cpp stopping.cpp table_writer.cpp voltage_frequency.cpp watch_command.cpp zsh_script.cpp
  "[a-z_]*_checks.cpp" "[a-z_]*_reasons.cpp" "[a-z_]*_slaves.cpp")
list(JOIN AXISD_ALONE "|" AXISD_ALONE)

# axisd_unite_folders(TARGET...): the sources that a target has in one folder are compiled as one, with AXISD_FAST_COMPILE.
# What works in every cycle or frame stays as it is where it is optimised: what is inlined where does not depend on this.
function(axisd_unite_folders)
  foreach(target IN LISTS ARGN)
    get_target_property(in_cycle ${target} AXISD_IN_CYCLE)
    if(in_cycle AND NOT AXISD_SANITIZE)
      continue()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    get_target_property(folder ${target} SOURCE_DIR)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
      if(source MATCHES "\\.cpp$" AND NOT source MATCHES "(^|/)(${AXISD_ALONE})$")
        cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${folder} NORMALIZE)
        cmake_path(GET source PARENT_PATH group)
        cmake_path(RELATIVE_PATH group BASE_DIRECTORY ${folder})
        string(MAKE_C_IDENTIFIER "folder_${group}" group)
        set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group})
      endif()
    endforeach()
  endforeach()
endfunction()

# axisd_targets_below(RESULT FOLDER): every library and program that FOLDER and the folders below it make.
function(axisd_targets_below result folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(NOT type MATCHES "^(STATIC_LIBRARY|SHARED_LIBRARY|OBJECT_LIBRARY|EXECUTABLE)$")
      list(REMOVE_ITEM targets ${target})
    endif()
  endforeach()
  get_property(below DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(each IN LISTS below)
    axisd_targets_below(more ${each})
    list(APPEND targets ${more})
  endforeach()
  set(${result} ${targets} PARENT_SCOPE)
endfunction()
