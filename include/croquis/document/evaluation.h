// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/finding.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/operation.h"
#include "croquis/document/result_box.h"
#include "croquis/document/value.h"

namespace croquis {

/// What a node amounts to: shared, and never changed once it is handed out.
struct Evaluation {
  Values outputs;     ///< by output port; a source has one, "value". Of a failed node: the last good ones, or none
  Findings findings;  ///< warnings; of a failed node its errors
  ResultBox details;  ///< as the operation gave them with these outputs
  bool failed = false;
  bool stale = false;  ///< the outputs are older than the node
  Quality quality =
      Quality::Final;  ///< what was got: asked for a draft, a final result that is there already is better
  ContentHash key;     ///< of the operation, its version, parameters, inputs' keys, the quality and the transform

  /// What the operation found, such as a FillResult; null for a source, for another operation, and without outputs.
  template <class Result>
  const Result* result() const {
    return details.get<Result>();
  }
};

/// The same of an evaluation that may be null.
template <class Result>
const Result* result_of(const Evaluation* evaluation) {
  return evaluation == nullptr ? nullptr : evaluation->result<Result>();
}

}  // namespace croquis
