# cmake -DSOURCE_DIR=.. -DVERSION=.. -DOUTPUT=.. -P WriteBuildHeader.cmake
# Without git, or outside a clone, the version is the project's own.
find_program(GIT git)
set(description)
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE_DIR} describe --always --dirty --tags
    OUTPUT_VARIABLE description OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(description)
  set(VERSION "${VERSION}-${description}")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#pragma once
#define GEON_BUILD_VERSION "@VERSION@"
#define GEON_SOURCE_TREE "@SOURCE_DIR@"
]])
