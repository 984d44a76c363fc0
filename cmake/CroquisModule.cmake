# SPDX-License-Identifier: GPL-3.0-or-later

# croquis_module(NAME SOURCES file… [USES croquis::module…] [THIRD_PARTY target…] [SHOWS target…])
# One static library `croquis_NAME` with the alias `croquis::NAME`. A module that has public headers is installed with
# them, and projects outside find it by the same alias.
# USES: modules below this one. THIRD_PARTY: libraries that only its .cpp files see. SHOWS: libraries that its
# public headers include.
function(croquis_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES;THIRD_PARTY;SHOWS" ${ARGN})
  add_library(croquis_${name} STATIC ${arg_SOURCES})
  add_library(croquis::${name} ALIAS croquis_${name})
  target_include_directories(croquis_${name}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_compile_features(croquis_${name} PUBLIC cxx_std_20)
  target_link_libraries(croquis_${name}
    PUBLIC ${arg_USES} ${arg_SHOWS}
    PRIVATE $<BUILD_INTERFACE:croquis_compiler> ${arg_THIRD_PARTY})
  set_target_properties(croquis_${name} PROPERTIES EXPORT_NAME ${name})
  if(IS_DIRECTORY ${PROJECT_SOURCE_DIR}/include/croquis/${name})
    install(TARGETS croquis_${name} EXPORT croquis-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/croquis/${name} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/croquis)
  endif()
endfunction()

# croquis_test_program(TARGET): how test programs are compiled. They are built once and run for seconds, so compiling them
# quickly counts more than their speed; what they test keeps its own flags.
function(croquis_test_program target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  # The compiled headers fit programs and the target that keeps them only when both have the same flags.
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF UNITY_BUILD OFF)
  target_link_libraries(${target} PRIVATE croquis_compiler Catch2::Catch2)
endfunction()

# croquis_test(NAME SOURCES file… USES croquis::module… [THIRD_PARTY target…])
# One Catch2 program `test_NAME`; every case in it becomes a ctest case `NAME: case`.
function(croquis_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES;THIRD_PARTY" ${ARGN})
  add_executable(test_${name} ${arg_SOURCES})
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(test_${name} PRIVATE Catch2::Catch2WithMain ${arg_USES} ${arg_THIRD_PARTY})
  croquis_test_program(test_${name})
  target_precompile_headers(test_${name} REUSE_FROM croquis_test_headers)
  # Sanitizers and the large counts of a full run take up to twenty times as long as usual.
  catch_discover_tests(test_${name} TEST_PREFIX "${name}: " PROPERTIES TIMEOUT 600)
endfunction()
