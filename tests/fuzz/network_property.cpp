// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/network_property.h"

#include "croquis/base/error.h"
#include "croquis/document/value_bytes.h"
#include "croquis/io/attribute_network_file.h"

namespace croquis::test {
namespace {

std::string bytes_of(const AttributeNetwork& network) {
  return encode(std::make_shared<const AttributeNetwork>(network));
}

}  // namespace

std::string broken_attribute_network(std::string_view bytes) {
  try {
    const AttributeNetworkReadResult read = read_attribute_network(bytes, "fuzzed");
    if (!validate(read.network).empty()) return "a network that isn't valid";
    if (read.warnings.size() > 200) return "too many warnings";
    const std::string written = write_attribute_network(read.network);
    if (written.find("\xef\xbf\xbd") != std::string::npos) return "";  // bytes that are no UTF-8 don't come back
    const AttributeNetworkReadResult again = read_attribute_network(written, "fuzzed");
    if (!again.warnings.empty()) return "the written network has unknown members";
    return bytes_of(again.network) == bytes_of(read.network) ? "" : "the written network reads back differently";
  } catch (const Error& error) {
    if (!has_errors(error.findings())) return "an error without errors";
    for (const Finding& finding : error.findings()) {
      if (finding.code.empty() || finding.message.find("fuzzed") == std::string::npos)
        return "a finding without a name";
      if (finding.category != Category::Malformed) return "a finding of another kind";
    }
    return error.findings().size() > 200 ? "too many findings" : "";
  }
}

}  // namespace croquis::test
