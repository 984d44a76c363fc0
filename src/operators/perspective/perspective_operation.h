// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/document/operation.h"

namespace croquis {

/// A perspective drawing becomes a camera, its curves in space, and a solid.
class PerspectiveOperation final : public Operation {
 public:
  OperationDescription describe() const override;
  OperationResult compute(const Values& inputs, const ParameterValues& parameters, Context& context) const override;
};

}  // namespace croquis
