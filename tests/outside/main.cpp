// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a circle and makes a solid of it, with nothing but what Croquis installs.
#include <cmath>
#include <iostream>

#include <croquis/base/error.h>
#include <croquis/silhouette/labelled_figure.h>
#include <croquis/silhouette/solid.h>

int main() try {
  using namespace croquis;
  Stroke circle;
  circle.id = "circle";
  circle.closed = true;
  for (int i = 0; i < 64; ++i) {
    const double angle = 2 * 3.14159265358979 * i / 64;
    circle.samples.push_back({.position = Vec2(100 * std::cos(angle), 100 * std::sin(angle))});
  }
  const Drawing drawing{.strokes = {circle}, .object_data = {}, .file = "outside"};

  Progress progress;
  const silhouette::Options options;
  const auto labelled = silhouette::label(drawing, options, progress);
  const auto solid = silhouette::inflate(labelled, drawing, options, progress);
  const bool is_ball = solid.objects.size() == 1 && solid.objects[0].euler_mesh == 2;
  std::cout << "solids: " << solid.objects.size() << (is_ball ? ", a ball" : ", not a ball") << "\n";
  return is_ball ? 0 : 1;
} catch (const croquis::Error& error) {
  for (const croquis::Finding& finding : error.findings()) std::cerr << finding.code << ": " << finding.message << "\n";
  return 1;
}
