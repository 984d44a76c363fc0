// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/base/report.h"

namespace croquis::cli {

/// A list of objects as a table for people: a column per key of the first one, but for those in which nothing is known.
/// Numbers are shortened to six digits. Empty for an empty list; ends without a newline.
std::string report_table(const Report& list);

/// The details' sentence, and their lists as tables.
std::string list_text(const Report& details);

}  // namespace croquis::cli
