// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing of its own: the target that it belongs to keeps the compiled form of test_headers.h.
#include "support/test_headers.h"
