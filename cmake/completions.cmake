# axisd_completions(PROGRAM [BY TARGET] [COMPONENT COMPONENT]): the files with which bash, zsh and fish complete PROGRAM, as it
# writes them itself, or TARGET does, and their installation.
function(axisd_completions program)
  cmake_parse_arguments(COMPLETION "" "BY;COMPONENT" "" ${ARGN})
  if(NOT COMPLETION_BY)
    set(COMPLETION_BY ${program})
  endif()
  if(NOT COMPLETION_COMPONENT)
    set(COMPLETION_COMPONENT ${CMAKE_INSTALL_DEFAULT_COMPONENT_NAME})
  endif()
  set(files bash-completion/completions/${program} zsh/site-functions/_${program} fish/vendor_completions.d/${program}.fish)
  foreach(shell file IN ZIP_LISTS AXISD_SHELLS files)
    set(output ${PROJECT_BINARY_DIR}/share/${file})
    cmake_path(GET output PARENT_PATH folder)
    file(MAKE_DIRECTORY ${folder})
    add_custom_command(
      OUTPUT ${output}
      COMMAND ${COMPLETION_BY} --completion ${shell} > ${output}
      DEPENDS ${COMPLETION_BY}
      COMMENT "Writing the completion of ${program} for ${shell}"
      VERBATIM)
    list(APPEND outputs ${output})
    cmake_path(GET file PARENT_PATH destination)
    if(AXISD_PACKAGES AND shell STREQUAL zsh)
      set(destination zsh/vendor-completions)
    endif()
    install(FILES ${output} DESTINATION ${CMAKE_INSTALL_DATADIR}/${destination} COMPONENT ${COMPLETION_COMPONENT})
  endforeach()
  add_custom_target(completion_of_${program} ALL DEPENDS ${outputs})
  add_dependencies(completions completion_of_${program})
endfunction()
set(AXISD_SHELLS bash zsh fish)
add_custom_target(completions)
