// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/parameter.h"
#include "croquis/base/progress.h"
#include "croquis/document/result_box.h"
#include "croquis/document/value.h"

/// The extension point for whatever makes geometry from geometry; edits (edits/edit.h) are the one for whatever changes
/// a mesh at chosen elements. Every host builds its interface from the operation's own description.
namespace croquis {

/// One typed input or output of an operation.
struct PortDescription {
  std::string name;
  ValueType type = ValueType::Mesh;
  std::string sentence;
  bool is_solid = false;   ///< a mesh that promises to be closed, oriented and free of self-intersection, as written
  bool optional = false;   ///< an input that may be absent
  bool asks = false;       ///< an optional report of questions that "details" answers: nothing else need be wanted then
  bool is_raw = false;     ///< an input mesh as devices leave it: hosts offer to drop what isn't finite
  bool is_closed = false;  ///< an output mesh that is meant to be closed: hosts warn where it isn't
  bool joins_seams = false;  ///< an output mesh that begins with the input's faces and then has `new_faces` of the
                             ///< details: hosts count vertices at one place (parameter `weld`) as one, and separate
                             ///< self-intersections that were there from those that were added
};

/// Of an operation whose parameters are edits of its input's elements: people go on editing what it gives.
struct InputEdits {
  std::string lines;         ///< the text parameter with the edits, in their order, separated by ';'
  std::string connectivity;  ///< the text parameter with the connectivity_name of the mesh that they were made for
};

/// All that hosts know of an operation: options and help, panel, project-file fields and reference page come from it.
struct OperationDescription {
  std::string id;   ///< "inflate": also the subcommand of the command line
  int version = 1;  ///< raised when the same parameters would give another result
  std::string title;
  std::string sentence;
  std::vector<PortDescription> inputs;
  std::vector<PortDescription> outputs;
  std::vector<ParameterDescription> parameters = {};
  std::string list_flag = {};  ///< name of a flag under which "details" is all that is wanted: hosts write nothing then
  std::string example = {};    ///< options of an example on the command line
  std::optional<InputEdits> edits_input = {};
};

class Memo;

/// A draft may be coarser where that saves time; it is only ever looked at. Files are made of final results.
enum class Quality { Draft, Final };

/// What surrounds a computation.
struct Context {
  Progress& progress;  ///< also shows when to stop
  Quality quality = Quality::Final;
  Memo* memo = nullptr;  ///< results of stages (see memoized); with null everything is computed
  int threads = 1;       ///< how many may be used; the result is the same for any number
};

struct OperationResult {
  Values outputs;  ///< every described output
  Findings warnings;
  ResultBox details = {};  ///< what programs read of the result, of the operation's own type; its report is made of it
};

/// A deterministic function of its inputs, its parameters and the quality. Hosts compute on several threads at once.
class Operation {
 public:
  /// Takes one value of the described type per input port, where optional ones may be missing, and complete parameters
  /// within their ranges (see croquis::complete).
  using Compute = std::function<OperationResult(const Values& inputs, const ParameterValues& parameters, Context&)>;

  Operation(OperationDescription description, Compute compute)
      : description_(std::move(description)), compute_(std::move(compute)) {}

  const OperationDescription& describe() const { return description_; }

  /// @throws Error, Cancelled
  OperationResult compute(const Values& inputs, const ParameterValues& parameters, Context& context) const {
    return compute_(inputs, parameters, context);
  }

 private:
  OperationDescription description_;
  Compute compute_;
};

/// Checks inputs against the description, completes the parameters, computes, and checks the outputs likewise.
/// @throws Error (E_PARAMETER, E_INPUT; E_INTERNAL for a missing output), and whatever compute throws
OperationResult run(const Operation& operation, const Values& inputs, ParameterValues parameters, Context& context);

}  // namespace croquis
