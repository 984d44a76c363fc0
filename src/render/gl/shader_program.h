// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string_view>

#include <glm/glm.hpp>

#include "render/gl/gl_handle.h"

namespace croquis::render {

/// A linked program of shaders from shaders/, with its uniforms by name.
class ShaderProgram {
 public:
  /// @param files names in shaders/; the extension (.vert, .geom, .frag) gives the stage, a .glsl file belongs to the
  ///        stage of the file before it
  /// @throws Error (E_GL) with the driver's message when one does not compile or they do not link
  explicit ShaderProgram(std::initializer_list<std::string_view> files);

  void use() const;

  // The program must be in use. Names that the compiler found unused are ignored.
  void set(const char* name, bool value) const;
  void set(const char* name, int value) const;
  void set(const char* name, unsigned value) const;
  void set(const char* name, float value) const;
  void set(const char* name, const glm::vec2& value) const;
  void set(const char* name, const glm::vec3& value) const;
  void set(const char* name, const glm::vec4& value) const;
  void set(const char* name, const glm::ivec2& value) const;
  void set(const char* name, const glm::mat3& value) const;
  void set(const char* name, const glm::mat4& value) const;

  /// Binds a texture to a unit and the sampler of that name to it.
  void set_texture(const char* name, int unit, const GlHandle& texture) const;

 private:
  int location(const char* name) const;

  GlHandle program_;
};

}  // namespace croquis::render
