// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/finding.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/operation.h"
#include "croquis/document/value.h"

namespace croquis {

/// What a node amounts to: shared, and never changed once it is handed out.
struct Evaluation {
  Values outputs;     ///< by output port; a source has one, "value". Of a failed node: the last good ones, or none
  Findings findings;  ///< warnings; of a failed node its errors
  bool failed = false;
  bool stale = false;  ///< the outputs are older than the node
  Quality quality =
      Quality::Final;  ///< what was got: asked for a draft, a final result that is there already is better
  ContentHash key;     ///< of the operation, its version, parameters, inputs' keys, the quality and the transform
};

}  // namespace croquis
