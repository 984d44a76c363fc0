// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "croquis/document/document.h"
#include "croquis/tools/perspective/perspective_tool.h"
#include "croquis/tools/recording/step.h"

namespace croquis {

/// What steps go by beside the drawing.
struct SheetContext {
  const SolvedDrawing* solved = nullptr;     ///< null: nothing was found in the drawing yet
  StrokeGroup plane = StrokeGroup::Unknown;  ///< of strokes that could lie in several
  std::vector<std::string> selected;         ///< strokes that move with a selected one
  const PerspectiveToolOptions& options;
};

/// What a step makes of a drawing.
struct SheetEdit {
  PerspectiveDrawing drawing;
  std::string label;                            ///< of the undo step: "Move stroke s3"
  bool changed = true;                          ///< false: nothing could be made of it
  std::optional<recorded::Step> recorded = {};  ///< the step with what was found on the way; none: as it was given
};

/// What a step of perspective_steps() does; nothing for one that changes no drawing.
/// @throws Error (E_INPUT) for strokes that aren't there, and values that can't be
std::optional<SheetEdit> edited_by(const PerspectiveDrawing& drawing, const recorded::Step& step,
                                   const SheetContext& context);

/// What such a step makes of the operation that the drawing goes to: choices of faces and strokes; nothing for others.
struct OperationEdit {
  Node operation;
  std::string label;
  bool changed = true;
};
std::optional<OperationEdit> edited_by(const Node& operation, const recorded::Step& step);

/// Items that ';' separates in a parameter of an operation. @param operation null has none
std::vector<std::string> items_in(const Node* operation, const std::string& list);

[[noreturn]] void refuse_input(const std::string& sentence);

}  // namespace croquis
