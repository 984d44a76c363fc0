// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/base/parameter.h"
#include "croquis/base/report.h"

/// Descriptions of parameters for programs and for the reference pages.
namespace croquis::cli {

Report describe_parameters(const std::vector<ParameterDescription>& parameters);

/// A Markdown table: name, default, values, sentence.
std::string parameter_table(const std::vector<ParameterDescription>& parameters);

}  // namespace croquis::cli
