// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/document/operation.h"

namespace croquis {

/// The curves and faces of a solid become an attribute network.
class AttributeNetworkOperation final : public Operation {
 public:
  OperationDescription describe() const override;
  OperationResult compute(const Values& inputs, const ParameterValues& parameters, Context& context) const override;
};

}  // namespace croquis
