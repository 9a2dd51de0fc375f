# What `cmake --install BUILD --component libcanopen` installs: headers, libraries, and what find_package() and
# pkg-config look for. Everything in it is found relative to where it lies, so the prefix can be moved.
include(CMakePackageConfigHelpers)
# In packages of Debian what programs need lies apart from what their makers need.
set(runtime libcanopen)
set(development libcanopen)
if(AXISD_PACKAGES)
  set(runtime libcanopen0)
  set(development libcanopen-dev)
endif()
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/libcanopen)

install(TARGETS canopen canopen_shared EXPORT libcanopen-targets
  ARCHIVE COMPONENT ${development}
  LIBRARY COMPONENT ${runtime} NAMELINK_COMPONENT ${development})
# The headers for users and for those who write services; the others are the library's own.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS package/headers.txt)
file(STRINGS package/headers.txt headers)
foreach(header IN LISTS headers)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/libcanopen/${folder} COMPONENT ${development})
endforeach()
install(EXPORT libcanopen-targets NAMESPACE libcanopen:: DESTINATION ${config_dir} COMPONENT ${development})

configure_package_config_file(package/libcanopen-config.cmake.in libcanopen-config.cmake
  INSTALL_DESTINATION ${config_dir} NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
# While the major version is 0, a minor version may change the interface.
write_basic_package_version_file(libcanopen-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/libcanopen-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/libcanopen-config-version.cmake DESTINATION ${config_dir} COMPONENT ${development})

file(RELATIVE_PATH prefix_from_pc ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" prefix_from_pc ${prefix_from_pc})
configure_file(package/libcanopen.pc.in libcanopen.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/libcanopen.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT ${development})
