// SPDX-License-Identifier: GPL-3.0-or-later
// An edit of one side of a symmetric network done on the other one, too.
#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "algorithms/attribute_surface/edits/network_image.h"
#include "croquis/attribute_surface/face_edit.h"
#include "croquis/attribute_surface/network_mirror.h"

namespace croquis {
namespace {

/// Numbers of elements in one network by those in another one; no_index for what isn't there.
template <typename Element>
std::vector<Index> numbers_in(const std::vector<Element>& of, const std::vector<Element>& in) {
  std::map<std::string_view, Index> by_id;
  for (Index i = 0; i < in.size(); ++i) by_id.emplace(in[i].id, i);
  std::vector<Index> numbers;
  for (const Element& element : of) {
    const auto found = by_id.find(element.id);
    numbers.push_back(found == by_id.end() ? no_index : found->second);
  }
  return numbers;
}

Index through(const std::vector<Index>& numbers, Index index) { return index == no_index ? no_index : numbers[index]; }

/// Numbers of all elements in two networks.
struct Correspondence {
  std::vector<Index> nodes, curves, faces, points;
};

Correspondence correspondence(const AttributeNetwork& of, const AttributeNetwork& in) {
  return {numbers_in(of.nodes, in.nodes), numbers_in(of.curves, in.curves), numbers_in(of.faces, in.faces),
          numbers_in(of.points, in.points)};
}

/// Partners of the edited network: those from before, and of new elements what happens to be their image.
std::vector<Index> carried_over(const std::vector<Index>& before_of, const std::vector<Index>& after_of,
                                const std::vector<Index>& partners, const std::vector<Index>& found) {
  std::vector<Index> carried;
  for (Index i = 0; i < before_of.size(); ++i) {
    const Index old = before_of[i];
    const Index found_old = through(before_of, found[i]);
    const bool is_taken = found_old != no_index && partners[found_old] != no_index;
    const Index of_new = is_taken ? no_index : found[i];
    carried.push_back(old == no_index ? of_new : through(after_of, partners[old]));
  }
  return carried;
}

/// What an edit changed, with numbers of the edited network.
class EditComparison {
 public:
  EditComparison(const AttributeNetwork& before, const AttributeNetwork& after)
      : before_(before), after_(after), old_(correspondence(after, before)) {}

  const Correspondence& old() const { return old_; }

  bool node(Index i) const { return before_.nodes[old_.nodes[i]].point != after_.nodes[i].point; }

  bool curve(Index i) const {
    const AttributeCurve& now = after_.curves[i];
    const AttributeCurve& then = before_.curves[old_.curves[i]];
    return now.control != then.control || now.join != then.join || through(old_.nodes, now.from) != then.from ||
           through(old_.nodes, now.to) != then.to;
  }

  bool settings(Index i) const {
    const AttributeFace& now = after_.faces[i];
    const AttributeFace& then = before_.faces[old_.faces[i]];
    return now.mode != then.mode || now.domain != then.domain || now.fullness != then.fullness;
  }

  bool loop(Index i) const {
    std::vector<AttributeSide> now = after_.faces[i].loop;
    for (AttributeSide& side : now) side.curve = old_.curves[side.curve];
    return now != before_.faces[old_.faces[i]].loop;
  }

  bool inner(Index i) const {
    std::vector<InnerCurve> now = after_.faces[i].inner;
    for (InnerCurve& inner : now) inner.curve = old_.curves[inner.curve];
    return now != before_.faces[old_.faces[i]].inner;
  }

  bool point(Index i) const {
    const PointAttribute& now = after_.points[i];
    const PointAttribute& then = before_.points[old_.points[i]];
    return old_.faces[now.face] != then.face || now.point != then.point || now.fan != then.fan ||
           now.radius != then.radius || now.profile != then.profile || now.normal != then.normal;
  }

  bool slopes(Index i) const {
    const auto of = [](const AttributeNetwork& network, Index curve) {
      std::vector<const SlopeAttribute*> slopes;
      for (const SlopeAttribute& slope : network.slopes) {
        if (slope.curve == curve) slopes.push_back(&slope);
      }
      return slopes;
    };
    const auto same = [&](const SlopeAttribute* now, const SlopeAttribute* then) {
      return through(old_.faces, now->face) == then->face && now->at == then->at && now->normals == then->normals &&
             now->magnitude == then->magnitude;
    };
    return !std::ranges::equal(of(after_, i), of(before_, old_.curves[i]), same);
  }

 private:
  const AttributeNetwork& before_;
  const AttributeNetwork& after_;
  Correspondence old_;
};

/// Nodes that have taken over curves of their own image, which was merged into them: they are their own image now.
std::vector<Index> merged_with_image(const AttributeNetwork& before, const AttributeNetwork& after,
                                     const Correspondence& old, const std::vector<Index>& partners) {
  std::vector<Index> merged;
  for (std::size_t i = 0; i < after.curves.size(); ++i) {
    if (old.curves[i] == no_index) continue;
    const AttributeCurve& then = before.curves[old.curves[i]];
    for (const auto& [now, was] :
         {std::pair(after.curves[i].from, then.from), std::pair(after.curves[i].to, then.to)}) {
      if (now == no_index || was == no_index || old.nodes[now] == no_index || old.nodes[now] == was) continue;
      if (partners[old.nodes[now]] == was) merged.push_back(now);
    }
  }
  return merged;
}

/// Calls `make` for new elements, `centre` for those that are their own image, `renew` for changed ones whose image
/// hasn't been renewed by its own change.
template <typename Changed, typename Make, typename Centre, typename Renew>
void go_through(const std::vector<Index>& old, const std::vector<Index>& partners, Changed changed, Make make,
                Centre centre, Renew renew) {
  for (Index i = 0; i < old.size(); ++i) {
    const Index partner = partners[i];
    if (partner == i) {
      if (old[i] == no_index || changed(i)) centre(i);
    } else if (partner == no_index) {
      if (old[i] == no_index) make(i);
    } else if (old[i] != no_index && old[partner] != no_index && changed(i)) {
      if (partner > i || !changed(partner)) renew(i);
    }
  }
}

void renew_all(NetworkImage& image, const EditComparison& edit, const NetworkPartners& partners) {
  const Correspondence& old = edit.old();
  const auto nothing = [](Index) {};
  go_through(
      old.nodes, partners.nodes, [&](Index i) { return edit.node(i); }, [&](Index i) { image.node(i); },
      [&](Index i) { image.centre_node(i); }, [&](Index i) { image.renew_node(i); });
  go_through(
      old.curves, partners.curves, [&](Index i) { return edit.curve(i); }, [&](Index i) { image.curve(i); },
      [&](Index i) { image.centre_curve(i); }, [&](Index i) { image.renew_curve(i); });
  go_through(
      old.faces, partners.faces, [&](Index i) { return edit.settings(i); }, [&](Index i) { image.face(i); }, nothing,
      [&](Index i) { image.renew_face_settings(i); });
  go_through(
      old.faces, partners.faces, [&](Index i) { return edit.loop(i); }, nothing,
      [&](Index i) { image.complete_loop(i); }, [&](Index i) { image.renew_face_loop(i); });
  go_through(
      old.faces, partners.faces, [&](Index i) { return edit.inner(i); }, nothing, nothing,
      [&](Index i) { image.renew_inner_curves(i); });
  go_through(
      old.points, partners.points, [&](Index i) { return edit.point(i); }, [&](Index i) { image.point(i); },
      [&](Index i) { image.centre_point(i); }, [&](Index i) { image.renew_point(i); });
  go_through(
      old.curves, partners.curves, [&](Index i) { return edit.slopes(i); }, [&](Index i) { image.renew_slopes(i); },
      nothing, [&](Index i) { image.renew_slopes(i); });
}

/// Ids of the images of what is there no more.
template <typename Element>
std::vector<std::string> images_of_deleted(const std::vector<Element>& before, const std::vector<Index>& after_of,
                                           const std::vector<Index>& partners) {
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (after_of[i] == no_index && partners[i] != no_index) ids.push_back(before[partners[i]].id);
  }
  return ids;
}

bool has_curves(const AttributeNetwork& network, const std::string& node) {
  const Index index = find_element(network, NetworkElement::Node, node);
  return index != no_index && std::ranges::any_of(network.curves, [&](const AttributeCurve& curve) {
           return curve.from == index || curve.to == index;
         });
}

std::size_t open_corners(const AttributeNetwork& network) {
  std::size_t count = 0;
  for (const AttributeFace& face : network.faces) {
    for (std::size_t i = 0; i < face.loop.size(); ++i) {
      const AttributeSide& next = face.loop[(i + 1) % face.loop.size()];
      if (end_node(network, face.loop[i]) != start_node(network, next)) ++count;
    }
  }
  return count;
}

}  // namespace

AttributeNetwork with_symmetric_edit(const AttributeNetwork& before, const AttributeNetwork& after,
                                     const SymmetryPlane& plane, const NetworkPartners& partners) {
  const EditComparison edit(before, after);
  const Correspondence& old = edit.old();
  const Correspondence now = correspondence(before, after);
  const NetworkPartners found = find_partners(after, plane, tolerance_of(after));
  NetworkPartners carried{carried_over(old.nodes, now.nodes, partners.nodes, found.nodes),
                          carried_over(old.curves, now.curves, partners.curves, found.curves),
                          carried_over(old.faces, now.faces, partners.faces, found.faces),
                          carried_over(old.points, now.points, partners.points, found.points)};
  const std::vector<Index> merged = merged_with_image(before, after, old, partners.nodes);
  for (const Index node : merged) carried.nodes[node] = node;
  NetworkImage image(after, plane, carried);
  for (const Index node : merged) image.centre_node(node);
  renew_all(image, edit, carried);
  image.mend_loops();
  image.meet_nodes();
  const NetworkElements deleted{{},
                                images_of_deleted(before.curves, now.curves, partners.curves),
                                images_of_deleted(before.faces, now.faces, partners.faces),
                                images_of_deleted(before.points, now.points, partners.points)};
  AttributeNetwork result = delete_elements(std::move(image.network()), deleted);
  NetworkElements bare{images_of_deleted(before.nodes, now.nodes, partners.nodes), {}, {}, {}};
  std::erase_if(bare.nodes, [&](const std::string& id) { return has_curves(result, id); });
  result = delete_elements(std::move(result), bare);
  // Where only part of a network is symmetric, the image of an edit may part what the other part holds together.
  return open_corners(result) > open_corners(after) ? after : result;
}

}  // namespace croquis
