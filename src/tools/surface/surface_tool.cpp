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

NetworkElements elements_in(const Selection& selection, NodeId node, const AttributeNetwork& network) {
  NetworkElements elements;
  for (const NetworkElement kind : kinds_of_element) {
    for (const std::string& id : element_ids(network, kind)) {
      if (std::ranges::binary_search(selection, SelectedItem{node, selected_part(kind, id)}))
        elements.of(kind).push_back(id);
    }
  }
  return elements;
}

// ---- What lies under the pointer

std::optional<PickedPlace> pick(const SurfaceTool& tool, const ViewFrame& frame, const Vec2& pixel, double reach) {
  const auto now = tool.network();
  if (!now) return std::nullopt;
  if (auto point = nearest_point_attribute(*now, frame, pixel, reach)) return point;
  if (tool.mode() == SurfaceMode::Point) return std::nullopt;
  if (auto handle = nearest_handle(*now, tool.selected().curves, frame, pixel, reach)) return handle;
  if (auto node = nearest_node(*now, frame, pixel, reach)) return node;
  return nearest_curve(*now, frame, pixel, reach);
}

/// What a stroke or a press there would go to.
SurfacePreview seen_at(const SurfaceTool& tool, const SurfaceToolOptions& options, const ViewFrame& frame,
                       const Vec2& pixel) {
  SurfacePreview seen;
  const auto now = tool.network();
  if (tool.mode() == SurfaceMode::Draw) {
    seen.snap = now ? snap_at(*now, frame, pixel, options.snap_pixels) : std::nullopt;
  } else if (tool.mode() == SurfaceMode::Patch) {
    seen.loop = loop_at(now, frame, pixel);
  } else {
    seen.hovered = pick(tool, frame, pixel, options.pick_pixels);
  }
  const bool is_free = !seen.snap && !seen.hovered && tool.mode() != SurfaceMode::Patch;
  const auto& sight = tool.settings().sight;
  if (is_free && sight) seen.hit = sight->patch_under(frame.ray(pixel));
  return seen;
}

bool shows_same(const SurfacePreview& a, const SurfacePreview& b) {
  const auto snap_place = [](const SurfacePreview& one) {
    return one.snap ? std::optional(one.snap->place) : std::nullopt;
  };
  const auto loop_sides = [](const SurfacePreview& one) {
    return one.loop ? one.loop->loop.sides : std::vector<AttributeSide>();
  };
  const auto hit_point = [](const SurfacePreview& one) {
    return one.hit ? std::optional(one.hit->point) : std::nullopt;
  };
  return snap_place(a) == snap_place(b) && a.hovered == b.hovered && loop_sides(a) == loop_sides(b) &&
         hit_point(a) == hit_point(b);
}

// ---- Gestures

/// A gesture that begins, with what lies under it.
SurfaceGesture begun_at(const SurfaceTool& tool, const SurfaceToolOptions& options, const MeshEvent& event) {
  const auto& sight = tool.settings().sight;
  SurfaceGesture now;
  now.start = event;
  now.last = event.pixel;
  if (tool.mode() == SurfaceMode::Draw) {
    now.kind = SurfaceGesture::Kind::Draw;
    now.from = snap_at(or_empty(tool.network()), event.frame, now.last, options.snap_pixels);
    add_sample(now, sight.get());
    return now;
  }
  if (tool.mode() == SurfaceMode::Patch) return now;
  const double reach = options.pick_pixels;
  now.picked = pick(tool, event.frame, now.last, reach);
  const bool is_handle = now.picked && (now.picked->control || now.picked->kind == NetworkElement::Point);
  if (!is_handle && tool.mode() == SurfaceMode::Select)
    now.tip = nearest_tip(slopes_of(tool), event.frame, now.last, reach);
  if (!is_handle && !now.tip && passes(ring_of(tool), event.frame, now.last, reach))
    now.ring = tool.selected().points.front();
  if (!now.picked && !now.tip && now.ring.empty() && sight) now.hit = sight->patch_under(event.frame.ray(now.last));
  return now;
}

/// What a press becomes that moves.
SurfaceGesture::Kind kind_of_drag(const SurfaceGesture& press, SurfaceMode mode) {
  const bool pulls = mode == SurfaceMode::Point && press.hit;
  const bool holds = press.picked || press.tip || !press.ring.empty() || pulls;
  if (mode == SurfaceMode::Patch || !holds) return SurfaceGesture::Kind::Box;
  if (press.picked && press.picked->control) return SurfaceGesture::Kind::Handle;
  if (press.tip) return SurfaceGesture::Kind::Slope;
  if (!press.ring.empty()) return SurfaceGesture::Kind::Ring;
  return pulls ? SurfaceGesture::Kind::Pull : SurfaceGesture::Kind::Move;
}

void preview_stroke(SurfacePreview& preview, const SurfaceGesture& now, const SurfaceTool& tool,
                    const SurfaceToolOptions& options) {
  const AttributeNetwork network = or_empty(tool.network());
  preview.snap = now.stroke.size() == 1 ? now.from : snap_at(network, now.start.frame, now.last, options.snap_pixels);
  const bool moved = is_far(now, now.last, options.drag_pixels);
  const StrokeInSpace stroke =
      stroke_in_space(now, tool.settings(), network, moved ? preview.snap : std::optional<SurfaceSnap>());
  preview.face = stroke.face;
  preview.plane = stroke.plane;
  preview.ink = stroke.points;
}

std::optional<recorded::SurfaceStroke> drawn_step(const SurfaceGesture& gesture, const SurfaceTool& tool,
                                                  const SurfaceToolOptions& options) {
  const auto now = tool.network();
  const bool is_long = std::ranges::any_of(
      gesture.stroke, [&](const auto& sample) { return is_far(gesture, sample.pixel, options.drag_pixels); });
  const auto end =
      is_long && now ? snap_at(*now, gesture.start.frame, gesture.last, options.snap_pixels) : std::nullopt;
  return stroke_step(gesture, stroke_in_space(gesture, tool.settings(), or_empty(now), end), end);
}

/// Fills a loop, or picks the patch that fills it already.
recorded::Step patch_step(const AttributeNetwork& network, const LoopAround& around) {
  if (around.face) return recorded::SurfaceChoice{one_element(NetworkElement::Face, network.faces[*around.face].id)};
  std::vector<std::string> curves;
  for (const AttributeSide& side : around.loop.sides) curves.push_back(network.curves[side.curve].id);
  return recorded::SurfacePatch{curves};
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
  const auto now = network();
  return now ? elements_in(session_.selection(), node(), *now) : NetworkElements();
}

void SurfaceTool::select(const NetworkElements& elements) {
  Selection selection;
  for (const NetworkElement kind : kinds_of_element) {
    for (const std::string& id : elements.of(kind)) selection.push_back({node(), selected_part(kind, id)});
  }
  session_.select(std::move(selection));
}

std::vector<ControlHandle> handles_of(const SurfaceTool& tool) {
  const auto now = tool.network();
  return now ? free_handles(*now, tool.selected().curves) : std::vector<ControlHandle>();
}

std::vector<SlopeTip> slopes_of(const SurfaceTool& tool) {
  const std::vector<std::string> curves = tool.selected().curves;
  const auto& sight = tool.settings().sight;
  if (!sight || curves.size() != 1) return {};
  return slope_tips(*tool.network(), curves.front(), *sight);
}

std::vector<Vec3> ring_of(const SurfaceTool& tool) {
  const std::vector<std::string> points = tool.selected().points;
  const auto& sight = tool.settings().sight;
  if (!sight || points.size() != 1) return {};
  const auto& dragged = tool.preview().radius;
  const auto radius = dragged ? dragged : sight->radius_of(points.front());
  return radius ? sight->ring_of(points.front(), *radius) : std::vector<Vec3>();
}

// ---- Hovering

bool SurfaceTool::hover(const Vec2& pixel, const ViewFrame& frame) {
  if (active() || !pixel.allFinite()) return false;
  const SurfacePreview before = std::exchange(preview_, seen_at(*this, options_, frame, pixel));
  return !shows_same(before, preview_);
}

bool SurfaceTool::leave() {
  if (active()) return false;
  const bool had = preview_.snap || preview_.hovered || preview_.hit || preview_.loop;
  preview_ = {};
  return had;
}

// ---- Gestures

Verdict SurfaceTool::handle(const MeshEvent& event) {
  const bool is_finite = event.pixel.allFinite();
  const bool begins = event.kind == PenStep::Kind::Begin;
  if (event.kind == PenStep::Kind::Cancel || (begins && !is_finite)) return give_up();
  if (begins) {
    give_up();
    notes_.clear();
    preview_ = {};
    gesture_ = std::make_unique<SurfaceGesture>(begun_at(*this, options_, event));
    if (gesture_->kind == SurfaceGesture::Kind::Draw) preview_stroke(preview_, *gesture_, *this, options_);
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

void SurfaceTool::go_on(const MeshEvent& event) {
  SurfaceGesture& now = *gesture_;
  const bool moved = event.pixel != now.last;
  now.last = event.pixel;
  if (now.kind == SurfaceGesture::Kind::Draw) {
    if (moved) add_sample(now, settings_.sight.get());
    return preview_stroke(preview_, now, *this, options_);
  }
  if (now.kind == SurfaceGesture::Kind::Press && is_far(now, now.last, options_.drag_pixels)) {
    now.kind = kind_of_drag(now, mode_);
    if (now.kind != SurfaceGesture::Kind::Box)
      now.original = std::make_shared<const AttributeNetwork>(or_empty(network()));
    if (now.original && symmetry_) now.partners = find_partners(*now.original, *symmetry_, tolerance_of(*now.original));
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
  if (const auto* step = now.step->as<recorded::SurfaceDrag>()) {
    preview_.moved = step->by;
    if (!step->into.empty()) preview_.snap = SurfaceSnap{{step->into, {}, 0}, now.picked->place + step->by};
  }
  if (const auto* step = now.step->as<recorded::SurfacePointSetting>()) preview_.radius = *step->setting.radius;
  drag_.to(with_network(on_both_sides(*now.original, std::move(edit.network), symmetry_, now.partners)));
}

Verdict SurfaceTool::finish() {
  const std::unique_ptr<const SurfaceGesture> gesture = std::exchange(gesture_, nullptr);
  preview_ = {};
  const auto now = network();
  if (gesture->kind == SurfaceGesture::Kind::Draw) {
    const auto step = drawn_step(*gesture, *this, options_);
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
    const auto around = loop_at(now, gesture->start.frame, gesture->start.pixel);
    if (around) return take(patch_step(*now, *around));
    notes_ = {make_warning(Category::Geometry, "E_OPEN_LOOP",
                           "No closed loop of 2 to 12 curves goes around this place: close the gaps, or select the "
                           "curves of the loop.")};
    return Verdict::Revert;
  }
  const auto& hit = gesture->hit;
  if (clicks && mode_ == SurfaceMode::Point && hit && !gesture->picked)
    return take(recorded::SurfacePoint{{hit->face, hit->point, hit->fan, {}, {}}});
  return take(recorded::SurfaceChoice{chosen_by(*gesture, selected(), now)});
}

}  // namespace croquis
