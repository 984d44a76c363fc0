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

bool has_errors(const Findings& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.severity == Severity::Error; });
}

Finding make_error(Category category, std::string code, std::string message, std::vector<Subject> subjects) {
  return {Severity::Error, category, std::move(code), std::move(message), std::move(subjects)};
}

Finding make_warning(Category category, std::string code, std::string message, std::vector<Subject> subjects) {
  return {Severity::Warning, category, std::move(code), std::move(message), std::move(subjects)};
}

}  // namespace croquis
