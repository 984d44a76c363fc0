// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/painters/line_lengths.h"

#include <algorithm>

namespace croquis::render {
namespace {

/// Takes corners to the screen, and segments as far as they are before the eye.
class Screen {
 public:
  Screen(const Shown<LineItem>& shown, const OverlayFrame& frame)
      : to_view_(item_to_view(shown, frame.view)),
        to_clip_(frame.view.to_clip),
        half_size_(0.5 * glm::dvec2(frame.size)),
        perspective_(frame.view.perspective) {}

  glm::dvec4 in_view(const LineCorner& corner) const { return to_view_ * glm::dvec4(glm::dvec3(corner.position), 1); }

  double length_of(glm::dvec4 a, glm::dvec4 b) const {
    if (perspective_ && !cut(a, b)) return 0;
    return glm::distance(place(a), place(b));
  }

 private:
  static bool cut(glm::dvec4& a, glm::dvec4& b) {
    const double inside_a = -a.z - nearest_overlay;
    const double inside_b = -b.z - nearest_overlay;
    if (std::max(inside_a, inside_b) <= 0) return false;
    if (inside_a < 0) a = glm::mix(a, b, inside_a / (inside_a - inside_b));
    if (inside_b < 0) b = glm::mix(b, a, inside_b / (inside_b - inside_a));
    return true;
  }

  glm::dvec2 place(const glm::dvec4& view) const {
    const glm::dvec4 clip = to_clip_ * view;
    return half_size_ * glm::dvec2(clip) / clip.w;
  }

  glm::dmat4 to_view_, to_clip_;
  glm::dvec2 half_size_;
  bool perspective_;
};

}  // namespace

std::vector<float> lengths_on_screen(const Shown<LineItem>& shown, const OverlayFrame& frame) {
  const Screen screen(shown, frame);
  const LineItem& item = *shown.item;
  std::vector<float> lengths(item.corners.size(), 0);
  double length = 0;
  glm::dvec4 previous(0);
  for (std::size_t i = 0; i < item.corners.size(); ++i) {
    const glm::dvec4 here = screen.in_view(item.corners[i]);
    const bool starts_line = i == 0 || item.corners[i - 1].width < 0;
    length = starts_line ? 0 : length + screen.length_of(previous, here);
    lengths[i] = static_cast<float>(length);
    previous = here;
  }
  return lengths;
}

}  // namespace croquis::render
