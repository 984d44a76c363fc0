// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/network_state.h"

#include <QObject>
#include <algorithm>

#include "app/panels/number_box.h"

namespace croquis::app {
namespace {

constexpr std::size_t most_loop_curves = 64;

QString counted_text(std::size_t count, const QString& one, const QString& many) {
  return count == 1 ? one : many.arg(count);
}

NetworkState state_of_curves(const AttributeNetwork& network) {
  if (network.curves.empty()) return {};
  return {counted_text(network.curves.size(), QObject::tr("1 curve"), QObject::tr("%1 curves")) +
              QObject::tr(", no patch yet: P and a click inside a loop makes one"),
          false,
          {}};
}

/// Faces that have no surface, as far as that is known.
std::size_t failed_count(const AttributeNetwork& network, const ShownSurface& shown) {
  return static_cast<std::size_t>(std::ranges::count_if(network.faces, [&](const AttributeFace& face) {
    const Index tried = shown ? shown.face(face.id) : no_index;
    return tried != no_index && !shown.surface().faces[tried].surface;
  }));
}

/// Ends of these curves at which none of the others ends.
std::vector<Vec3> open_ends(const AttributeNetwork& network, const std::vector<Index>& curves, double tolerance) {
  std::vector<Vec3> ends, open;
  for (const Index curve : curves) {
    ends.push_back(start_place(network, {curve, false}));
    ends.push_back(end_place(network, {curve, false}));
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    bool met = false;
    for (std::size_t j = 0; j < ends.size(); ++j) met = met || (i != j && (ends[i] - ends[j]).norm() <= tolerance);
    if (!met) open.push_back(ends[i]);
  }
  return open;
}

bool is_loop_of_face(const AttributeNetwork& network, std::vector<Index> curves) {
  std::ranges::sort(curves);
  return std::ranges::any_of(network.faces, [&](const AttributeFace& face) {
    std::vector<Index> loop;
    for (const AttributeSide& side : face.loop) loop.push_back(side.curve);
    std::ranges::sort(loop);
    return loop == curves;
  });
}

}  // namespace

NetworkElements elements_in(const Finding& finding, const AttributeNetwork& network) {
  NetworkElements elements;
  const auto add = [&](SubjectKind wanted, NetworkElement kind) {
    for (const Subject& subject : finding.subjects) {
      if (subject.kind == wanted && find_element(network, kind, subject.id) != no_index)
        elements.of(kind).push_back(subject.id);
    }
  };
  add(SubjectKind::Node, NetworkElement::Node);
  add(SubjectKind::Curve, NetworkElement::Curve);
  add(SubjectKind::Face, NetworkElement::Face);
  add(SubjectKind::Point, NetworkElement::Point);
  return elements;
}

NetworkState network_state(const AttributeNetwork& network, const ShownSurface& shown, const Findings& findings) {
  if (network.faces.empty()) return state_of_curves(network);
  const auto worst = [&](Severity severity) { return std::ranges::find(findings, severity, &Finding::severity); };
  const std::size_t failed = failed_count(network, shown);
  if (const auto error = worst(Severity::Error); error != findings.end()) {
    const QString sentence = QString::fromStdString(error->message);
    return {failed == 0 ? sentence
                        : counted_text(failed, QObject::tr("1 patch can't be made: "),
                                       QObject::tr("%1 patches can't be made: ")) +
                              sentence,
            false, elements_in(*error, network)};
  }
  if (const auto warning = worst(Severity::Warning); warning != findings.end())
    return {QString::fromStdString(warning->message), false, elements_in(*warning, network)};
  return {counted_text(network.faces.size(), QObject::tr("1 patch"), QObject::tr("%1 patches")), true, {}};
}

std::optional<LoopState> loop_state(const AttributeNetwork& network, const std::vector<std::string>& ids) {
  std::vector<Index> curves;
  LoopState state;
  for (const std::string& id : ids) {
    const Index curve = find_element(network, NetworkElement::Curve, id);
    if (curve == no_index) continue;
    curves.push_back(curve);
    state.middle += (start_place(network, {curve, false}) + end_place(network, {curve, false})) / 2;
  }
  if (curves.size() < 2 || curves.size() > most_loop_curves || is_loop_of_face(network, curves)) return std::nullopt;
  state.middle /= static_cast<double>(curves.size());
  const double tolerance = tolerance_of(network);
  const SortedLoop loop = sort_loop(network, curves, tolerance);
  state.closed = loop.closed();
  if (state.closed) return state;
  const std::vector<Vec3> open = open_ends(network, curves, tolerance);
  if (open.size() == 2) {
    state.gap = (open[0] + open[1]) / 2;
    state.sentence = QObject::tr("Gap of %1").arg(number_words((open[1] - open[0]).norm()));
  } else if (!loop.findings.empty()) {
    state.sentence = QString::fromStdString(loop.findings.front().message);
  }
  return state;
}

}  // namespace croquis::app
