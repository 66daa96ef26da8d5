# Headers that nearly every file parses, parsed once: the standard library's and Eigen's for the rooms and
# programs, GoogleTest's on top for the tests. Files still include what they use.
set(geon_common_headers <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <optional>
  <span> <string> <string_view> <vector> <Eigen/Core> <Eigen/Geometry>)
# Written when it changes only: all that is compiled depends on it.
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cc CONTENT "")
add_library(geon_precompiled STATIC ${CMAKE_BINARY_DIR}/precompiled.cc)
target_link_libraries(geon_precompiled PRIVATE geon_compiler Eigen3::Eigen)
target_precompile_headers(geon_precompiled PRIVATE ${geon_common_headers})
add_library(geon_precompiled_test STATIC ${CMAKE_BINARY_DIR}/precompiled.cc)
target_link_libraries(geon_precompiled_test PRIVATE geon_compiler Eigen3::Eigen GTest::gtest
  GTest::gmock)
target_precompile_headers(geon_precompiled_test PRIVATE ${geon_common_headers} <gtest/gtest.h>
  <gmock/gmock.h>)
set(geon_test_options "")
if(GEON_SANITIZE MATCHES "address")
  # GoogleTest's macros are full of temporaries: watching their scopes costs a quarter of the tests' build time.
  set(geon_test_options -fno-sanitize-address-use-after-scope)
endif()
target_compile_options(geon_precompiled_test PRIVATE ${geon_test_options})

# Two groups to build: what runs, and the unit tests.
add_custom_target(programs)
add_custom_target(unit_tests)

# geon_room(NAME DEPENDS room... LINK target...)
#   A room of common/: a static library of its *.cc and the unit tests tests/common/NAME/*_test.cc.
#   DEPENDS lists rooms (architecture.md's table, checked by tests/architecture), LINK other targets.
function(geon_room NAME)
  cmake_parse_arguments(ROOM "" "" "DEPENDS;LINK" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cc)
  list(TRANSFORM ROOM_DEPENDS PREPEND geon_ OUTPUT_VARIABLE rooms)
  if(sources)
    add_library(geon_${NAME} STATIC ${sources})
    target_include_directories(geon_${NAME} PUBLIC ${CMAKE_SOURCE_DIR}/common)
    target_link_libraries(geon_${NAME} PUBLIC ${rooms} ${ROOM_LINK} PRIVATE geon_compiler)
    target_precompile_headers(geon_${NAME} REUSE_FROM geon_precompiled)
  else()
    add_library(geon_${NAME} INTERFACE)
    target_include_directories(geon_${NAME} INTERFACE ${CMAKE_SOURCE_DIR}/common)
    target_link_libraries(geon_${NAME} INTERFACE ${rooms} ${ROOM_LINK})
  endif()
  geon_unit_tests(${NAME} ${CMAKE_SOURCE_DIR}/tests/common/${NAME} geon_${NAME})
endfunction()

# geon_unit_tests(NAME DIRECTORY target...)
#   One GoogleTest program test_NAME of DIRECTORY/*.cc (tests and their helpers). For ctest it is NAME, label
#   "unit"; in a build with sanitizers sanitized_NAME, label "sanitizer", so that scripts/test can run both builds' tests.
function(geon_unit_tests NAME DIRECTORY)
  file(GLOB tests CONFIGURE_DEPENDS ${DIRECTORY}/*.cc)
  if(NOT tests)
    return()
  endif()
  add_executable(test_${NAME} ${tests})
  target_include_directories(test_${NAME} PRIVATE ${CMAKE_SOURCE_DIR})
  target_precompile_headers(test_${NAME} REUSE_FROM geon_precompiled_test)
  target_compile_options(test_${NAME} PRIVATE ${geon_test_options})
  target_compile_definitions(test_${NAME} PRIVATE GEON_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  target_link_libraries(test_${NAME} PRIVATE ${ARGN} geon_compiler GTest::gtest GTest::gmock
    GTest::gtest_main)
  add_dependencies(unit_tests test_${NAME})
  if(GEON_SANITIZE)
    add_test(NAME sanitized_${NAME} COMMAND test_${NAME})
    set_tests_properties(sanitized_${NAME} PROPERTIES LABELS sanitizer TIMEOUT 900
      ENVIRONMENT "${GEON_SANITIZER_ENVIRONMENT}")
  else()
    add_test(NAME ${NAME} COMMAND test_${NAME})
    set_tests_properties(${NAME} PROPERTIES LABELS unit TIMEOUT 300)
  endif()
endfunction()

# geon_program(NAME LINK target... )
#   procs/<dir>: program NAME from main.cc; every other *.cc of the folder goes into a library
#   NAME-lib so that tests reach it; unit tests from tests/procs/<dir>/*_test.cc.
function(geon_program NAME)
  cmake_parse_arguments(PROG "" "" "LINK" ${ARGN})
  get_filename_component(dir ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cc)
  list(FILTER sources EXCLUDE REGEX "/main\\.cc$")
  add_executable(${NAME} main.cc)
  add_dependencies(programs ${NAME})
  target_include_directories(${NAME} PRIVATE ${CMAKE_SOURCE_DIR})
  if(sources)
    add_library(${NAME}-lib STATIC ${sources})
    target_include_directories(${NAME}-lib PUBLIC ${CMAKE_SOURCE_DIR})
    target_link_libraries(${NAME}-lib PUBLIC ${PROG_LINK} PRIVATE geon_compiler)
    target_precompile_headers(${NAME}-lib REUSE_FROM geon_precompiled)
    target_link_libraries(${NAME} PRIVATE ${NAME}-lib)
    set(tests_name ${dir})
    if(TARGET geon_${dir})  # a room of that name: test_base is the room's, test_geon-base the program's
      set(tests_name ${NAME})
    endif()
    geon_unit_tests(${tests_name} ${CMAKE_SOURCE_DIR}/tests/procs/${dir} ${NAME}-lib)
  endif()
  target_link_libraries(${NAME} PRIVATE ${PROG_LINK} geon_compiler)
endfunction()
