// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl/shader_program.h"

#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include "render/gl/shader_sources.h"

namespace croquis::render {
namespace {

GLenum stage_of(std::string_view file, GLenum before) {
  if (file.ends_with(".glsl")) return before;
  if (file.ends_with(".vert")) return GL_VERTEX_SHADER;
  return file.ends_with(".geom") ? GL_GEOMETRY_SHADER : GL_FRAGMENT_SHADER;
}

std::string shader_log(GLuint shader) {
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  if (length > 0) glGetShaderInfoLog(shader, length, nullptr, log.data());
  return log.c_str();
}

std::string program_log(GLuint program) {
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  if (length > 0) glGetProgramInfoLog(program, length, nullptr, log.data());
  return log.c_str();
}

GlHandle compile(std::string_view file, GLenum stage) {
  const char* source = shader_source(file);
  if (source == nullptr) throw_gl_error("The shader " + std::string(file) + " is not part of the program.");
  GlHandle shader(glCreateShader(stage), [](unsigned name) { glDeleteShader(name); });
  glShaderSource(shader.name(), 1, &source, nullptr);
  glCompileShader(shader.name());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  throw_gl_error("The shader " + std::string(file) + " does not compile: " + shader_log(shader.name()));
}

}  // namespace

ShaderProgram::ShaderProgram(std::initializer_list<std::string_view> files)
    : program_(glCreateProgram(), [](unsigned name) { glDeleteProgram(name); }) {
  std::vector<GlHandle> shaders;
  GLenum stage = GL_VERTEX_SHADER;
  for (const std::string_view file : files) {
    stage = stage_of(file, stage);
    shaders.push_back(compile(file, stage));
    glAttachShader(program_.name(), shaders.back().name());
  }
  glLinkProgram(program_.name());
  GLint linked = GL_FALSE;
  glGetProgramiv(program_.name(), GL_LINK_STATUS, &linked);
  for (const GlHandle& shader : shaders) glDetachShader(program_.name(), shader.name());
  if (linked != GL_TRUE) {
    throw_gl_error("The shaders up to " + std::string(*(files.end() - 1)) +
                   " do not link: " + program_log(program_.name()));
  }
}

void ShaderProgram::use() const { glUseProgram(program_.name()); }

int ShaderProgram::location(const char* name) const { return glGetUniformLocation(program_.name(), name); }

void ShaderProgram::set(const char* name, bool value) const { glUniform1i(location(name), value ? 1 : 0); }
void ShaderProgram::set(const char* name, int value) const { glUniform1i(location(name), value); }
void ShaderProgram::set(const char* name, unsigned value) const { glUniform1ui(location(name), value); }
void ShaderProgram::set(const char* name, float value) const { glUniform1f(location(name), value); }
void ShaderProgram::set(const char* name, const glm::vec2& value) const {
  glUniform2fv(location(name), 1, glm::value_ptr(value));
}

void ShaderProgram::set(const char* name, const glm::vec3& value) const {
  glUniform3fv(location(name), 1, glm::value_ptr(value));
}

void ShaderProgram::set(const char* name, const glm::vec4& value) const {
  glUniform4fv(location(name), 1, glm::value_ptr(value));
}

void ShaderProgram::set(const char* name, const glm::ivec2& value) const {
  glUniform2iv(location(name), 1, glm::value_ptr(value));
}

void ShaderProgram::set(const char* name, const glm::mat3& value) const {
  glUniformMatrix3fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

void ShaderProgram::set(const char* name, const glm::mat4& value) const {
  glUniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

void ShaderProgram::set_texture(const char* name, int unit, const GlHandle& texture) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture.name());
  set(name, unit);
}

}  // namespace croquis::render
