// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/start/gallery.h"

#include <QDir>
#include <QFile>
#include <QMetaObject>
#include <algorithm>
#include <map>

#include "app/views/offscreen_pictures.h"
#include "app/window/language.h"
#include "croquis/base/error.h"
#include "croquis/document/operation.h"
#include "croquis/io/attribute_network_file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/svg_drawing.h"
#include "croquis/tools/perspective/perspective_tool.h"

namespace croquis::app {
namespace {

const QString folder = QStringLiteral(":/sketches/");

const std::map<SampleKind, QString> sample_endings{{SampleKind::Sketch, ".svg"},
                                                   {SampleKind::Cage, ".obj"},
                                                   {SampleKind::Network, ".json"},
                                                   {SampleKind::Scan, ".ply"}};

QString folder_of(SampleKind kind) { return kind == SampleKind::Network ? folder + "surface/" : folder; }

Sample sample_of(const QString& file, SampleKind kind) {
  const QString name = file.chopped(sample_endings.at(kind).size());
  return {name, capitalized(QString(name).replace('_', ' ')), kind};
}

constexpr QSize picture_size(336, 252);  // twice a tile's, for screens of two pixels a point

}  // namespace

std::vector<Sample> samples() {
  std::vector<Sample> found;
  for (const auto& [kind, ending] : sample_endings) {
    for (const QString& file : QDir(folder_of(kind)).entryList({"*" + ending}, QDir::Files, QDir::Name)) {
      found.push_back(sample_of(file, kind));
    }
  }
  return found;
}

SampleKind kind_of_sample(const QString& name) {
  for (const auto& [kind, ending] : sample_endings) {
    if (QFile::exists(folder_of(kind) + name + ending)) return kind;
  }
  return SampleKind::Sketch;
}

std::string first_step_of_sample(const QString& name) {
  return kind_of_sample(name) == SampleKind::Cage ? "subdivide" : std::string();
}

QString first_action_of_sample(const QString& name) {
  return kind_of_sample(name) == SampleKind::Scan ? QStringLiteral("holes") : QString();
}

Value load_sample(const QString& name) {
  const SampleKind kind = kind_of_sample(name);
  const QString file_name = name + sample_endings.at(kind);
  QFile file(folder_of(kind) + file_name);
  if (!file.open(QIODevice::ReadOnly)) {
    throw Error(make_error(Category::Malformed, "E_FILE_OPEN",
                           "There is no shipped sample named \"" + name.toStdString() + "\""));
  }
  const QByteArray bytes = file.readAll();
  const std::string_view text(bytes.constData(), static_cast<std::size_t>(bytes.size()));
  Progress progress;
  if (kind == SampleKind::Sketch) {
    return std::make_shared<const Drawing>(read_svg_drawing(text, file_name.toStdString(), progress).drawing);
  }
  if (kind == SampleKind::Network)
    return std::make_shared<const AttributeNetwork>(read_attribute_network(text, file_name.toStdString()).network);
  const MeshFormat format = kind == SampleKind::Scan ? MeshFormat::Ply : MeshFormat::Obj;
  return std::make_shared<const PolyMesh>(read_mesh(text, format, file_name.toStdString(), progress).mesh);
}

std::shared_ptr<const PolyMesh> sample_surface(const QString& name, const Registry& registry, Progress& progress) {
  const Value sample = load_sample(name);
  const bool sketch = sample.type() == ValueType::Drawing;
  if (sample.type() == ValueType::AttributeNetwork) {
    Context context{progress, Quality::Draft};
    const OperationResult made = run(*registry.find("surface"), {{"network", sample}}, {}, context);
    return std::make_shared<const PolyMesh>(transformed(made.outputs.at("mesh").get<PolyMesh>(), upright_placement()));
  }
  const Operation* operation = registry.find(sketch ? "inflate" : "subdivide");
  if (operation == nullptr || kind_of_sample(name) == SampleKind::Scan) return sample.as<PolyMesh>();
  Context context{progress, Quality::Draft};
  const ParameterValues parameters = sketch ? ParameterValues() : ParameterValues{{"levels", std::int64_t{3}}};
  const OperationResult result = run(*operation, {{sketch ? "drawing" : "cage", sample}}, parameters, context);
  return result.outputs.at("mesh").as<PolyMesh>();
}

GalleryThumbnails::GalleryThumbnails(const Registry& registry, OffscreenPictures& pictures, QObject* parent)
    : QObject(parent), registry_(registry), pictures_(pictures) {}

GalleryThumbnails::~GalleryThumbnails() {
  stop();
  if (worker_.joinable()) worker_.join();
}

void GalleryThumbnails::start() {
  if (worker_.joinable() && !stopped_) return;
  if (worker_.joinable()) worker_.join();
  stopped_ = false;
  busy_ = true;
  worker_ = std::thread([this, first = done_] { make_pictures(first); });
}

void GalleryThumbnails::stop() {
  stopped_ = true;
  busy_ = false;
}

void GalleryThumbnails::make_pictures(std::size_t first) {
  const std::vector<Sample> all = samples();
  for (std::size_t i = first; i < all.size() && !stopped_; ++i) {
    QImage picture;
    try {
      picture = picture_of(all[i].name);
    } catch (const Cancelled&) {
      return;
    } catch (const Error&) {
      // Its tile keeps its name alone; opening it reports the error.
    }
    const auto show = [this, i, name = all[i].name, picture] {
      done_ = i + 1;
      if (!picture.isNull()) emit finished(name, picture);
    };
    QMetaObject::invokeMethod(this, show, Qt::QueuedConnection);
  }
  const auto rest = [this] { busy_ = busy_ && done_ < samples().size(); };
  QMetaObject::invokeMethod(this, rest, Qt::QueuedConnection);
}

QImage GalleryThumbnails::picture_of(const QString& sample) {
  Progress progress(nullptr, &stopped_);
  const std::vector<render::MeshItemPtr> items{render::make_mesh_item(*sample_surface(sample, registry_, progress))};
  const double aspect = static_cast<double>(picture_size.width()) / picture_size.height();
  render::ViewDirection direction = render::view_direction(render::NamedView::Perspective);
  // Screws lie along z, their heads in front of the collar that they are about.
  if (sample.startsWith("bolt"))
    direction.direction = {direction.direction.x, direction.direction.y, -direction.direction.z};
  const render::Camera camera = render::frame(render::points_of(items), direction, aspect);
  render::RenderOptions options;
  options.supersampling = 2;  // tiles show it smaller
  options.reduced = true;
  return pictures_.draw({items.begin(), items.end()}, camera, options, picture_size);
}

}  // namespace croquis::app
