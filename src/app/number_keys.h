// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QAbstractSpinBox;

namespace croquis::app {

/// Lets the window have the keys that a field of numbers has no use for: letters, which are names of tools, and undo
/// and redo unless something is being typed. Without this the keys would be dead once a field had been clicked.
void share_keys(QAbstractSpinBox* field);

}  // namespace croquis::app
