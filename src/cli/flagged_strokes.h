// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/finding.h"
#include "croquis/base/report.h"

namespace croquis::cli {

/// Operations don't hear what was found while their inputs were read, but the report has both: strokes that any finding
/// names are flagged in the list `strokes` of the details, where there is one.
void flag_strokes(const Findings& findings, Report& details);

}  // namespace croquis::cli
