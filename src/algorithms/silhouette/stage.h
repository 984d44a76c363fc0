// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "croquis/base/stage_cache.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"

namespace croquis::silhouette {

struct Skeleton;
struct SheetSampling;

/// Writes contents byte by byte, as keys of a StageCache. Lists bring their length along.
class ContentWriter {
 public:
  template <typename Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
  void add(Number number) { bytes_.append(reinterpret_cast<const char*>(&number), sizeof number); }
  void add(const Vec2& point) {
    add(point.x());
    add(point.y());
  }
  void add(std::string_view text) {
    add(text.size());
    bytes_.append(text);
  }
  void add(const std::string& text) { add(std::string_view(text)); }
  template <typename T>
  void add(const std::vector<T>& list) {
    add(list.size());
    for (const T& element : list) add(element);
  }

  void add(const Drawing& drawing);
  void add(const StrokeOptions& options);
  void add(const CompletionOptions& options);
  void add(const DepthOptions& options);
  /// What skeleton and surface depend on.
  void add_shape(const LabelledFigure& figure);
  /// What findings hold besides: names and strokes.
  void add_names(const LabelledFigure& figure, const Drawing& drawing);
  /// Without heights.
  void add_shape(const Skeleton& skeleton);

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// The result of a stage from the cache, or made; without a cache always made.
/// @param make  returns a Result
/// @param bytes estimates the memory of a const Result&
template <typename Result, typename Make, typename Bytes>
std::shared_ptr<const Result> cached(StageCache* cache, std::string_view stage, const ContentWriter& content,
                                     Make&& make, Bytes&& bytes) {
  if (cache == nullptr) return std::make_shared<const Result>(std::forward<Make>(make)());
  return std::static_pointer_cast<const Result>(cache->get(stage, content.bytes(), [&] {
    auto result = std::make_shared<const Result>(make());
    const std::size_t size = bytes(*result);
    return StageCache::Stage{std::move(result), size};
  }));
}

// About what results take in memory.
std::size_t bytes_of(const PolyMesh& mesh);
std::size_t bytes_of(const LabelledDrawing& labelled);
std::size_t bytes_of(const Skeleton& skeleton);
std::size_t bytes_of(const SheetSampling& sheets);

}  // namespace croquis::silhouette
