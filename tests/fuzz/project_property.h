// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "croquis/document/value.h"

/// What must hold for any bytes that the project reader is given: shared by the fuzzers and the tests.
namespace croquis::test {

/// Reading either throws an Error whose findings name the file, or gives a document whose ids differ and whose values
/// can be computed with.
/// @return what did not hold; empty when all did
std::string broken_project(std::string_view bytes);

/// Bytes are either no value of that kind, or one that can be computed with and whose own bytes read back as the same.
std::string broken_value(ValueType type, std::string_view bytes);

}  // namespace croquis::test
