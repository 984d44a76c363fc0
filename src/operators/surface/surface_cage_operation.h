// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/document/operation.h"

namespace croquis {

/// A network of curves becomes a control mesh for subdivision.
class SurfaceCageOperation final : public Operation {
 public:
  OperationDescription describe() const override;
  OperationResult compute(const Values& inputs, const ParameterValues& parameters, Context& context) const override;
};

}  // namespace croquis
