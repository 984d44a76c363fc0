// SPDX-License-Identifier: GPL-3.0-or-later
// What gestures lead to. Where strokes lie and what drags do stands in surface_gesture.cpp, what steps make of a
// network in network_edit.cpp.
#include "croquis/tools/surface/surface_tool.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/tools/strokes/stroke_source.h"
#include "tools/surface/network_edit.h"
#include "tools/surface/surface_gesture.h"

namespace croquis {
namespace {

constexpr NetworkElement kinds_of_element[] = {NetworkElement::Node, NetworkElement::Curve, NetworkElement::Face,
                                               NetworkElement::Point};
constexpr const char* part_words[] = {"node ", "curve ", "face ", "point "};

AttributeNetwork or_empty(const std::shared_ptr<const AttributeNetwork>& network) {
  return network ? *network : AttributeNetwork();
}

AttributeNetwork on_both_sides(const AttributeNetwork& before, AttributeNetwork after,
                               const std::optional<SymmetryPlane>& symmetry,
                               const std::optional<NetworkPartners>& known = {}) {
  if (!symmetry) return after;
  const NetworkPartners partners = known ? *known : find_partners(before, *symmetry, tolerance_of(before));
  return with_symmetric_edit(before, after, *symmetry, partners);
}

/// Adds elements that aren't there, takes away those that are.
void toggle(NetworkElements& elements, NetworkElement kind, const std::string& id) {
  if (std::erase(elements.of(kind), id) == 0) elements.of(kind).push_back(id);
}

std::optional<LoopAround> loop_at(const std::shared_ptr<const AttributeNetwork>& network, const ViewFrame& frame,
                                  const Vec2& pixel) {
  if (!network) return std::nullopt;
  return find_loop_around(*network, viewed_curves(*network, frame), pixel, {tolerance_of(*network), 12});
}

bool is_far(const SurfaceGesture& gesture, const Vec2& pixel, double reach) {
  return (pixel - gesture.start.pixel).norm() > reach;
}

/// What a click or a box has selected. @param before what was: Shift adds to it
NetworkElements chosen_by(const SurfaceGesture& gesture, const NetworkElements& before,
                          const std::shared_ptr<const AttributeNetwork>& network) {
  NetworkElements elements = gesture.start.modifiers.shift ? before : NetworkElements();
  if (gesture.kind == SurfaceGesture::Kind::Box && network) {
    const PickBox box = PickBox::spanned(gesture.start.pixel, gesture.last);
    const NetworkElements found = elements_in_box(*network, gesture.start.frame, box);
    for (const NetworkElement kind : {NetworkElement::Node, NetworkElement::Curve, NetworkElement::Point}) {
      for (const std::string& id : found.of(kind)) {
        if (!elements.has(kind, id)) elements.of(kind).push_back(id);
      }
    }
  }
  if (gesture.kind == SurfaceGesture::Kind::Box) return elements;
  if (gesture.picked && !gesture.picked->control) {
    toggle(elements, gesture.picked->kind, gesture.picked->id);
  } else if (gesture.picked || gesture.tip || !gesture.ring.empty()) {
    return before;  // a handle was only touched
  } else if (gesture.hit) {
    toggle(elements, NetworkElement::Face, gesture.hit->face);
  }
  return elements;
}

}  // namespace

std::string selected_part(NetworkElement kind, const std::string& id) {
  return part_words[static_cast<std::size_t>(kind)] + id;
}

Document add_network(const Document& document, AttributeNetwork network, const SurfaceToolOptions& options) {
  return with_stroke_source(document, std::make_shared<const AttributeNetwork>(std::move(network)), options, {});
}

recorded::SurfaceJoin other_join(const AttributeNetwork& network, const std::vector<std::string>& curves) {
  const bool all_smooth = std::ranges::all_of(curves, [&](const std::string& id) {
    return network.curves[require_element(network, NetworkElement::Curve, id)].join == CurveJoin::Smooth;
  });
  return {curves, all_smooth ? CurveJoin::Crease : CurveJoin::Smooth};
}

SurfaceTool::SurfaceTool(Session& session, SurfaceToolOptions options)
    : session_(session), options_(std::move(options)), drag_(session) {}

SurfaceTool::~SurfaceTool() = default;

void SurfaceTool::set_mode(SurfaceMode mode) {
  give_up();
  leave();
  mode_ = mode;
}

// ---- The document

NodeId SurfaceTool::node() const { return source_node<AttributeNetwork>(session_.document(), settings_.node); }

std::shared_ptr<const AttributeNetwork> SurfaceTool::network() const {
  return source_of<AttributeNetwork>(session_.document().find(node()));
}

NodeId SurfaceTool::operation_node() const { return operation_on(session_.document(), node(), options_.port); }

Document SurfaceTool::with_network(AttributeNetwork network) const {
  const NodeId own = node();
  if (own == 0) return add_network(session_.document(), std::move(network), options_);
  Node edited = *session_.document().find(own);
  edited.source = std::make_shared<const AttributeNetwork>(std::move(network));
  return session_.document().with(std::move(edited));
}

Verdict SurfaceTool::take(const recorded::Step& step) {
  const std::uint64_t state = session_.state();
  if (const auto* choice = step.as<recorded::SurfaceChoice>()) {
    const Selection selection = session_.selection();
    select(choice->elements);
    if (session_.selection() == selection) return Verdict::Continue;
  } else if (const auto* symmetry = step.as<recorded::SurfaceSymmetry>()) {
    if (symmetry->plane == symmetry_) return Verdict::Continue;
    give_up();
    symmetry_ = symmetry->plane;
  } else if (const auto* set = step.as<recorded::SurfaceFaceSetting>(); set && set->turned && set->setting.any()) {
    take(recorded::SurfaceFaceSetting{set->faces, {}, true});
    return take(recorded::SurfaceFaceSetting{set->faces, set->setting, false});
  } else {
    std::optional<NetworkEdit> edit = edited_by(or_empty(network()), step);
    if (!edit) throw Error(make_error(Category::Usage, "E_INPUT", "This step is none of the surface tool."));
    if (edit->notes) notes_ = *std::move(edit->notes);
    if (edit->label.empty()) return Verdict::Revert;
    give_up();
    const AttributeNetwork before = or_empty(network());
    const bool has_both_sides = step.as<recorded::SurfaceMirror>() != nullptr;
    session_.edit(edit->label, with_network(on_both_sides(before, std::move(edit->network),
                                                          has_both_sides ? std::nullopt : symmetry_)));
    if (step.as<recorded::SurfacePoint>())
      select(one_element(NetworkElement::Point, new_element_id(before, NetworkElement::Point)));
    if (session_.state() == state) return Verdict::Continue;
  }
  done_ = step;
  return Verdict::Commit;
}

// ---- What is selected, and what can be dragged then

NetworkElements SurfaceTool::selected() const {
  NetworkElements elements;
  const auto now = network();
  if (!now) return elements;
  const NodeId own = node();
  for (const NetworkElement kind : kinds_of_element) {
    for (const std::string& id : element_ids(*now, kind)) {
      const SelectedItem item{own, selected_part(kind, id)};
      if (std::ranges::binary_search(session_.selection(), item)) elements.of(kind).push_back(id);
    }
  }
  return elements;
}

void SurfaceTool::select(const NetworkElements& elements) {
  Selection selection;
  for (const NetworkElement kind : kinds_of_element) {
    for (const std::string& id : elements.of(kind)) selection.push_back({node(), selected_part(kind, id)});
  }
  session_.select(std::move(selection));
}

std::vector<ControlHandle> SurfaceTool::handles() const {
  const auto now = network();
  return now ? free_handles(*now, selected().curves) : std::vector<ControlHandle>();
}

std::vector<SlopeTip> SurfaceTool::slopes() const {
  const std::vector<std::string> curves = selected().curves;
  if (!settings_.sight || curves.size() != 1) return {};
  return slope_tips(*network(), curves.front(), *settings_.sight);
}

std::vector<Vec3> SurfaceTool::ring() const {
  const std::vector<std::string> points = selected().points;
  if (!settings_.sight || points.size() != 1) return {};
  const auto radius = preview_.radius ? preview_.radius : settings_.sight->radius_of(points.front());
  return radius ? settings_.sight->ring_of(points.front(), *radius) : std::vector<Vec3>();
}

// ---- Hovering

bool SurfaceTool::hover(const Vec2& pixel, const ViewFrame& frame) {
  if (active() || !pixel.allFinite()) return false;
  const SurfacePreview before = std::exchange(preview_, {});
  const auto now = network();
  if (mode_ == SurfaceMode::Draw) {
    preview_.snap = now ? snap_at(*now, frame, pixel, options_.snap_pixels) : std::nullopt;
  } else if (mode_ == SurfaceMode::Patch) {
    preview_.loop = loop_at(now, frame, pixel);
  } else {
    preview_.hovered = pick(frame, pixel);
  }
  const bool is_free = !preview_.snap && !preview_.hovered && mode_ != SurfaceMode::Patch;
  if (is_free && settings_.sight) preview_.hit = settings_.sight->patch_under(frame.ray(pixel));
  const auto snap_place = [](const SurfacePreview& one) {
    return one.snap ? std::optional(one.snap->place) : std::nullopt;
  };
  const auto loop_sides = [](const SurfacePreview& one) {
    return one.loop ? one.loop->loop.sides : std::vector<AttributeSide>();
  };
  const auto hit_point = [](const SurfacePreview& one) {
    return one.hit ? std::optional(one.hit->point) : std::nullopt;
  };
  return snap_place(before) != snap_place(preview_) || before.hovered != preview_.hovered ||
         loop_sides(before) != loop_sides(preview_) || hit_point(before) != hit_point(preview_);
}

bool SurfaceTool::leave() {
  if (active()) return false;
  const bool had = preview_.snap || preview_.hovered || preview_.hit || preview_.loop;
  preview_ = {};
  return had;
}

std::optional<PickedPlace> SurfaceTool::pick(const ViewFrame& frame, const Vec2& pixel) const {
  const auto now = network();
  if (!now) return std::nullopt;
  const double reach = options_.pick_pixels;
  if (auto point = nearest_point_attribute(*now, frame, pixel, reach)) return point;
  if (mode_ == SurfaceMode::Point) return std::nullopt;
  if (auto handle = nearest_handle(*now, selected().curves, frame, pixel, reach)) return handle;
  if (auto node = nearest_node(*now, frame, pixel, reach)) return node;
  return nearest_curve(*now, frame, pixel, reach);
}

// ---- Gestures

Verdict SurfaceTool::handle(const MeshEvent& event) {
  const bool is_finite = event.pixel.allFinite();
  const bool begins = event.kind == PenStep::Kind::Begin;
  if (event.kind == PenStep::Kind::Cancel || (begins && !is_finite)) return give_up();
  if (begins) {
    give_up();
    begin(event);
    return Verdict::Continue;
  }
  if (!active()) return Verdict::Continue;
  if (drag_.interrupted()) return give_up();
  if (is_finite) go_on(event);
  return event.kind == PenStep::Kind::End ? finish() : Verdict::Continue;
}

Verdict SurfaceTool::give_up() {
  if (!active()) return Verdict::Continue;
  gesture_.reset();
  preview_ = {};
  drag_.cancel();
  return Verdict::Revert;
}

void SurfaceTool::begin(const MeshEvent& event) {
  notes_.clear();
  preview_ = {};
  gesture_ = std::make_unique<SurfaceGesture>();
  SurfaceGesture& now = *gesture_;
  now.start = event;
  now.last = event.pixel;
  if (mode_ == SurfaceMode::Draw) {
    now.kind = SurfaceGesture::Kind::Draw;
    now.from = snap_at(or_empty(network()), event.frame, now.last, options_.snap_pixels);
    add_sample(now, settings_.sight.get());
    preview_stroke();
    return;
  }
  if (mode_ == SurfaceMode::Patch) return;
  now.picked = pick(event.frame, now.last);
  const bool is_handle = now.picked && (now.picked->control || now.picked->kind == NetworkElement::Point);
  if (!is_handle && mode_ == SurfaceMode::Select)
    now.tip = nearest_tip(slopes(), event.frame, now.last, options_.pick_pixels);
  if (!is_handle && !now.tip && passes(ring(), event.frame, now.last, options_.pick_pixels))
    now.ring = selected().points.front();
  if (!now.picked && !now.tip && now.ring.empty() && settings_.sight)
    now.hit = settings_.sight->patch_under(event.frame.ray(now.last));
}

void SurfaceTool::go_on(const MeshEvent& event) {
  SurfaceGesture& now = *gesture_;
  const bool moved = event.pixel != now.last;
  now.last = event.pixel;
  if (now.kind == SurfaceGesture::Kind::Draw) {
    if (moved) add_sample(now, settings_.sight.get());
    return preview_stroke();
  }
  const bool drags = now.kind == SurfaceGesture::Kind::Press && is_far(now, now.last, options_.drag_pixels);
  const bool pulls = mode_ == SurfaceMode::Point && now.hit;
  const bool holds = mode_ != SurfaceMode::Patch && (now.picked || now.tip || !now.ring.empty() || pulls);
  if (drags && !holds) now.kind = SurfaceGesture::Kind::Box;
  if (drags && holds) {
    now.original = std::make_shared<const AttributeNetwork>(or_empty(network()));
    if (symmetry_) now.partners = find_partners(*now.original, *symmetry_, tolerance_of(*now.original));
    now.kind = now.tip             ? SurfaceGesture::Kind::Slope
               : !now.ring.empty() ? SurfaceGesture::Kind::Ring
               : pulls             ? SurfaceGesture::Kind::Pull
                                   : SurfaceGesture::Kind::Move;
    if (now.picked && now.picked->control) now.kind = SurfaceGesture::Kind::Handle;
    if (now.kind == SurfaceGesture::Kind::Move) {
      now.moving = selected();
      if (!now.moving.has(now.picked->kind, now.picked->id)) {
        if (!now.start.modifiers.shift) now.moving = {};
        now.moving.of(now.picked->kind).push_back(now.picked->id);
        select(now.moving);
      }
    }
  }
  if (now.kind == SurfaceGesture::Kind::Box) preview_.box = PickBox::spanned(now.start.pixel, now.last);
  if (now.original) drag();
}

void SurfaceTool::drag() {
  SurfaceGesture& now = *gesture_;
  now.step = dragged_step(now, settings_.sight.get(), options_.snap_pixels);
  NetworkEdit edit = *edited_by(*now.original, *now.step);
  if (!drag_.begun())
    drag_.begin(now.kind == SurfaceGesture::Kind::Ring ? "Set radius of point " + now.ring : edit.label);
  preview_.snap.reset();
  if (const auto* step = now.step->as<recorded::SurfaceDrag>(); step != nullptr && !step->into.empty())
    preview_.snap = SurfaceSnap{{step->into, {}, 0}, now.picked->place + step->by};
  if (const auto* step = now.step->as<recorded::SurfacePointSetting>()) preview_.radius = *step->setting.radius;
  drag_.to(with_network(on_both_sides(*now.original, std::move(edit.network), symmetry_, now.partners)));
}

void SurfaceTool::preview_stroke() {
  const SurfaceGesture& now = *gesture_;
  const AttributeNetwork network = or_empty(this->network());
  preview_.snap = now.stroke.size() == 1 ? now.from : snap_at(network, now.start.frame, now.last, options_.snap_pixels);
  const bool moved = is_far(now, now.last, options_.drag_pixels);
  const StrokeInSpace stroke =
      stroke_in_space(now, settings_, network, moved ? preview_.snap : std::optional<SurfaceSnap>());
  preview_.face = stroke.face;
  preview_.plane = stroke.plane;
  preview_.ink = stroke.points;
}

Verdict SurfaceTool::finish() {
  const std::unique_ptr<const SurfaceGesture> gesture = std::exchange(gesture_, nullptr);
  preview_ = {};
  const auto now = network();
  const ViewFrame& frame = gesture->start.frame;
  if (gesture->kind == SurfaceGesture::Kind::Draw) {
    const bool is_long = std::ranges::any_of(
        gesture->stroke, [&](const auto& sample) { return is_far(*gesture, sample.pixel, options_.drag_pixels); });
    const auto end = is_long && now ? snap_at(*now, frame, gesture->last, options_.snap_pixels) : std::nullopt;
    const auto step = stroke_step(*gesture, stroke_in_space(*gesture, settings_, or_empty(now), end), end);
    return step ? take(*step) : Verdict::Revert;
  }
  if (gesture->original) {
    done_ = gesture->step;
    drag_.end();
    if (gesture->kind == SurfaceGesture::Kind::Pull)
      select(one_element(NetworkElement::Point, new_element_id(*gesture->original, NetworkElement::Point)));
    return Verdict::Commit;
  }
  const bool clicks = gesture->kind == SurfaceGesture::Kind::Press;
  if (clicks && mode_ == SurfaceMode::Patch) {
    const auto around = loop_at(now, frame, gesture->start.pixel);
    if (!around) {
      notes_ = {make_warning(Category::Geometry, "E_OPEN_LOOP",
                             "No closed loop of 2 to 12 curves goes around this place: close the gaps, or select the "
                             "curves of the loop.")};
      return Verdict::Revert;
    }
    if (around->face)
      return take(recorded::SurfaceChoice{one_element(NetworkElement::Face, now->faces[*around->face].id)});
    std::vector<std::string> curves;
    for (const AttributeSide& side : around->loop.sides) curves.push_back(now->curves[side.curve].id);
    return take(recorded::SurfacePatch{curves});
  }
  const auto& hit = gesture->hit;
  if (clicks && mode_ == SurfaceMode::Point && hit && !gesture->picked)
    return take(recorded::SurfacePoint{{hit->face, hit->point, hit->fan, {}, {}}});
  return take(recorded::SurfaceChoice{chosen_by(*gesture, selected(), now)});
}

}  // namespace croquis
