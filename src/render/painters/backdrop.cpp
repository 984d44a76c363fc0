// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/painters/backdrop.h"

#include <algorithm>
#include <array>
#include <cmath>

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

using Places = std::vector<glm::dvec3>;

/// The letters x, y, z in a square of half side 1.
const std::array<std::vector<Places>, 3>& letters() {
  static const std::array<std::vector<Places>, 3> strokes = {{
      {{{-0.8, -1, 0}, {0.8, 1, 0}}, {{-0.8, 1, 0}, {0.8, -1, 0}}},
      {{{-0.8, 1, 0}, {0, 0, 0}, {0.8, 1, 0}}, {{0, 0, 0}, {0, -1, 0}}},
      {{{-0.8, 1, 0}, {0.8, 1, 0}, {-0.8, -1, 0}, {0.8, -1, 0}}},
  }};
  return strokes;
}

LineItemPtr letter(std::size_t axis, const glm::dvec3& middle, double half_height, const LineStyle& style) {
  std::vector<LinePath> lines;
  for (Places places : letters()[axis]) {
    for (glm::dvec3& place : places) place = middle + half_height * place;
    lines.push_back(line_through(places));
  }
  return make_line_item(lines, style);
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

std::vector<Shown<LineItem>> axis_cross(const RenderOptions& options, const ViewFrame& view) {
  const AxisCrossOptions& cross = options.axis_cross;
  const double size = cross.size * options.pixel_ratio;
  const double letter_height = 4 * options.pixel_ratio;
  const glm::dvec3 middle(size + 4 * letter_height, size + 4 * letter_height, 0);
  std::array<std::size_t, 3> order = {0, 1, 2};
  const auto in_view = [&](std::size_t axis) { return glm::dmat3(view.model_to_view) * cross.axes[axis] * view.unit; };
  const auto away = [&](std::size_t axis) { return in_view(axis).z; };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return away(a) < away(b); });
  std::vector<Shown<LineItem>> lines;
  for (const std::size_t axis : order) {
    const glm::dvec3 direction(in_view(axis).x, in_view(axis).y, 0);
    LineStyle style{2, cross.colors[axis], cross.dashes[axis], LineDepth::OnTop};
    lines.emplace_back(make_line_item(line_through(Places{middle, middle + size * direction}), style));
    style.width = 1.5;
    style.dash = {};
    lines.emplace_back(letter(axis, middle + (size + 2.2 * letter_height) * direction, letter_height, style));
  }
  return lines;
}

OverlayFrame pixel_frame(const OverlayFrame& frame) {
  OverlayFrame pixels = frame;
  pixels.surfaces = nullptr;
  pixels.view.perspective = false;
  pixels.view.unit = 1;
  pixels.view.model_to_view = glm::dmat4(1);
  const glm::dvec3 corner(frame.view.crop.left, frame.view.crop.bottom, 0);
  const glm::dmat4 to_share = glm::scale(glm::dmat4(1), glm::dvec3(2.0 / glm::dvec2(frame.size), 1));
  pixels.view.to_clip =
      glm::mat4(glm::translate(glm::dmat4(1), glm::dvec3(-1, -1, 0)) * glm::translate(to_share, -corner));
  return pixels;
}

}  // namespace croquis::render
