// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/painters/backdrop.h"

#include <algorithm>
#include <cmath>

#include "render/painters/drawing.h"

namespace croquis::render {
namespace {

constexpr double finest_step = 11;  ///< pixels between lines of the grid at which they have faded away
constexpr double steps_per_strong_step = 5;

/// The grid in pixels of the viewport.
struct Lattice {
  double step = 0;
  double fine_strength = 0;
  glm::dvec2 origin = glm::dvec2(0);
};

/// Steps grow by fives: a line's strength as a fine one reaches that of a strong one just when it becomes one.
Lattice lattice_of(const GridOptions& grid, const ViewFrame& view, double pixel_ratio) {
  const double pixels_per_unit = view.crop.picture_height / (view.picture_height * view.unit);
  const double least = finest_step * pixel_ratio;
  const double base = grid.spacing * pixels_per_unit;
  const double power = std::ceil(std::log(least / base) / std::log(steps_per_strong_step));
  Lattice lattice;
  lattice.step = base * std::pow(steps_per_strong_step, power);
  lattice.fine_strength = std::clamp(std::log(lattice.step / least) / std::log(steps_per_strong_step), 0.0, 1.0);
  const glm::dvec2 origin = glm::dvec2(view.model_to_view[3]) * view.unit * pixels_per_unit;
  const glm::dvec2 picture(view.crop.picture_width, view.crop.picture_height);
  lattice.origin = 0.5 * picture + origin - glm::dvec2(view.crop.left, view.crop.bottom);
  // Small numbers keep their fractions in the shader.
  const double strong = steps_per_strong_step * lattice.step;
  lattice.origin -= strong * glm::floor(lattice.origin / strong);
  return lattice;
}

}  // namespace

void set_backdrop(const ShaderProgram& program, const RenderOptions& options, const ViewFrame& view) {
  program.set("picture_rows", glm::vec2(view.crop.bottom, view.crop.picture_height));
  program.set("background_top", glm::vec3(to_float(options.background_top)));
  program.set("background_bottom", glm::vec3(to_float(options.background_bottom)));
  const bool shown = options.grid.kind != GridKind::None && !view.perspective && options.grid.spacing > 0;
  program.set("grid_kind", shown ? static_cast<int>(options.grid.kind) : 0);
  if (!shown) return;
  const Lattice lattice = lattice_of(options.grid, view, options.pixel_ratio);
  program.set("grid_color", to_float(options.grid.color));
  program.set("grid_step", static_cast<float>(lattice.step));
  program.set("grid_origin", glm::vec2(lattice.origin));
  program.set("grid_fine", static_cast<float>(lattice.fine_strength));
  program.set("grid_width", static_cast<float>(options.pixel_ratio));
}

}  // namespace croquis::render
