// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/joints.h"

#include <algorithm>
#include <map>
#include <utility>

namespace croquis::app {
namespace {

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

AttachText without(AttachText attach, const Joint& joint) {
  std::erase_if(attach.pairs, [&](const AttachedPair& pair) { return names_pair(pair, joint.a, joint.b); });
  return attach;
}

}  // namespace

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
  const AttachedPair* old = find_pair(attach, joint.a, joint.b);
  AttachedPair pair = old == nullptr ? AttachedPair() : *old;
  pair.a = joint.a;
  pair.b = joint.b;
  pair.hold = hold;
  if (hold != Hold::Joined) pair.blend = AttachedPair().blend;
  attach = without(std::move(attach), joint);
  if (hold != joint.by_itself) attach.pairs.push_back(std::move(pair));
  return attach;
}

AttachText with_blend(AttachText attach, const Joint& joint, double blend) {
  const AttachedPair* old = find_pair(attach, joint.a, joint.b);
  AttachedPair pair = old == nullptr ? AttachedPair() : *old;
  pair.a = joint.a;
  pair.b = joint.b;
  pair.hold = Hold::Joined;
  pair.blend = std::clamp(blend, 0.0, 1.0);
  attach = without(std::move(attach), joint);
  attach.pairs.push_back(std::move(pair));
  return attach;
}

}  // namespace croquis::app
