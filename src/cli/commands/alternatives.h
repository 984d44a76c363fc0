// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cli/command.h"

/// Solids of other readings of a drawing: OUT-1 is what is written without the option, OUT-2 and so on the next best.
namespace croquis::cli {

/// Whether an operation's drawing has more than one reading.
bool has_readings(const OperationDescription& description);

/// --alternatives, for such an operation.
ParameterDescription alternatives_option();

/// How many readings are asked for; none where the option isn't given.
/// @throws Error (E_PARAMETER, E_USAGE) for no count, or without a file to number
std::optional<std::size_t> asked_readings(const OperationDescription& description, const Invocation& invocation);

/// "solid.obj", 2: "solid-2.obj".
std::string numbered_path(const std::string& path, std::size_t number);

/// What a run of the operation was given and made.
struct FirstReading {
  const Operation& operation;
  const Values& inputs;
  const ParameterValues& parameters;
};

/// Stages the files of the further readings and puts the list `alternatives` into the details; W_ALTERNATIVES where
/// there are fewer. Readings that give no solid are passed over.
/// @param invocation its output as it was typed
void stage_alternatives(const FirstReading& first, std::size_t count, const Invocation& invocation,
                        CommandResult& result, Progress& progress);

}  // namespace croquis::cli
