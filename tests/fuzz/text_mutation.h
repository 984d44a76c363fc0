// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "support/random.h"

/// Changes texts as somebody's slip or another program's fault would, so that most of them can still be read.
namespace croquis::test {

/// How the elements of a text are told apart: lines of OBJ and edits, members of JSON, elements of XML.
enum class TextSyntax { Lines, Json, Xml };

/// One to three changes: elements dropped, doubled or swapped; numbers moved a little, taken from elsewhere in the
/// text, or replaced by extreme ones; words taken from elsewhere; a few bytes cut out, or everything from some place
/// on. The same seed gives the same text.
std::string mutated_text(std::string text, TextSyntax syntax, Random& random);

/// A number that programs are seldom tried with, from 0 to NaN.
double extreme_number(Random& random);

}  // namespace croquis::test
