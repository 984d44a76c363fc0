// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QAbstractSpinBox;

namespace croquis::app {

/// Lets the window have the keys that a field of numbers has no use for: letters, which choose tools, Ctrl with letters
/// that aren't the clipboard's, and undo and redo unless something is being typed. Without this they would have no
/// effect once a field had been clicked.
void share_keys(QAbstractSpinBox* field);

}  // namespace croquis::app
