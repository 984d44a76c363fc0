// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/sketch_chips.h"

#include <QMenu>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include "app/tools/silhouette/part_names.h"
#include "app/views/viewport.h"
#include "croquis/base/error.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {
namespace {

bool is_about(const Body& body, const std::vector<std::string>& strokes) {
  return std::ranges::any_of(strokes,
                             [&](const std::string& stroke) { return std::ranges::count(body.strokes, stroke) > 0; });
}

/// Objects of a sketch that were joined are one body: of one colour, without lines where they meet.
std::shared_ptr<const PolyMesh> with_shells_as_objects(const std::shared_ptr<const PolyMesh>& mesh,
                                                       const std::vector<InflatedShell>& shells) {
  std::map<std::string, std::int32_t> shell_of;
  std::int32_t count = 0;
  for (const InflatedShell& shell : shells) {
    for (const std::string& name : shell.objects) shell_of[name] = count;
    ++count;
  }
  const AttributeChannel* objects = mesh->channel("object", Domain::Face);
  if (objects == nullptr || shell_of.size() == shells.size()) return mesh;
  auto painted = std::make_shared<PolyMesh>(*mesh);
  auto& labels = std::get<std::vector<std::int32_t>>(painted->channel("object", Domain::Face)->data);
  for (std::int32_t& label : labels) label = shell_of[objects->labels.at(static_cast<std::size_t>(label))];
  return painted;
}

using silhouette::AttachedPair;
using silhouette::Hold;
using silhouette::SolidAttachment;

template <class Pair>
bool names_pair(const Pair& pair, const std::string& a, const std::string& b) {
  return (pair.a == a && pair.b == b) || (pair.a == b && pair.b == a);
}

Joint joint_of(const InflateResult& inflated, const AttachText& attach, bool is_final, Joint joint) {
  const AttachedPair* entry = find_pair(attach, joint.a, joint.b);
  joint.hold = entry == nullptr ? joint.by_itself : entry->hold;
  const auto made = std::ranges::find_if(
      inflated.attached, [&](const SolidAttachment& pair) { return names_pair(pair, joint.a, joint.b); });
  const bool is_made = made != inflated.attached.end();
  if (is_made) joint.blend = made->blend;
  if (entry != nullptr && entry->hold == Hold::Joined) joint.blend = entry->blend;
  if (is_final && joint.hold == Hold::Joined) joint.held = is_made && made->hold == Hold::Joined;
  return joint;
}

/// The entry of a joint is taken out. @return it, or a new one
AttachedPair take_entry(AttachText& attach, const Joint& joint) {
  AttachedPair pair;
  if (const AttachedPair* old = find_pair(attach, joint.a, joint.b)) pair = *old;
  pair.a = joint.a;
  pair.b = joint.b;
  std::erase_if(attach.pairs, [&](const AttachedPair& other) { return names_pair(other, joint.a, joint.b); });
  return pair;
}

using silhouette::StrokeKind;
using Strength = SketchChip::Look::Strength;

constexpr double beside_part = 14;        // logical pixels above or below an inner outline
constexpr double pixels_per_blend = 120;  // a drag so far to the right or up makes the seam as wide as it can be

/// Chips of inner outlines, which may be smaller than a chip, stand beside these: above them, or below.
ChipRow::Chip beside(ChipRow::Chip chip, const Stroke& outline, bool above) {
  Eigen::AlignedBox2d box;
  for (const StrokeSample& sample : outline.samples) box.extend(sample.position);
  chip.at = {box.center().x(), above ? box.max().y() : box.min().y()};
  chip.above = above ? beside_part : -beside_part;
  return chip;
}

/// Whether an object is a limb of one line.
bool is_tube(const InflateResult& inflated, const std::string& name) {
  const auto object = std::ranges::find(inflated.objects, name, &InflatedObject::name);
  return object != inflated.objects.end() && std::ranges::all_of(object->strokes, [&](const std::string& id) {
           return std::ranges::count(inflated.kinds, std::pair(id, StrokeKind::Tube)) > 0;
         });
}

/// What a stroke can be.
std::vector<StrokeKind> kinds_for(const Stroke& stroke) {
  if (!stroke.closed)
    return {StrokeKind::Contour, StrokeKind::Tube, StrokeKind::Detail, StrokeKind::Scribble, StrokeKind::Ignored};
  return {StrokeKind::Contour, StrokeKind::Part,     StrokeKind::Hole,   StrokeKind::Blob,
          StrokeKind::Detail,  StrokeKind::Scribble, StrokeKind::Ignored};
}

ChipRow::Chip kind_chip(const ReadStroke& read) {
  const QString found = read.chosen ? QString() : " " + SketchChips::tr("(read from the drawing)");
  const QString word = word_of(read.kind);
  const QString sentence =
      SketchChips::tr("%1: %2. Click (with Q) to make it something else").arg(shown_name(read.stroke), word);
  const Strength strength = read.chosen                        ? Strength::Half
                            : read.kind == StrokeKind::Ignored ? Strength::Warning
                                                               : Strength::Plain;
  return {read.at, {"stroke-kind", word, sentence + found, strength}};
}

double blend_after(double from, const QPointF& by) {
  return std::clamp(chip_number(from + (by.x() - by.y()) / pixels_per_blend), 0.0, 1.0);
}

}  // namespace

std::vector<Body> bodies_of(const Drawing& drawing, const Evaluation* solid) {
  const InflateResult* inflated = result_of<InflateResult>(solid);
  std::vector<Body> bodies;
  if (inflated == nullptr) return bodies;
  const std::vector<QString> names = part_names(drawing, *inflated);
  for (std::size_t i = 0; i < names.size(); ++i) bodies.push_back({names[i], inflated->objects[i].strokes});
  return bodies;
}

QString word_of(silhouette::StrokeKind kind) {
  switch (kind) {
    case silhouette::StrokeKind::Visible: break;
    case silhouette::StrokeKind::Hidden: return QObject::tr("Hidden line");
    case silhouette::StrokeKind::Contour: return QObject::tr("Outline");
    case silhouette::StrokeKind::Part: return QObject::tr("Part in front");
    case silhouette::StrokeKind::Hole: return QObject::tr("Hole");
    case silhouette::StrokeKind::Blob: return QObject::tr("Small shape");
    case silhouette::StrokeKind::Detail: return QObject::tr("Detail");
    case silhouette::StrokeKind::Scribble: return QObject::tr("Fur, hatching");
    case silhouette::StrokeKind::Tube: return QObject::tr("Tube");
    case silhouette::StrokeKind::Ignored: return QObject::tr("Left out");
  }
  return {};
}

const Body* body_with(const std::vector<Body>& bodies, const std::vector<std::string>& strokes) {
  const auto body = std::ranges::find_if(bodies, [&](const Body& b) { return is_about(b, strokes); });
  return body == bodies.end() ? nullptr : &*body;
}

LiveItem::Paint paint_of_bodies(const WorkObject& object) {
  const InflateResult* inflated = result_of<InflateResult>(object.result.get());
  if (inflated == nullptr) return nullptr;
  return [result = object.result, inflated](const std::shared_ptr<const PolyMesh>& mesh) {
    return with_shells_as_objects(mesh, inflated->shells);
  };
}

AttachText with_object_names(AttachText attach, const InflateResult& inflated) {
  std::map<std::string, std::string> object_of;
  for (const InflatedObject& object : inflated.objects) {
    for (const std::string& stroke : object.strokes) object_of.emplace(stroke, object.name);
  }
  for (AttachedPair& pair : attach.pairs) {
    for (std::string* name : {&pair.a, &pair.b}) {
      const auto object = object_of.find(*name);
      if (object != object_of.end()) *name = object->second;
    }
  }
  return attach;
}

std::vector<Joint> joints_of(const InflateResult& inflated, const AttachText& attach, bool is_final) {
  std::vector<Joint> joints;
  for (const SuggestedJoint& suggested : inflated.suggested) {
    Joint joint{suggested.a, suggested.b, suggested.at};
    if (attach.suggested) joint.by_itself = suggested.hold;
    joints.push_back(joint_of(inflated, attach, is_final, std::move(joint)));
  }
  for (const SolidAttachment& pair : inflated.attached) {
    const bool known =
        std::ranges::any_of(joints, [&](const Joint& joint) { return names_pair(pair, joint.a, joint.b); });
    if (!known) joints.push_back(joint_of(inflated, attach, is_final, {pair.a, pair.b, pair.at}));
  }
  return joints;
}

Hold next_hold(Hold hold) {
  if (hold == Hold::Apart) return Hold::Resting;
  return hold == Hold::Resting ? Hold::Joined : Hold::Apart;
}

AttachText with_hold(AttachText attach, const Joint& joint, Hold hold) {
  AttachedPair pair = take_entry(attach, joint);
  pair.hold = hold;
  if (hold != Hold::Joined) pair.blend = AttachedPair().blend;
  if (hold != joint.by_itself) attach.pairs.push_back(std::move(pair));
  return attach;
}

AttachText with_blend(AttachText attach, const Joint& joint, double blend) {
  AttachedPair pair = take_entry(attach, joint);
  pair.hold = Hold::Joined;
  pair.blend = std::clamp(blend, 0.0, 1.0);
  attach.pairs.push_back(std::move(pair));
  return attach;
}

SketchChips::SketchChips(Studio& studio, SketchTool& tool, Viewport& views)
    : QObject(&views),
      studio_(studio),
      tool_(tool),
      joint_row_(&views, "joint", true),
      nested_row_(&views, "nested", false),
      crossing_row_(&views, "crossing", false),
      tube_row_(&views, "strands", false),
      kind_row_(&views, "kind", false),
      thickness_(studio, views) {
  connect_rows();
}

void SketchChips::connect_rows() {
  connect(&joint_row_, &ChipRow::clicked, this, [this](std::size_t number) {
    const Joint& joint = joints_.at(number);
    const Hold hold = next_hold(joint.hold);
    const QString step = hold == Hold::Joined    ? tr("Join %1")
                         : hold == Hold::Resting ? tr("Rest %1 on each other")
                                                 : tr("Keep %1 apart");
    set_attach(with_hold(attach(), joint, hold), step.arg(pair_name(joint)), false);
  });
  connect(&joint_row_, &ChipRow::dragged, this, [this](std::size_t number, const QPointF& by) {
    const Joint& joint = joints_.at(number);
    if (joint.hold != Hold::Joined) return;
    if (!dragged_from_) dragged_from_ = joint.blend;
    const double blend = blend_after(*dragged_from_, by);
    set_attach(with_blend(attach(), joint, blend), seam_step(joint), true);
    QToolTip::showText(QCursor::pos(), tr("Seam radius %1").arg(chip_text(blend)));
  });
  connect(&joint_row_, &ChipRow::dropped, this, [this] {
    if (std::exchange(dragged_from_, std::nullopt)) set_attach(attach(), {}, false);
  });
  connect(&joint_row_, &ChipRow::asked, this, [this](std::size_t number) {
    const Joint joint = joints_.at(number);
    if (joint.hold != Hold::Joined) return;
    ask_number(*joint_row_.chip(number), "seam-radius", joint.blend, 0, 1, [this, joint](double blend) {
      set_attach(with_blend(attach(), joint, blend), seam_step(joint), false);
    });
  });
  connect(&nested_row_, &ChipRow::clicked, this, [this](std::size_t number) {
    const NestedStroke& nested = nested_.at(number);
    set({nested.stroke, nested.hole ? StrokeKind::Part : StrokeKind::Hole}, false);
  });
  connect(&crossing_row_, &ChipRow::clicked, this, [this](std::size_t number) {
    const StrokesInView& crossing = crossings_.at(number);
    set({crossing.behind, {}, crossing.front}, false);
  });
  connect(&tube_row_, &ChipRow::clicked, this, [this](std::size_t number) {
    const TubeSwap& swap = swaps_.at(number);
    set({.stroke = swap.stroke, .over = swap.over}, false);
  });
  connect(&kind_row_, &ChipRow::clicked, this,
          [this](std::size_t number) { ask_kind(kinds_.at(number), *kind_row_.chip(number)); });
  connect(&thickness_, &ThicknessHandle::wanted, this, &SketchChips::set);
}

// ---- What they show

QString SketchChips::name_of(const std::string& object_or_stroke) const {
  const Body* body = body_with(bodies_, {object_or_stroke});
  return body == nullptr ? shown_name(object_or_stroke) : body->name;
}

QString SketchChips::pair_name(const Joint& joint) const {
  return tr("%1 and %2").arg(name_of(joint.a), name_of(joint.b));
}

QString SketchChips::seam_step(const Joint& joint) const { return tr("Seam of %1").arg(pair_name(joint)); }

ChipRow::Chip SketchChips::chip_of(const Joint& joint) const {
  const QString names = pair_name(joint);
  const auto chip = [&](const char* icon, const QString& sentence, Strength strength) {
    return ChipRow::Chip{joint.at, {icon, {}, sentence, strength}};
  };
  if (joint.hold == Hold::Apart)
    return chip("joint-apart", tr("Apart: %1 keep a gap. Click to rest one on the other").arg(names), Strength::Plain);
  if (joint.hold == Hold::Resting)
    return chip("joint-resting", tr("Resting: %1 touch. Click to join them").arg(names), Strength::Half);
  if (!joint.held)
    return chip("joint-joined", tr("%1 couldn't be joined, see Findings. Click to keep them apart").arg(names),
                Strength::Warning);
  const QString sentence =
      tr("Joined: %1 are one body, seam radius %2. Click to keep them apart; drag, or right click, for the radius");
  return chip("joint-joined", sentence.arg(names, chip_text(joint.blend)), Strength::Full);
}

ChipRow::Chip SketchChips::chip_of(const NestedStroke& nested) const {
  const QString around = name_of(nested.around);
  const QString sentence = nested.hole ? tr("Hole in %1. Click to make it a part in front")
                                       : tr("Part in front of %1. Click to make it a hole");
  const QString how = nested.chosen ? QString() : " " + tr("(read from the drawing)");
  const Strength strength = nested.chosen ? Strength::Half : Strength::Plain;
  ChipRow::Chip chip{nested.at,
                     {nested.hole ? "nested-hole" : "nested-part", {}, sentence.arg(around) + how, strength}};
  const Stroke* outline = find_stroke(studio_.drawing(), nested.stroke);
  return outline == nullptr ? chip : beside(std::move(chip), *outline, true);
}

ChipRow::Chip SketchChips::chip_of(const StrokesInView& crossing) const {
  const QString names =
      tr("In front: %1. Behind: %2. Click to swap them").arg(name_of(crossing.front), name_of(crossing.behind));
  return {crossing.at, {"crossing-in-view", {}, names, crossing.chosen ? Strength::Half : Strength::Plain}};
}

/// Beside the mark that shows the two strands.
ChipRow::Chip SketchChips::chip_of(const TubeSwap& swap) const {
  constexpr double beside_mark = 22;  // logical pixels
  const QString sentence =
      swap.front == swap.behind
          ? tr("%1 passes over itself. Click to swap the strands").arg(name_of(swap.front))
          : tr("In front: %1. Behind: %2. Click to swap them").arg(name_of(swap.front), name_of(swap.behind));
  return {swap.at, {"crossing-in-view", {}, sentence, Strength::Plain}, beside_mark};
}

/// A menu below the chip of what its stroke can be.
void SketchChips::ask_kind(const ReadStroke& read, QWidget& chip) {
  const Stroke* stroke = find_stroke(studio_.drawing(), read.stroke);
  if (stroke == nullptr) return;
  auto* menu = new QMenu(&chip);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setObjectName("kinds");
  const auto offer = [&](StrokeKind kind, const QString& text) {
    QAction* action = menu->addAction(text);
    action->setObjectName(QString::fromStdString("kind-" + silhouette::to_string(kind)));
    action->setCheckable(true);
    action->setChecked(kind == (read.chosen ? read.kind : StrokeKind::Visible));
    connect(action, &QAction::triggered, this, [this, kind, id = read.stroke] { set({id, kind}, false); });
  };
  offer(StrokeKind::Visible, tr("As read from the drawing"));
  menu->addSeparator();
  for (const StrokeKind kind : kinds_for(*stroke)) offer(kind, word_of(kind));
  menu->popup(chip.mapToGlobal(QPoint(0, chip.height() + 2)));
}

void SketchChips::follow() {
  const auto result = studio_.result();
  const InflateResult* inflated = result_of<InflateResult>(result.get());
  const Drawing& drawing = studio_.drawing();
  const InflateResult none;
  const InflateResult& known = inflated == nullptr ? none : *inflated;
  bodies_ = bodies_of(drawing, result.get());
  const bool is_final = result && !result->failed && !result->stale && result->quality == Quality::Final;
  joints_ = joints_of(known, attach(), is_final);
  // Limbs of one line grow out of what they touch without being asked, and the next stroke may begin there.
  std::erase_if(joints_, [&](const Joint& joint) { return is_tube(known, joint.a) || is_tube(known, joint.b); });
  nested_ = nested_outlines(known, drawing);
  crossings_ = crossings_in_view(known, drawing);
  swaps_ = known.tube_swaps;
  kinds_ = read_strokes(known, drawing, tool_.selected());
  const ChosenPart part = chosen_part(known, drawing, tool_.selected());
  const auto chips_of = [this](const auto& items) {
    std::vector<ChipRow::Chip> chips;
    for (const auto& item : items) chips.push_back(chip_of(item));
    return chips;
  };
  std::vector<ChipRow::Chip> joint_chips;
  for (const Joint& joint : joints_) {
    joint_chips.push_back(chip_of(joint));
    for (const NestedStroke& nested : nested_) {
      const Stroke* outline = find_stroke(drawing, nested.stroke);
      const bool is_inner = joint.a == nested.stroke || joint.b == nested.stroke;
      if (is_inner && outline != nullptr) joint_chips.back() = beside(joint_chips.back(), *outline, false);
    }
  }
  joint_row_.show(std::move(joint_chips));
  nested_row_.show(chips_of(nested_));
  crossing_row_.show(chips_of(crossings_));
  tube_row_.show(chips_of(swaps_));
  std::vector<ChipRow::Chip> kind_chips;
  std::ranges::transform(kinds_, std::back_inserter(kind_chips), kind_chip);
  kind_row_.show(std::move(kind_chips));
  thickness_.follow(part, name_of(part.stroke));
}

void SketchChips::place(ChipPlaces& places, bool shown) {
  thickness_.place(places, shown);
  crossing_row_.place(places, shown);
  tube_row_.place(places, shown);
  nested_row_.place(places, shown);
  joint_row_.place(places, shown);
  kind_row_.place(places, shown, tool_.mode() == SketchMode::Draw);
}

// ---- What they do

void SketchChips::join_all() {
  AttachText text = attach();
  for (const Joint& joint : joints_) {
    if (joint.hold != Hold::Joined) text = with_hold(std::move(text), joint, Hold::Joined);
  }
  if (joints_.empty()) return;
  studio_.set_parameter(studio_.solid_node(), "attach", to_text(text), false, tr("Join all parts").toStdString());
}

/// Of the solid; nothing while the text has mistakes, which findings name.
AttachText SketchChips::attach() const {
  const Node* operation = studio_.solid_operation();
  const auto result = studio_.result();
  const InflateResult* inflated = result_of<InflateResult>(result.get());
  if (operation == nullptr || inflated == nullptr) return {};
  const auto text = operation->parameters.find("attach");
  if (text == operation->parameters.end()) return {};
  try {
    return with_object_names(read_attach_text(std::get<std::string>(text->second)), *inflated);
  } catch (const Error&) {
    return {};
  }
}

void SketchChips::set_attach(const AttachText& attach, const QString& step, bool dragging) {
  const Node* operation = studio_.solid_operation();
  if (operation == nullptr) return;
  const std::string name = operation->name;
  const std::string text = to_text(attach);
  studio_.set_parameter(studio_.solid_node(), "attach", text, dragging, step.toStdString());
  if (!dragging) emit committed(recorded::Set{name, "attach", text});
}

void SketchChips::set(const recorded::StrokeReading& setting, bool dragging) {
  if (find_stroke(studio_.drawing(), setting.stroke) == nullptr) return;
  if (tool_.set(setting, dragging) == Verdict::Commit) emit committed(*tool_.done());
}

}  // namespace croquis::app
