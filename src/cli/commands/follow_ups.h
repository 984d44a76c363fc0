// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"

/// Values that have no file format, such as a solid's B-rep, are what further operations work on: on the command line
/// their results are outputs of the command that makes the value.
namespace croquis::cli {

/// Whether there is a file format for values of a type.
bool has_files(ValueType type);

/// An operation that goes on from an output of another one.
struct FollowUp {
  const Operation* operation = nullptr;
  OperationDescription description;
  std::string source;  ///< the output that it goes on from

  const PortDescription& output() const { return description.outputs.front(); }

  /// The option that writes its output: the output's name.
  const std::string& option() const { return output().name; }

  /// The option of one of its parameters.
  std::string option(const ParameterDescription& parameter) const { return option() + "-" + parameter.name; }
};

/// Whether an operation's input can be read from a file, so that it is a command of its own.
bool reads_files(const OperationDescription& operation);

/// All that go on from outputs without a file format, in the registry's order.
std::vector<FollowUp> follow_ups_of(const OperationDescription& operation, const Registry& registry);

/// The options of a follow-up: its output's file, then its parameters.
std::vector<ParameterDescription> options_of(const FollowUp& follow_up);

/// What it makes of the outputs of the operation before it.
/// @throws Error, Cancelled
OperationResult run(const FollowUp& follow_up, const Values& outputs, const Invocation& invocation, Progress& progress);

}  // namespace croquis::cli
