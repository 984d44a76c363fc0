// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/document/operation.h"

namespace croquis {

/// Holes of a mesh are closed by attribute surfaces.
class SurfacePatchOperation final : public Operation {
 public:
  OperationDescription describe() const override;
  OperationResult compute(const Values& inputs, const ParameterValues& parameters, Context& context) const override;
};

}  // namespace croquis
