# With ccache, where it is installed: sources that another build of this project has compiled, in whatever folder, are not
# compiled again. AXISD_CCACHE=OFF leaves it out.
option(AXISD_CCACHE "Compile through ccache where it is installed" ON)
find_program(AXISD_CCACHE_PROGRAM ccache)
if(AXISD_CCACHE AND AXISD_CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Paths below the source tree count as relative ones; the two macros are what a precompiled header needs.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${AXISD_CCACHE_PROGRAM})
  set(CMAKE_C_COMPILER_LAUNCHER ${CMAKE_CXX_COMPILER_LAUNCHER})
endif()
