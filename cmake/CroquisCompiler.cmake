# SPDX-License-Identifier: GPL-3.0-or-later
# One language level, one set of warnings, one way to sanitize: for every target of the project.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

find_program(CROQUIS_CCACHE ccache)
if(CROQUIS_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CROQUIS_CCACHE})
endif()

add_library(croquis_compiler INTERFACE)
target_compile_options(croquis_compiler INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor)
# g++ 12 warns of overlaps inside std::string's own operator+ (GCC bug 105651).
target_compile_options(croquis_compiler INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# Results must not depend on whether the compiler contracts a*b+c: the same bytes on every machine.
target_compile_options(croquis_compiler INTERFACE -ffp-contract=off)

if(CROQUIS_SANITIZE)
  add_compile_options(-fsanitize=${CROQUIS_SANITIZE} -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${CROQUIS_SANITIZE})
endif()
