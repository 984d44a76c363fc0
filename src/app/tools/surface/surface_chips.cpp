// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/surface_chips.h"

#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "app/panels/number_box.h"
#include "app/views/viewport.h"
#include "app/window/language.h"
#include "croquis/attribute_surface/loop_search.h"

namespace croquis::app {
namespace {

constexpr std::size_t most_loop_curves = 64;

NetworkState state_of_curves(const AttributeNetwork& network) {
  if (network.curves.empty()) return {};
  return {counted_words(network.curves.size(), QObject::tr("1 curve"), QObject::tr("%1 curves")) +
              QObject::tr(", no patch yet: P and a click inside a loop makes one"),
          false,
          {}};
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

constexpr double state_margin = 10;  // logical pixels
constexpr double network_hint_height = 70;
constexpr const char* offer_style =
    "QToolButton { background: #f28c28; color: #1c1c1e; border: 1px solid #a85a10; border-radius: 9px;"
    " padding: 2px 9px } QToolButton:hover { background: #ffac58 }";
constexpr std::size_t most_numbers = 60;

QString offset_number(double value) { return number_words(value, 2); }

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
  const std::size_t failed = failed_faces(network, shown).size();
  if (const auto error = worst(Severity::Error); error != findings.end()) {
    const QString sentence = localized(error->message);
    return {failed == 0 ? sentence
                        : counted_words(failed, QObject::tr("1 patch can't be made: "),
                                        QObject::tr("%1 patches can't be made: ")) +
                              sentence,
            false, elements_in(*error, network)};
  }
  if (const auto warning = worst(Severity::Warning); warning != findings.end())
    return {localized(warning->message), false, elements_in(*warning, network)};
  return {counted_words(network.faces.size(), QObject::tr("1 patch"), QObject::tr("%1 patches")), true, {}};
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
    state.sentence = localized(loop.findings.front().message);
  }
  return state;
}

SurfaceChips::SurfaceChips(DrawnNetwork& network, const UniformGhost& ghost)
    : network_(network),
      ghost_(ghost),
      chips_(network.host.viewport()),
      hint_(chips_.label("network-hint", hint_style)),
      sentence_(chips_.button("network-state", "", [this] { look_at(network_, state_.elements); })),
      patch_(chips_.button("patch-chip", offer_style, [this] { network_.host.action("fill-loop")->trigger(); })),
      gap_(chips_.label("gap-chip", lacking_style)) {
  hint_->setText(
      QObject::tr("Draw a curve: it lies on the ground, on what is under the pen, or between the curves it meets"));
  patch_->setText(QObject::tr("Patch (Enter)"));
  patch_->setToolTip(QObject::tr("The closed loop of curves becomes the border of one smooth patch"));
}

void SurfaceChips::follow() {
  state_ = network_state(network_.network(), network_.shown, network_.findings());
  const AttributeNetwork& network = network_.network();
  const NetworkElements selected = network_.tool.selected();
  network_.offered.clear();
  if (selected.empty()) {
    for (const AttributeSide& side : open_loop(network, {tolerance_of(network)}).sides)
      network_.offered.push_back(network.curves[side.curve].id);
  }
  loop_ = loop_state(network, selected.empty() ? network_.offered : selected.curves);
}

void SurfaceChips::place(ChipPlaces& places, bool shown) {
  chips_.begin(places);
  view_ = places.layout().alone() >= 0 ? places.layout().alone() : PerspectiveView;
  const ViewPane& pane = places.scene_pane();
  if (shown && pane.visible()) {
    place_hint(pane.rect);
    place_state(pane.rect);
    if (!network_.owner.down()) place_loop(pane);
    place_numbers(pane);
  }
  chips_.end();
}

/// A place of the model, where it is seen.
std::optional<QPointF> SurfaceChips::beside(const ViewPane& pane, const Vec3& world) const {
  constexpr QPointF way(12, -10);
  const auto seen = frame_of(network_.host.views(), view_).project(world);
  const QPointF at = pane.rect.topLeft() + (seen ? QPointF(seen->pixel.x(), seen->pixel.y()) : QPointF(-1, -1));
  return seen && pane.rect.contains(at) ? std::optional(at + way) : std::nullopt;
}

void SurfaceChips::place_hint(const QRectF& rect) {
  if (network_.network().curves.empty() && !network_.owner.down())
    chips_.put_in_middle(*hint_, rect.bottom() - network_hint_height, rect);
}

void SurfaceChips::place_state(const QRectF& rect) {
  if (state_.sentence.isEmpty()) return;
  const char* style = state_.sound ? sound_style : lacking_style;
  if (sentence_->styleSheet() != style) sentence_->setStyleSheet(style);
  const int room = static_cast<int>(rect.width() - 8 * state_margin);
  sentence_->setText(sentence_->fontMetrics().elidedText(state_.sentence, Qt::ElideRight, room));
  sentence_->setToolTip(state_.elements.empty() ? QString()
                                                : state_.sentence + "\n" + QObject::tr("Click to see where"));
  chips_.put_in_middle(*sentence_, rect.top() + state_margin, rect);
}

/// On the selected curves: that they are a loop, or what they lack.
void SurfaceChips::place_loop(const ViewPane& pane) {
  if (!loop_ || (!loop_->closed && loop_->sentence.isEmpty())) return;
  const Vec3 place = loop_->closed ? loop_->middle : loop_->gap.value_or(loop_->middle);
  const auto at = beside(pane, network_.to_world()(place));
  if (!at) return;
  gap_->setText(loop_->sentence);
  QWidget& chip = loop_->closed ? static_cast<QWidget&>(*patch_) : *gap_;
  chip.adjustSize();
  chips_.put(chip, *at, pane.rect);
}

std::vector<PlacedText> SurfaceChips::numbers() const {
  std::vector<PlacedText> numbers;
  const SurfacePreview& preview = network_.tool.preview();
  const std::vector<Vec3> ring = ring_of(network_.tool);
  if (preview.radius && !ring.empty())
    numbers.push_back({network_.to_world()(ring.front()), QObject::tr("radius %1").arg(number_words(*preview.radius)),
                       QColor("#f28c28")});
  if (const UniformGhost::Compared* compared = ghost_.compared()) {
    for (const ComparedPoint& point : compared->comparison.points) {
      const Index index = find_element(network_.network(), NetworkElement::Point, point.id);
      if (index == no_index || !point.own || !point.uniform) continue;
      numbers.push_back({network_.to_world()(network_.network().points[index].point),
                         QObject::tr("off by %1, uniform %2")
                             .arg(offset_number(point.own->offset), offset_number(point.uniform->offset)),
                         QColor("#f28c28")});
    }
  }
  const std::vector<PlacedText>& jumps = network_.scene.numbers();
  numbers.insert(numbers.end(), jumps.begin(), jumps.end());
  if (numbers.size() > most_numbers) numbers.resize(most_numbers);
  return numbers;
}

void SurfaceChips::place_numbers(const ViewPane& pane) {
  for (const PlacedText& number : numbers()) {
    if (const auto at = beside(pane, number.at))
      chips_.put_value("network-number", number.text, number.color.name(), *at, pane.rect);
  }
}

}  // namespace croquis::app
