# One target every library, program and test of ours links: the warnings we hold to, as errors, and
# the sanitizers of the preset. Third-party headers come in as SYSTEM and are not judged.
add_library(geon_compiler INTERFACE)
# Line tables are enough for a backtrace; full debug information costs a third of the build time.
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g1 -DNDEBUG")
target_compile_options(geon_compiler INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
  # x86-64 contracts nothing by default; said aloud because replay promises the same bits.
  -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 reports uninitialised reads inside Eigen and libstdc++ that are not there.
  target_compile_options(geon_compiler INTERFACE -Wno-maybe-uninitialized -Wno-stringop-overflow -Wno-stringop-overread
    -Wno-array-bounds -Wno-restrict)
endif()
if(GEON_SANITIZE)
  # Eigen's and the library's own assertions stay in.
  set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O1 -g1")
  # What Embree, OpenCV and glib keep until the process ends is no leak of ours.
  set(GEON_SANITIZER_ENVIRONMENT
    "ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1"
    "LSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/sanitizers/leaks.txt:print_suppressions=0"
    "UBSAN_OPTIONS=print_stacktrace=1")
  target_compile_options(geon_compiler INTERFACE -fsanitize=${GEON_SANITIZE}
    -fno-omit-frame-pointer -fno-sanitize-recover=all)
  if(GEON_SANITIZE MATCHES "address")
    # Bad pointers end in AddressSanitizer; asking before every access costs a third of the build time.
    target_compile_options(geon_compiler INTERFACE -fno-sanitize=null,alignment,object-size,vptr)
  endif()
  target_link_options(geon_compiler INTERFACE -fsanitize=${GEON_SANITIZE})
endif()
if(GEON_COVERAGE)
  target_compile_options(geon_compiler INTERFACE --coverage)
  target_link_options(geon_compiler INTERFACE --coverage)
endif()
if(GEON_FUZZ)
  target_compile_options(geon_compiler INTERFACE -fsanitize=fuzzer-no-link,address,undefined)
  target_link_options(geon_compiler INTERFACE -fsanitize=address,undefined)
endif()

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()
