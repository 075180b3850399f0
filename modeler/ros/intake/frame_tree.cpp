// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/intake/frame_tree.hpp"

#include <algorithm>

#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper {
namespace {

constexpr std::size_t kMaxShownLinks = 20;
constexpr std::size_t kMaxDepth = 1000;  // of tf2 too

using Chain = std::vector<std::string>;  // from the laser to the root
using Place = std::optional<std::size_t>;

Place place_of(const Chain& chain, const std::string& frame) {
  const auto found = std::find(chain.begin(), chain.end(), frame);
  if (found == chain.end()) return std::nullopt;
  return found - chain.begin();
}

/// Returns the last part of a name, behind that of the robot.
std::string last_part(const std::string& frame) { return frame.substr(frame.rfind('/') + 1); }

bool is_odom(const std::string& frame) {
  return last_part(frame).find("odom") != std::string::npos;
}

/// Returns whether a frame is called base, base_link, robot1_base_link, but not laser_base.
bool is_base(const std::string& frame) {
  const std::string name = last_part(frame);
  return name.rfind("base", 0) == 0 || name.find("base_link") != std::string::npos ||
         name.find("base_footprint") != std::string::npos;
}

bool is_map(const std::string& frame) { return last_part(frame).find("map") != std::string::npos; }

/// Returns the only such frame from `begin` on; nothing if there are several.
Place only_one(const Chain& chain, std::size_t begin, bool (*is_such)(const std::string&)) {
  Place found;
  for (std::size_t i = begin; i < chain.size(); ++i) {
    if (!is_such(chain[i])) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

Place choose_odom(const Chain& chain, Place base, Place map) {
  if (const Place named = only_one(chain, base ? *base + 1 : 0, is_odom)) return named;
  if (!base) return std::nullopt;
  const std::size_t above = (map ? *map : chain.size() - 1) - *base;
  if (above == 0 || (above == 1 && map)) return *base + above;  // no odometry
  if (above <= 2) return *base + 1;
  return std::nullopt;
}

Place choose_map(const Chain& chain, std::size_t odom) {
  const std::size_t above = chain.size() - 1 - odom;
  if (above <= 1) return odom + above;
  return only_one(chain, odom + 1, is_map);
}

}  // namespace

FrameTree::FrameTree(const tf2::BufferCore& buffer) {
  std::vector<std::string> frames;
  buffer._getFrameStrings(frames);
  for (const std::string& frame : frames) {
    std::string parent;
    if (buffer._getParent(frame, ros::Time(), parent)) add(parent, frame);
  }
}

bool FrameTree::has(const std::string& frame) const {
  return parents_.count(frame) != 0 ||
         std::any_of(parents_.begin(), parents_.end(),
                     [&](const auto& link) { return link.second == frame; });
}

std::vector<std::string> FrameTree::chain_from(const std::string& frame) const {
  Chain chain;
  if (!has(frame)) return chain;
  for (std::string at = frame; chain.size() < kMaxDepth && !place_of(chain, at);) {
    chain.push_back(at);
    const auto link = parents_.find(at);
    if (link == parents_.end()) break;
    at = link->second;
  }
  return chain;
}

std::string FrameTree::text(const std::string& frame) const {
  Chain chain = chain_from(frame);
  std::string text;
  if (chain.size() > 1) {
    if (chain.size() > kMaxShownLinks) chain.resize(kMaxShownLinks);
    for (const std::string& name : chain)
      text = text.empty() ? shown(name) : shown(name) + " -> " + text;
    return text;
  }
  std::size_t count = 0;
  for (const auto& [child, parent] : parents_) {
    if (++count > kMaxShownLinks) break;
    text += (text.empty() ? "" : ", ") + shown(parent) + " -> " + shown(child);
  }
  if (count > kMaxShownLinks) text += ", " + std::to_string(parents_.size()) + " in all";
  return text.empty() ? "nothing" : text;
}

std::optional<Frames> choose_frames(const FrameTree& tree, const std::string& laser_frame,
                                    const Frames& wanted, const NamedFrames& named) {
  if (missing_frames(tree, wanted).empty()) return wanted;
  const Chain chain = tree.chain_from(laser_frame);
  if (chain.size() < 2) return std::nullopt;
  Place base = place_of(chain, wanted.base), odom = place_of(chain, wanted.odom);
  Place map = place_of(chain, wanted.map);
  if ((named.base && !base) || (named.odom && !odom) || (named.map && !map)) return std::nullopt;
  if (!odom && !base) odom = only_one(chain, 0, is_odom);
  if (!odom && !base) base = only_one(chain, 0, is_base);
  if (!odom) odom = choose_odom(chain, base, map);
  if (!odom) return std::nullopt;
  if (!base) base = *odom > 0 ? *odom - 1 : *odom;
  if (!map) map = choose_map(chain, *odom);
  if (!map || *base > *odom || *odom > *map) return std::nullopt;
  return Frames{chain[*map], chain[*odom], chain[*base]};
}

std::string settings_text(const Frames& wanted, const Frames& chosen, const std::string& prefix,
                          const std::string& suffix) {
  std::string text;
  const auto add = [&](const std::string& before, const std::string& now, const char* name) {
    if (before == now) return;
    text += (text.empty() ? "" : " ") + prefix + name + suffix + shown(now);
  };
  add(wanted.map, chosen.map, "map");
  add(wanted.odom, chosen.odom, "odom");
  add(wanted.base, chosen.base, "base");
  return text;
}

std::string missing_frames(const FrameTree& tree, const Frames& frames) {
  std::string text;
  for (const std::string& frame : {frames.map, frames.odom, frames.base}) {
    if (!tree.has(frame)) text += (text.empty() ? "" : ", ") + shown(frame);
  }
  return text;
}

}  // namespace ribbon_mapper
