// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/painters/drawing.h"

#include <algorithm>

#include "render/gl/shader_program.h"

namespace croquis::render {

glm::vec4 emphasis_color(const EmphasisOptions& options, const Emphasis& emphasis) {
  const glm::vec4 selected = to_float(options.selected);
  const glm::vec4 hovered = to_float(options.hovered);
  if (emphasis.selected && emphasis.hovered) return glm::mix(selected, hovered, 0.35F);
  if (emphasis.selected) return selected;
  return emphasis.hovered ? hovered : glm::vec4(0);
}

bool has_veil(const Scene& scene) { return std::any_of(scene.meshes.begin(), scene.meshes.end(), is_translucent); }

void set_visibility(const ShaderProgram& program, const OverlayFrame& frame, bool depth_tested) {
  const bool tested = depth_tested && frame.surfaces != nullptr;
  program.set("depth_tested", tested);
  if (!tested) return;
  program.set_texture("depths", 0, frame.surfaces->depths);
  program.set("samples", frame.surfaces->size.samples);
  program.set("border", frame.border);
  program.set("pixel_size", frame.view.picture_height / static_cast<float>(frame.view.crop.picture_height));
}

}  // namespace croquis::render
