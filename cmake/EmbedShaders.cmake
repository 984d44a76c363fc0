# SPDX-License-Identifier: GPL-3.0-or-later

# croquis_embed_shaders(OUTPUT file…)
# Writes one .cpp that holds the text of every shader as a C++ string and sets OUTPUT to its path, so that the library
# finds its shaders wherever it is installed. It is written again when a shader changes.
function(croquis_embed_shaders output)
  set(entries "")
  foreach(file IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    get_filename_component(name ${file} NAME)
    string(APPEND entries "  if (name == \"${name}\") return R\"shader(${text})shader\";\n")
  endforeach()
  set(path ${CMAKE_CURRENT_BINARY_DIR}/shader_sources.cpp)
  set(body "// SPDX-License-Identifier: GPL-3.0-or-later\n// Made by cmake/EmbedShaders.cmake from shaders/.\n")
  string(APPEND body "#include \"render/gl/shader_sources.h\"\n\nnamespace croquis::render {\n\n")
  string(APPEND body "const char* shader_source(std::string_view name) {\n${entries}  return nullptr;\n}\n\n}\n")
  file(CONFIGURE OUTPUT ${path} CONTENT "${body}" @ONLY)
  set(${output} ${path} PARENT_SCOPE)
endfunction()
