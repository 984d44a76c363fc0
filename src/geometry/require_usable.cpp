// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/require_usable.h"

#include <utility>

#include "croquis/base/error.h"

namespace croquis {

void require_usable(const PolyMesh& mesh) {
  Findings findings = validate(mesh);
  std::erase_if(findings,
                [](const Finding& finding) { return finding.code != "E_INDEX" && finding.code != "E_NOT_FINITE"; });
  if (!findings.empty()) throw Error(std::move(findings));
}

}  // namespace croquis
