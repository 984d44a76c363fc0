// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace croquis::test {

/// Two faces, "good" and "bad", that share the curve "ab".
nlohmann::json two_faces();

/// A network that a code is about. Whatever is wrong with "bad", "good" is made all the same.
struct CodeNetwork {
  std::string code;
  nlohmann::json network;
  std::set<std::string> named;  ///< ids of the elements that the code's findings name, all of them
  bool leaves_bad_out = false;
  int exit_code = 0;  ///< 3: the file is refused
};

std::vector<CodeNetwork> code_networks();

}  // namespace croquis::test
