// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/silhouette/options.h"

namespace croquis {

/// What the parameter "attach" of the operation `inflate` says: which objects of a sketch are held how.
///
/// Entries are separated by semicolons: "auto" (pairs not named are held as the drawing suggests), and pairs "A,B" or
/// "A,B=HOLD". HOLD is "apart", "rest", or for joined ones a number from 0 to 1 (see AttachedPair::kappa) or "join",
/// either with ":BLEND" after it, the radius of the seam from 0 to 1. Names hold no comma and no semicolon; what
/// follows the last '=' is the hold.
struct AttachText {
  bool suggested = false;  ///< "auto" was among the entries
  std::vector<silhouette::AttachedPair> pairs;
};

/// @throws Error with one E_PARAMETER for every entry that is neither
AttachText read_attach_text(const std::string& text);

/// The shortest text that reads back as the same.
std::string to_text(const AttachText& attach);

/// The last pair of these two in either order; null when there is none.
const silhouette::AttachedPair* find_pair(const AttachText& attach, const std::string& a, const std::string& b);

}  // namespace croquis
