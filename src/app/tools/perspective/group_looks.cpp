// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/perspective/group_looks.h"

#include <QObject>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr double bad_px = 6;  // a line that misses by so much is darkest red

std::vector<std::vector<Vec2>> letter(int axis) {
  if (axis == 0) return {{{-0.3, -0.4}, {0.3, 0.4}}, {{-0.3, 0.4}, {0.3, -0.4}}};
  if (axis == 1) return {{{-0.3, 0.4}, {0, 0}, {0.3, 0.4}}, {{0, 0}, {0, -0.4}}};
  return {{{-0.3, 0.4}, {0.3, 0.4}, {-0.3, -0.4}, {0.3, -0.4}}};
}

}  // namespace

QColor group_color(StrokeGroup group) {
  static const std::array<QColor, 7> made{QColor(0xF2, 0x8C, 0x00), QColor(0x1F, 0x9D, 0x3A), QColor(0x8A, 0x2B, 0xE2),
                                          QColor(0x1F, 0x4F, 0xD8), QColor(0xD8, 0x1F, 0x2A), QColor(0xC8, 0xA0, 0x00),
                                          QColor(0x70, 0x74, 0x7C)};
  return made[static_cast<std::size_t>(group)];
}

render::DashPattern group_dashes(StrokeGroup group) {
  switch (group) {
    case StrokeGroup::ParallelY: return {14, 5, 0, 0};
    case StrokeGroup::ParallelZ: return {14, 4, 1, 4};
    case StrokeGroup::NormalX: return {24, 3, 0, 0};
    case StrokeGroup::NormalY: return {8, 4, 0, 0};
    case StrokeGroup::NormalZ: return {1, 5, 0, 0};
    default: return {};
  }
}

QString group_letter(StrokeGroup group) {
  if (group == StrokeGroup::Unknown) return QStringLiteral("?");
  const QString axis(QStringLiteral("xyz").at(axis_of(group)));
  return is_parallel(group) ? axis : QStringLiteral("⊥") + axis;
}

/// Of a box whose x runs to the right: the faces across x, y and z.
QString group_words(StrokeGroup group) {
  const std::array<QString, 3> faces{QObject::tr("left"), QObject::tr("right"), QObject::tr("top")};
  const bool is_face = group != StrokeGroup::Unknown && !is_parallel(group);
  return is_face ? faces[static_cast<std::size_t>(axis_of(group))] : group_letter(group);
}

QString group_title(StrokeGroup group) {
  if (group == StrokeGroup::Unknown) return QObject::tr("By where it points");
  const QString axis(QStringLiteral("xyz").at(axis_of(group)));
  return is_parallel(group) ? QObject::tr("Parallel to %1").arg(axis)
                            : QObject::tr("In a plane across %1, on a %2 face").arg(axis, group_words(group));
}

std::vector<std::vector<Vec2>> group_glyph(StrokeGroup group) {
  if (group == StrokeGroup::Unknown)
    return {{{-0.25, 0.2}, {-0.1, 0.4}, {0.2, 0.35}, {0.2, 0.1}, {0, -0.05}, {0, -0.2}}, {{0, -0.38}, {0, -0.42}}};
  auto glyph = letter(axis_of(group));
  if (!is_parallel(group)) glyph.push_back({{-0.6, -0.7}, {0.6, -0.7}, {0.6, 0.7}, {-0.6, 0.7}, {-0.6, -0.7}});
  return glyph;
}

/// Lightness falls evenly, so that the order is seen with any colour vision.
QColor residual_color(double px) {
  static const std::array<QColor, 4> scale{QColor(0xFF, 0xE0, 0x8A), QColor(0xFD, 0xA9, 0x4B), QColor(0xE0, 0x4B, 0x2F),
                                           QColor(0x8B, 0x10, 0x2B)};
  const double place = std::clamp(px / bad_px, 0.0, 1.0) * static_cast<double>(scale.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), scale.size() - 2);
  const double share = place - static_cast<double>(i);
  const auto mix = [&](int a, int b) { return static_cast<int>(std::lround(a + share * (b - a))); };
  const QColor &low = scale[i], &high = scale[i + 1];
  return {mix(low.red(), high.red()), mix(low.green(), high.green()), mix(low.blue(), high.blue())};
}

}  // namespace croquis::app
