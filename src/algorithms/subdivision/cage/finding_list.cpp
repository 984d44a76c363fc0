// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/cage/finding_list.h"

#include <utility>

namespace croquis::subdivision {
namespace {

constexpr std::size_t max_kept = 100;

}  // namespace

FindingList::FindingList(Severity severity, Category category, std::string code)
    : severity_(severity), category_(category), code_(std::move(code)) {}

void FindingList::add(std::vector<Subject> subjects, const std::function<std::string()>& sentence) {
  if (++count_ > max_kept) return;
  kept_.push_back({severity_, category_, code_, sentence(), std::move(subjects)});
}

void FindingList::move_to(Findings& findings) {
  if (count_ > max_kept) kept_.back().message += "; " + std::to_string(count_ - max_kept) + " more are like it";
  for (Finding& finding : kept_) {
    finding.message += ".";
    findings.push_back(std::move(finding));
  }
  kept_.clear();
  count_ = 0;
}

Subject face_subject(std::size_t face) { return numbered_subject(SubjectKind::Face, face); }

Subject vertex_subject(std::size_t vertex) { return numbered_subject(SubjectKind::Vertex, vertex); }

std::string edge_name(std::size_t a, std::size_t b) {
  return "edge (" + std::to_string(a) + "," + std::to_string(b) + ")";
}

}  // namespace croquis::subdivision
