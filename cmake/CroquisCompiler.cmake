# SPDX-License-Identifier: GPL-3.0-or-later
# One language level, one set of warnings, one way to sanitize: for every target of the project.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

find_program(CROQUIS_CCACHE ccache)
if(CROQUIS_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Without this, nothing that reads compiled headers is ever found in the cache.
  set(CMAKE_CXX_COMPILER_LAUNCHER
    ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CROQUIS_CCACHE})
endif()

# Warnings stop what checks the project, not what only builds it: other compilers may warn of more.
option(CROQUIS_WARNINGS_AS_ERRORS "Stop at the first warning" OFF)
set(CMAKE_COMPILE_WARNING_AS_ERROR ${CROQUIS_WARNINGS_AS_ERRORS})

add_library(croquis_compiler INTERFACE)
target_compile_options(croquis_compiler INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor)
# g++ 12 warns of overlaps inside std::string's own operator+ (GCC bug 105651).
target_compile_options(croquis_compiler INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# Sources that are joined for compiling look like headers to g++, which may have no fields of types of their own.
target_compile_options(croquis_compiler INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
# Results must not depend on whether the compiler contracts a*b+c: the same bytes on every machine.
target_compile_options(croquis_compiler INTERFACE -ffp-contract=off)

option(CROQUIS_QUICK_LINKER "Link with mold where it is installed" OFF)
find_program(CROQUIS_MOLD mold)
if(CROQUIS_QUICK_LINKER AND CROQUIS_MOLD)
  add_link_options(-fuse-ld=mold)
endif()

if(CROQUIS_SANITIZE)
  add_compile_options(-fsanitize=${CROQUIS_SANITIZE} -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${CROQUIS_SANITIZE})
endif()
