# SPDX-License-Identifier: GPL-3.0-or-later

# croquis_module(NAME SOURCES file… [USES croquis::module…] [THIRD_PARTY target…] [SHOWS target…])
# One static library `croquis_NAME` with the alias `croquis::NAME`.
# USES: modules below this one. THIRD_PARTY: libraries that only its .cpp files see. SHOWS: libraries that its
# public headers include.
function(croquis_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES;THIRD_PARTY;SHOWS" ${ARGN})
  add_library(croquis_${name} STATIC ${arg_SOURCES})
  add_library(croquis::${name} ALIAS croquis_${name})
  target_include_directories(croquis_${name}
    PUBLIC ${PROJECT_SOURCE_DIR}/include
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(croquis_${name}
    PUBLIC ${arg_USES} ${arg_SHOWS}
    PRIVATE croquis_compiler ${arg_THIRD_PARTY})
endfunction()

# croquis_test(NAME SOURCES file… USES croquis::module… [THIRD_PARTY target…])
# One Catch2 program `test_NAME`; every case in it becomes a ctest case `NAME: case`.
function(croquis_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES;THIRD_PARTY" ${ARGN})
  add_executable(test_${name} ${arg_SOURCES})
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(test_${name} PRIVATE croquis_compiler croquis_test_main ${arg_USES} ${arg_THIRD_PARTY})
  set(timeout 120)
  if(CROQUIS_SANITIZE)  # everything takes up to twenty times as long
    set(timeout 600)
  endif()
  catch_discover_tests(test_${name} TEST_PREFIX "${name}: " PROPERTIES TIMEOUT ${timeout})
endfunction()
