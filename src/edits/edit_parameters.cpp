// SPDX-License-Identifier: GPL-3.0-or-later
#include "edits/edit_parameters.h"

#include <charconv>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"

namespace croquis {

bool is_given(const ParameterValues& parameters, const std::string& name) { return !text_of(parameters, name).empty(); }

Vec3 vector_of(const ParameterValues& parameters, const std::string& name, const Vec3& missing) {
  const std::string& text = text_of(parameters, name);
  if (text.empty()) return missing;
  Vec3 vector = Vec3::Zero();
  const char* at = text.data();
  const char* end = at + text.size();
  bool sound = true;
  for (int axis = 0; axis < 3 && sound; ++axis) {
    if (axis > 0) sound = at != end && *at++ == ',';
    if (!sound) break;
    const auto [stopped, error] = std::from_chars(at, end, vector[axis]);
    sound = error == std::errc{} && is_usable_number(vector[axis]);
    at = stopped;
  }
  if (!sound || at != end) {
    throw Error(make_error(Category::Usage, "E_PARAMETER",
                           "'" + text + "' is no value for " + name + ": it takes three numbers, such as 0,0,1.",
                           {{SubjectKind::Parameter, name, {}, {}, {}}}));
  }
  return vector;
}

}  // namespace croquis
