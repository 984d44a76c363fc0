// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/tags_property.h"

#include "croquis/base/error.h"
#include "croquis/io/json.h"
#include "croquis/io/mesh_tags_file.h"

namespace croquis::test {
namespace {

std::string wrong_findings(const Error& error) {
  if (!has_errors(error.findings())) return "an error without errors";
  for (const Finding& finding : error.findings()) {
    if (finding.code.empty() || finding.message.empty()) return "a finding without a name";
    if (finding.category != Category::Malformed) return "a finding of another kind";
  }
  return error.findings().size() > 200 ? "too many findings" : "";
}

}  // namespace

std::string broken_tags(std::string_view bytes) {
  try {
    const Report report = read_json(bytes, "fuzzed");
    const std::string written = write_json(report);
    if (write_json(read_json(written, "fuzzed")) != written) return "the written JSON reads back differently";
    const MeshTagsReadResult read = read_mesh_tags(report);
    if (read.warnings.size() > 200) return "too many warnings";
    const Report again = read_json(write_json(report_of(read.tags)), "fuzzed");
    return read_mesh_tags(again).tags == read.tags ? "" : "the written tags read back differently";
  } catch (const Error& error) {
    return wrong_findings(error);
  }
}

}  // namespace croquis::test
