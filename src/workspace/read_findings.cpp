// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/workspace/read_findings.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

namespace croquis {
namespace {

void add_stroke_names(const Finding& finding, std::vector<std::string>& names) {
  for (const Subject& subject : finding.subjects) {
    if (subject.kind == SubjectKind::Stroke) names.push_back(subject.id);
  }
}

/// Calls back with each stroke of a source that has one of these names, and its hash.
/// @param names sorted
template <class AnyDrawing>
void for_named_strokes(const Node& node, const std::vector<std::string>& names, const auto& take) {
  const auto drawing = source_of<AnyDrawing>(&node);
  if (!drawing) return;
  for (const auto& stroke : drawing->strokes) {
    if (!std::ranges::binary_search(names, stroke.id)) continue;
    AnyDrawing alone;
    alone.strokes = {stroke};
    take(stroke.id, content_hash(std::make_shared<const AnyDrawing>(std::move(alone))));
  }
}

}  // namespace

ReadFindings::StrokeHashes ReadFindings::hashes_of(const Document& document, const std::vector<std::string>& names) {
  StrokeHashes hashes;
  if (names.empty()) return hashes;
  for (const auto& node : document.nodes()) {
    const auto take = [&](const std::string& id, const ContentHash& hash) { hashes[{node->id, id}] = hash; };
    for_named_strokes<Drawing>(*node, names, take);
    for_named_strokes<PerspectiveDrawing>(*node, names, take);
  }
  return hashes;
}

void ReadFindings::add(const Findings& findings, const Document& read) {
  std::vector<std::string> names;
  for (const Finding& finding : findings) add_stroke_names(finding, names);
  std::ranges::sort(names);
  const StrokeHashes hashes = hashes_of(read, names);
  for (const Finding& finding : findings) {
    std::vector<std::string> own;
    add_stroke_names(finding, own);
    StrokeHashes strokes;
    std::ranges::copy_if(hashes, std::inserter(strokes, strokes.end()),
                         [&](const auto& entry) { return std::ranges::find(own, entry.first.second) != own.end(); });
    findings_.push_back({finding, std::move(strokes)});
  }
}

Findings ReadFindings::in(const Document& now) const {
  std::vector<std::string> names;
  for (const ReadFinding& read : findings_) {
    for (const auto& [stroke, hash] : read.strokes) names.push_back(stroke.second);
  }
  std::ranges::sort(names);
  const StrokeHashes hashes = hashes_of(now, names);
  const auto is_as_read = [&](const auto& entry) {
    const auto found = hashes.find(entry.first);
    return found != hashes.end() && found->second == entry.second;
  };
  Findings found;
  for (const ReadFinding& read : findings_) {
    if (std::ranges::all_of(read.strokes, is_as_read)) found.push_back(read.finding);
  }
  return found;
}

}  // namespace croquis
