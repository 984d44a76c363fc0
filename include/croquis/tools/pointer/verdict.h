// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace croquis {

/// What an event or a command led to.
enum class Verdict {
  Continue,  ///< go on: only the preview may have changed
  Commit,    ///< something was done: see the tool's done()
  Revert     ///< what had begun was given up
};

}  // namespace croquis
