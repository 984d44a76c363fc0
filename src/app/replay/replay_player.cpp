// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/replay/replay_player.h"

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <set>
#include <utility>
#include <variant>

#include "app/tools/holes/hole_filling_tool.h"
#include "app/tools/mesh/mesh_editing_tool.h"
#include "app/tools/silhouette/silhouette_tool.h"
#include "app/views/viewport.h"
#include "app/window/main_window.h"
#include "croquis/base/error.h"
#include "croquis/base/exit_code.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/io/file.h"
#include "croquis/operators/inflate_result.h"
#include "croquis/operators/subdivide_result.h"

namespace croquis::app {
namespace {

constexpr int longest_wait_ms = 60'000;
constexpr int replay_pause_ms = 20;
constexpr double degrees_per_radian = 180 / std::numbers::pi;
constexpr double recorded_view_height = 1000;  // pixels in which motions are recorded

[[noreturn]] void refuse(const std::string& sentence) {
  throw Error(make_error(Category::Geometry, "E_REPLAY", sentence));
}

Modifiers modifiers_of(const std::vector<std::string>& names) {
  const auto has = [&](const char* name) { return std::find(names.begin(), names.end(), name) != names.end(); };
  return {has("shift"), has("ctrl"), has("alt"), has("super")};
}

StrokeSample sample_at(const Vec2& place) {
  StrokeSample sample;
  sample.position = place;
  return sample;
}

CameraMotion::Kind kind_of(const std::string& motion) {
  if (motion == "track") return CameraMotion::Kind::Track;
  return motion == "dolly" ? CameraMotion::Kind::Dolly : CameraMotion::Kind::Tumble;
}

int view_of(const std::string& name) {
  const std::vector<std::string> names{"front", "perspective", "top", "side", "comparison"};
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? View::SketchView : static_cast<int>(found - names.begin());
}

/// Parts of the sketch's solid, and meshes that are shown.
std::size_t count_objects(const Studio& studio) {
  std::size_t count = 0;
  const auto result = studio.result();
  if (result && !result->failed) {
    const InflateResult* inflated = result->result<InflateResult>();
    if (inflated != nullptr) count += inflated->objects.size();
  }
  for (const StudioObject& object : studio.objects()) count += object.visible && object.node != studio.solid_node();
  return count;
}

const StudioObject& object_named(const Studio& studio, const std::string& name) {
  const StudioObject* found = name.empty() ? studio.active() : nullptr;
  for (const StudioObject& object : studio.objects()) {
    const Node* node = studio.session().document().find(object.node);
    if (!name.empty() && (object.name == name || node->name == name)) found = &object;
  }
  if (found == nullptr) refuse(name.empty() ? "There is no object" : "There is no object \"" + name + "\"");
  if (!found->shown()) refuse("\"" + found->name + "\" has no mesh");
  return *found;
}

std::size_t count_in_mesh(const StudioObject& object, const std::string& what) {
  const PolyMesh& mesh = *object.shown();
  if (what == "vertices") return mesh.vertex_count();
  if (what == "faces") return mesh.face_count();
  if (what == "sharp-edges") return mesh.tags.creases.size();
  return MeshTopology(mesh).edge_count();
}

std::size_t count_selected(MainWindow& window) {
  HoleInteraction& holes = window.tool<HoleFillingTool>().holes();
  return holes.active() ? holes.selected().size() : window.studio().session().components().elements.size();
}

/// Those that are open or failed, or the patches that fill others.
std::size_t count_holes(const StudioObject& object, bool patches) {
  std::size_t open = 0;
  std::set<Index> numbers;
  for (const HoleRow& row : hole_rows(&object)) {
    open += row.state != HoleState::Filled;
    if (row.patch && row.state == HoleState::Filled) numbers.insert(*row.patch);
  }
  return patches ? numbers.size() : open;
}

void expect_dihedral(const Studio& studio, const recorded::Expect& step) {
  constexpr double tolerance = 1e-3;  // degrees
  const StudioObject& object = object_named(studio, step.node);
  const SubdivideResult* subdivided = result_of<SubdivideResult>(object.result.get());
  if (subdivided == nullptr || subdivided->chains.empty()) refuse("There are no chains of sharp edges");
  double least = 360;
  double greatest = 0;
  for (const SharpChain& chain : subdivided->chains) {
    least = std::min(least, chain.least_angle * degrees_per_radian);
    greatest = std::max(greatest, chain.greatest_angle * degrees_per_radian);
  }
  const double wanted_least = step.value.value_or(0);
  const double wanted_greatest = step.to.value_or(wanted_least);
  if (std::abs(least - wanted_least) <= tolerance && std::abs(greatest - wanted_greatest) <= tolerance) return;
  refuse("Expected angles from " + std::to_string(wanted_least) + " to " + std::to_string(wanted_greatest) +
         " degrees, but they are from " + std::to_string(least) + " to " + std::to_string(greatest));
}

}  // namespace

void wait_until_settled(MainWindow& window) {
  QElapsedTimer watch;
  watch.start();
  do {
    QApplication::processEvents(QEventLoop::AllEvents, replay_pause_ms);
    if (watch.elapsed() > longest_wait_ms) {
      throw Error(make_error(Category::Limit, "E_LIMIT", "The solid wasn't finished within a minute"));
    }
  } while (!window.settled());
  QApplication::processEvents();
}

void save_window_picture(MainWindow& window, const QString& path) {
  wait_until_settled(window);
  window.viewport().settle_now();
  QApplication::processEvents();
  if (!window.grab().save(path, "PNG")) {
    throw Error(make_error(Category::Io, "E_WRITE", "\"" + path.toStdString() + "\" can't be written"));
  }
}

void ReplayPlayer::play(const std::vector<recorded::Line>& lines) {
  window_.set_unattended();
  for (const recorded::Line& line : lines) play(line);
}

void ReplayPlayer::play(const recorded::Line& line) {
  try {
    std::visit(
        [this](const auto& step) {
          if constexpr (requires { this->play(step); }) {
            play(step);
          } else {
            refuse("The window can't replay this step");
          }
        },
        line.step);
  } catch (const Error& error) {
    Findings findings = error.findings();
    findings.front().message = "Line " + std::to_string(line.number) + ": " + findings.front().message;
    throw Error(std::move(findings));
  }
  QApplication::processEvents();
}

void ReplayPlayer::play(const recorded::StrokeDrawn& step) {
  if (window_.shows_start_page()) window_.start_sketch();
  window_.tool<SilhouetteTool>().sketch().replay_gesture(step.points, step.device == "eraser", {}, step.scale);
}

void ReplayPlayer::play(const recorded::Drag& step) {
  window_.tool<SilhouetteTool>().sketch().tool().drag(step.stroke, step.anchor, step.by);
}

void ReplayPlayer::play(const recorded::Action& step) {
  QAction* action = window_.action(QString::fromStdString(step.name));
  if (action == nullptr) refuse("The window has no action \"" + step.name + "\"");
  // Nothing acts on what the start page hides.
  if (!action->isEnabled() && window_.shows_start_page()) window_.show_views();
  if (!action->isEnabled()) refuse("The action \"" + step.name + "\" can't be used now");
  action->trigger();
}

void ReplayPlayer::play(const recorded::Set& step) {
  Studio& studio = window_.studio();
  for (const auto& node : studio.session().document().nodes()) {
    if (node->name != step.node && node->operation != step.node) continue;
    studio.set_parameter(node->id, step.parameter, step.value, false);
    return;
  }
  refuse("The document has no node \"" + step.node + "\"");
}

void ReplayPlayer::play(const recorded::Wait&) { wait_until_settled(window_); }

void ReplayPlayer::play(const recorded::Screenshot& step) {
  save_window_picture(window_, QString::fromStdString(step.file));
}

void ReplayPlayer::play(const recorded::File& step) {
  const QString file = QString::fromStdString(step.file);
  if (step.verb == "open") {
    window_.files().open(file);
  } else if (step.verb == "save") {
    window_.files().save(file);
  } else if (file.endsWith(".png")) {
    window_.export_picture(file);
  } else if (file.endsWith(".svg")) {
    window_.files().export_drawing(file);
  } else {
    wait_until_settled(window_);
    window_.files().export_solid(file);
  }
}

void ReplayPlayer::play(const recorded::Click& step) {
  if (step.place) {
    window_.tool<MeshEditingTool>().mesh().replay(view_of(step.view), *step.place, *step.place,
                                                  modifiers_of(step.modifiers), step.clicks);
    return;
  }
  window_.tool<SilhouetteTool>().sketch().replay_gesture({sample_at(step.at)}, false, modifiers_of(step.modifiers), 0);
}

void ReplayPlayer::play(const recorded::Box& step) {
  if (step.from_place && step.to_place) {
    window_.tool<MeshEditingTool>().mesh().replay(view_of(step.view), *step.from_place, *step.to_place,
                                                  modifiers_of(step.modifiers), 1);
    return;
  }
  const std::vector<StrokeSample> way{sample_at(step.from), sample_at((step.from + step.to) / 2), sample_at(step.to)};
  window_.tool<SilhouetteTool>().sketch().replay_gesture(way, false, modifiers_of(step.modifiers), 0);
}

void ReplayPlayer::play(const recorded::ModelDrag& step) {
  window_.tool<MeshEditingTool>().mesh().replay(view_of(step.view), step.from, step.to, modifiers_of(step.modifiers),
                                                1);
}

void ReplayPlayer::play(const recorded::Navigate& step) {
  ViewPane& pane = window_.viewport().pane(view_of(step.view));
  CameraMotion motion;
  motion.kind = kind_of(step.motion);
  motion.delta = step.by * (pane.rect.height() / recorded_view_height);
  motion.factor = std::exp((step.by.x() - step.by.y()) * NavigationOptions().dolly_per_pixel);
  motion.about = Vec2(pane.rect.width() / 2, pane.rect.height() / 2);
  pane.move(motion);
  window_.viewport().redraw_all();
}

void ReplayPlayer::play(const recorded::Expect& step) {
  wait_until_settled(window_);
  const Studio& studio = window_.studio();
  if (step.what == "dihedral") return expect_dihedral(studio, step);
  std::size_t count = 0;
  if (step.what == "objects")
    count = count_objects(studio);
  else if (step.what == "findings")
    count = studio.findings().size();
  else if (step.what == "strokes")
    count = studio.drawing().strokes.size();
  else if (step.what == "selected")
    count = count_selected(window_);
  else if (step.what == "holes" || step.what == "patches")
    count = count_holes(object_named(studio, step.node), step.what == "patches");
  else
    count = count_in_mesh(object_named(studio, step.node), step.what);
  if (static_cast<std::int64_t>(count) != step.count) {
    refuse("Expected " + std::to_string(step.count) + " " + step.what + ", but there are " + std::to_string(count));
  }
}

template <typename MeshStep>
void ReplayPlayer::play_on_mesh(const MeshStep& step) {
  Studio& studio = window_.studio();
  if (!step.node.empty()) studio.set_active(object_named(studio, step.node).node);
  MeshInteraction& mesh = window_.tool<MeshEditingTool>().mesh();
  mesh.follow();
  mesh.tool().replay(step);
  mesh.follow();
}

void ReplayPlayer::play(const recorded::Pick& step) {
  const MeshMode mode = step.kind == "vertex" ? MeshMode::Vertex
                        : step.kind == "face" ? MeshMode::Face
                                              : MeshMode::Edge;
  if (window_.tool<MeshEditingTool>().mesh().tool().mode() != mode)
    window_.tool<MeshEditingTool>().mesh().set_mode(mode);
  play_on_mesh(step);
}

void ReplayPlayer::play(const recorded::Move& step) { play_on_mesh(step); }
void ReplayPlayer::play(const recorded::Rotate& step) { play_on_mesh(step); }
void ReplayPlayer::play(const recorded::Scale& step) { play_on_mesh(step); }
void ReplayPlayer::play(const recorded::Tag& step) { play_on_mesh(step); }
void ReplayPlayer::play(const recorded::Pin& step) { play_on_mesh(step); }
void ReplayPlayer::play(const recorded::TagSet& step) { play_on_mesh(step); }
void ReplayPlayer::play(const recorded::Extrude& step) { play_on_mesh(step); }
void ReplayPlayer::play(const recorded::LoopCut& step) { play_on_mesh(step); }
void ReplayPlayer::play(const recorded::FaceSetChoice& step) {
  wait_until_settled(window_);
  window_.select_face_sets(object_named(window_.studio(), step.node).node, step.names);
}

template <typename HoleStep>
void ReplayPlayer::play_on_holes(const HoleStep& step) {
  if (!step.node.empty()) window_.studio().set_active(object_named(window_.studio(), step.node).node);
  HoleInteraction& holes = window_.tool<HoleFillingTool>().holes();
  if (!holes.active()) refuse("No holes are being worked on: the action \"holes\" opens them");
  wait_until_settled(window_);  // their numbers are known once they have been found
  holes.replay(step);
}

void ReplayPlayer::play(const recorded::HoleChoice& step) { play_on_holes(step); }
void ReplayPlayer::play(const recorded::HoleWay& step) { play_on_holes(step); }
void ReplayPlayer::play(const recorded::HolePoint& step) { play_on_holes(step); }

int print_findings(const Findings& findings) {
  for (const Finding& finding : findings) {
    const char* stop = finding.message.ends_with('.') ? "" : ".";
    std::fprintf(stderr, "croquis: %s: %s%s\n", finding.code.c_str(), finding.message.c_str(), stop);
  }
  return findings.empty() ? exit_internal : exit_code_of(findings.front().category);
}

int play_file(MainWindow& window, const QString& file, bool stay) {
  try {
    const std::string name = QFile::encodeName(file).toStdString();
    ReplayPlayer(window).play(recorded::parse(read_file(name), name));
  } catch (const Error& error) {
    return print_findings(error.findings());
  }
  return stay ? QApplication::exec() : 0;
}

}  // namespace croquis::app
