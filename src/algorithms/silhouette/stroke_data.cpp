// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/silhouette/stroke_data.h"

#include <algorithm>
#include <array>
#include <utility>

#include "croquis/base/text.h"

namespace croquis::silhouette {
namespace {

constexpr std::array<std::pair<StrokeKind, std::string_view>, 10> kinds{{{StrokeKind::Visible, "visible"},
                                                                         {StrokeKind::Hidden, "hidden"},
                                                                         {StrokeKind::Contour, "contour"},
                                                                         {StrokeKind::Part, "part"},
                                                                         {StrokeKind::Hole, "hole"},
                                                                         {StrokeKind::Blob, "blob"},
                                                                         {StrokeKind::Detail, "detail"},
                                                                         {StrokeKind::Scribble, "scribble"},
                                                                         {StrokeKind::Tube, "tube"},
                                                                         {StrokeKind::Ignored, "ignored"}}};

constexpr std::array<std::pair<TubeEnds, std::string_view>, 3> end_shapes{
    {{TubeEnds::Round, "round"}, {TubeEnds::Flat, "flat"}, {TubeEnds::Pointed, "pointed"}}};

std::string_view without_spaces(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

std::vector<std::string_view> data_list(const Stroke& stroke, const char* key) {
  std::vector<std::string_view> list;
  const auto found = stroke.data.find(key);
  if (found == stroke.data.end()) return list;
  for (const std::string_view part : text_parts(found->second, ",")) {
    const std::string_view word = without_spaces(part);
    if (!word.empty()) list.push_back(word);
  }
  return list;
}

bool has_far_copy(const std::map<std::string, std::string>& data) {
  const auto found = data.find(copy_key);
  return found != data.end() && found->second == copy_far;
}

bool is_centre_line(const Stroke& stroke) {
  return stroke_kind(stroke) == StrokeKind::Tube && stroke.data.contains(radius_key);
}

std::optional<TubeEnds> tube_ends(std::string_view word) {
  for (const auto& [ends, text] : end_shapes) {
    if (word == text) return ends;
  }
  return std::nullopt;
}

std::vector<std::string_view> over_words(const Stroke& stroke) { return data_list(stroke, over_key); }

std::optional<StrokeKind> stroke_kind(const Stroke& stroke) {
  const auto found = stroke.data.find(kind_key);
  return found == stroke.data.end() ? StrokeKind::Visible : stroke_kind(found->second);
}

std::optional<StrokeKind> stroke_kind(std::string_view word) {
  for (const auto& [kind, text] : kinds) {
    if (word == text) return kind;
  }
  return std::nullopt;
}

std::string to_string(StrokeKind kind) {
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [kind](const auto& entry) { return entry.first == kind; });
  return std::string(found->second);
}

std::vector<std::string_view> behind_ids(const Stroke& stroke) { return data_list(stroke, behind_key); }

bool is_set_behind(const Stroke& later, const Stroke& earlier) {
  const std::vector<std::string_view> ids = behind_ids(later);
  return std::any_of(ids.begin(), ids.end(), [&](std::string_view id) { return id == behind_all || id == earlier.id; });
}

}  // namespace croquis::silhouette
