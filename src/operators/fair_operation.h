// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/document/operation.h"

namespace croquis {

/// `fair`: moves the vertices of a cage so that its subdivision surface bends evenly (see subdivision/fairing.h).
class FairOperation final : public Operation {
 public:
  OperationDescription describe() const override;
  OperationResult compute(const Values& inputs, const ParameterValues& parameters, Context& context) const override;
};

}  // namespace croquis
