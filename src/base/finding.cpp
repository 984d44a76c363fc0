// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/base/finding.h"

#include <algorithm>
#include <utility>

namespace croquis {

const char* to_string(SubjectKind kind) {
  switch (kind) {
    case SubjectKind::Stroke: return "stroke";
    case SubjectKind::Contour: return "contour";
    case SubjectKind::Crossing: return "crossing";
    case SubjectKind::Line: return "line";
    case SubjectKind::Curve: return "curve";
    case SubjectKind::Node: return "node";
    case SubjectKind::Point: return "point";
    case SubjectKind::Face: return "face";
    case SubjectKind::Edge: return "edge";
    case SubjectKind::Vertex: return "vertex";
    case SubjectKind::Hole: return "hole";
    case SubjectKind::Parameter: return "parameter";
    case SubjectKind::File: return "file";
  }
  return "file";
}

Subject numbered_subject(SubjectKind kind, std::size_t index, std::vector<double> at) {
  return {kind, {}, {}, {}, std::move(at), static_cast<std::int64_t>(index), {}};
}

Subject edge_subject(std::size_t a, std::size_t b) {
  const std::array vertices{static_cast<std::int64_t>(a), static_cast<std::int64_t>(b)};
  return {SubjectKind::Edge, {}, {}, {}, {}, {}, vertices};
}

std::string name_of(const Subject& subject) {
  if (subject.index) return std::to_string(*subject.index);
  if (subject.vertices) return std::to_string((*subject.vertices)[0]) + "-" + std::to_string((*subject.vertices)[1]);
  return subject.id;
}

bool has_errors(const Findings& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.severity == Severity::Error; });
}

bool has_warnings(const Findings& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.severity != Severity::Info; });
}

Finding make_error(Category category, std::string code, std::string message, std::vector<Subject> subjects) {
  return {Severity::Error, category, std::move(code), std::move(message), std::move(subjects)};
}

Finding make_warning(Category category, std::string code, std::string message, std::vector<Subject> subjects) {
  return {Severity::Warning, category, std::move(code), std::move(message), std::move(subjects)};
}

}  // namespace croquis
