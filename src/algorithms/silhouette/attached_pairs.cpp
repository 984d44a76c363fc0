// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/attached_pairs.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "croquis/base/error.h"
#include "croquis/silhouette/attachment.h"

namespace croquis::silhouette {
namespace {

/// Of the seams of pairs that nobody named: a limb grows out of its body rather than stuck to it.
constexpr double suggested_blend = 0.35;

struct ObjectPlace {
  std::size_t figure = 0;
  Index object = 0;

  friend bool operator==(const ObjectPlace&, const ObjectPlace&) = default;
};

class ObjectNames {
 public:
  ObjectNames(const LabelledDrawing& labelled, const Drawing& drawing) {
    for (std::size_t f = 0; f < labelled.figures.size(); ++f) {
      for (Index o = 0; o < labelled.figures[f].objects.size(); ++o)
        add(labelled.figures[f].objects[o], {f, o}, drawing);
    }
    for (const Stroke& stroke : drawing.strokes) {
      drawn_[stroke.id] = true;
      drawn_[stroke.object] = true;
    }
  }

  std::optional<ObjectPlace> find(const std::string& name) const {
    for (const auto* places : {&by_name_, &by_stroke_}) {
      const auto found = places->find(name);
      if (found != places->end()) return found->second;
    }
    return std::nullopt;
  }

  /// In the drawing, though perhaps in a part of it that couldn't be labelled.
  bool is_drawn(const std::string& name) const { return !name.empty() && drawn_.contains(name); }

 private:
  void add(const FigureObject& object, const ObjectPlace& place, const Drawing& drawing) {
    by_name_.try_emplace(object.name, place);
    for (const Index stroke : object.strokes) by_stroke_.try_emplace(drawing.strokes[stroke].id, place);
  }

  std::map<std::string, ObjectPlace> by_name_;
  std::map<std::string, ObjectPlace> by_stroke_;
  std::map<std::string, bool> drawn_;
};

std::string pair_text(const AttachedPair& pair) { return "\"" + pair.a + "\" and \"" + pair.b + "\""; }

std::vector<Subject> attach_subject() { return {{SubjectKind::Parameter, "attach", {}, {}, {}}}; }

Finding refusal(const std::string& sentence) {
  return make_error(Category::Usage, "E_ATTACH", sentence, attach_subject());
}

Finding apart(const AttachedPair& pair, const std::string& reason) {
  return make_warning(Category::Geometry, "W_ATTACH_APART",
                      "The objects " + pair_text(pair) + " can't be attached: " + reason, attach_subject());
}

bool overlap(const LabelledFigure& figure, Index a, Index b) {
  return std::any_of(figure.overlaps.begin(), figure.overlaps.end(), [&](const FigureOverlap& overlap) {
    return std::minmax(overlap.upper, overlap.lower) == std::minmax(a, b);
  });
}

class Resolver {
 public:
  Resolver(const LabelledDrawing& labelled, const Drawing& drawing)
      : labelled_(labelled), names_(labelled, drawing), named_(labelled.figures.size()) {
    result_.figures.resize(labelled.figures.size());
  }

  void resolve(const AttachedPair& pair) {
    if (!(pair.kappa >= 0 && pair.kappa <= 1)) {
      errors_.push_back(refusal("The attached objects " + pair_text(pair) + " need a depth from 0 to 1"));
    }
    if (!(pair.blend >= 0 && pair.blend <= 1)) {
      errors_.push_back(refusal("The seam of " + pair_text(pair) + " needs a radius from 0 to 1"));
    }
    if (!known(pair)) return;
    const std::optional<ObjectPlace> a = names_.find(pair.a);
    const std::optional<ObjectPlace> b = names_.find(pair.b);
    if (a && a == b) {
      errors_.push_back(refusal(pair_text(pair) + " are one object: attach two different ones"));
    } else if (!a || !b) {
      leave(pair, "the lines of \"" + (a ? pair.b : pair.a) + "\" make no solid yet");
    } else if (a->figure != b->figure || !overlap(labelled_.figures[a->figure], a->object, b->object)) {
      leave(pair, "they don't overlap in the drawing");
    } else {
      named_[a->figure].insert(std::minmax(a->object, b->object));
      hold(result_.figures[a->figure], a->object, b->object, pair);
    }
  }

  /// What looks attached, and isn't named.
  void suggest(bool tubes_only) {
    for (std::size_t f = 0; f < labelled_.figures.size(); ++f) {
      for (const AttachSuggestion& suggestion : attach_suggestions(labelled_.figures[f])) {
        if (named_[f].contains({suggestion.a, suggestion.b}) || (tubes_only && !suggestion.tube)) continue;
        AttachedPair pair;
        pair.hold = suggestion.hold;
        pair.blend = suggested_blend;
        hold(result_.figures[f], suggestion.a, suggestion.b, pair);
      }
    }
  }

  AttachedFigures take() {
    if (!errors_.empty()) throw Error(std::move(errors_));
    return std::move(result_);
  }

 private:
  /// Of two entries for one pair the later counts.
  static void hold(HeldObjects& held, Index a, Index b, const AttachedPair& pair) {
    held.attachments.release(a, b);
    held.blends.erase(std::minmax(a, b));
    if (pair.hold == Hold::Resting) held.attachments.rest(a, b);
    if (pair.hold != Hold::Joined) return;
    held.attachments.add(a, b, pair.kappa);
    if (pair.blend > 0) held.blends[std::minmax(a, b)] = pair.blend;
  }

  void leave(const AttachedPair& pair, const std::string& reason) {
    if (pair.hold != Hold::Apart) result_.warnings.push_back(apart(pair, reason));
  }

  bool known(const AttachedPair& pair) {
    bool both = true;
    for (const std::string& name : {pair.a, pair.b}) {
      if (names_.find(name) || names_.is_drawn(name)) continue;
      errors_.push_back(refusal("There is no object \"" + name + "\" to attach: use the name of an object or stroke"));
      both = false;
    }
    return both;
  }

  const LabelledDrawing& labelled_;
  ObjectNames names_;
  std::vector<std::set<Attachments::Pair>> named_;  ///< per figure
  AttachedFigures result_;
  Findings errors_;
};

}  // namespace

AttachedFigures attached_figures(const LabelledDrawing& labelled, const Drawing& drawing, const Options& options) {
  Resolver resolver(labelled, drawing);
  for (const AttachedPair& pair : options.attach) resolver.resolve(pair);
  resolver.suggest(!options.attach_suggested);
  return resolver.take();
}

}  // namespace croquis::silhouette
