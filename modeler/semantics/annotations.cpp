// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/semantics/annotations.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace ribbon_mapper {
namespace {

constexpr std::size_t kMostIdsListed = 50;

std::string listed_ids(const std::vector<Plane>& planes) {
  std::string text;
  for (std::size_t i = 0; i < std::min(planes.size(), kMostIdsListed); ++i) {
    text += (text.empty() ? "" : ", ") + std::to_string(planes[i].id);
  }
  if (planes.size() > kMostIdsListed) {
    text += " and " + std::to_string(planes.size() - kMostIdsListed) + " more";
  }
  return text.empty() ? "none" : text;
}

void check_text(const std::string& text, const char* what, std::size_t longest) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; };
  if (text.size() > longest) {
    throw std::invalid_argument(std::string("The ") + what + " has " + std::to_string(text.size()) +
                                " bytes, more than " + std::to_string(longest) + ". Shorten it.");
  }
  if (std::any_of(text.begin(), text.end(), is_control)) {
    throw std::invalid_argument(std::string("The ") + what +
                                " has control characters. Write it in one line.");
  }
}

/// Returns the index of the plane that holds most of the ribbons, if it holds at least half.
std::optional<std::size_t> holder_of(
    const std::vector<std::uint32_t>& ribbons,
    const std::unordered_map<std::uint32_t, std::size_t>& plane_of_ribbon) {
  std::map<std::size_t, std::size_t> counts;
  for (const std::uint32_t ribbon : ribbons) {
    const auto found = plane_of_ribbon.find(ribbon);
    if (found != plane_of_ribbon.end()) ++counts[found->second];
  }
  for (const auto& [plane, count] : counts) {
    if (2 * count >= ribbons.size()) return plane;
  }
  return std::nullopt;
}

/// Returns up to Annotations::kMostRibbons of a plane's ribbons, evenly spread.
std::vector<std::uint32_t> some_of(const std::vector<std::uint32_t>& ribbons) {
  const std::size_t count = std::min(ribbons.size(), Annotations::kMostRibbons);
  std::vector<std::uint32_t> some(count);
  for (std::size_t i = 0; i < count; ++i) some[i] = ribbons[i * ribbons.size() / count];
  return some;
}

std::vector<std::uint32_t> parsed_ribbons(const std::string& text) {
  std::vector<std::uint32_t> ribbons;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at != end;) {
    const auto [next, error] = std::from_chars(at, end, ribbons.emplace_back());
    if (error != std::errc() || (next != end && *next != ' ')) {
      throw std::invalid_argument("ribbons are whole numbers, separated by spaces");
    }
    at = next == end ? end : next + 1;
  }
  return ribbons;
}

/// Returns one line's annotation and its id.
std::pair<std::int64_t, Annotation> parsed(const std::string& line) {
  const std::size_t first = line.find('\t');
  const std::size_t second = first == std::string::npos ? first : line.find('\t', first + 1);
  const std::size_t third = second == std::string::npos ? second : line.find('\t', second + 1);
  std::int64_t id = 0;
  if (third != std::string::npos) {
    const auto [end, error] = std::from_chars(line.data(), line.data() + first, id);
    if (error == std::errc() && end == line.data() + first && second > first + 1) {
      Annotation annotation{line.substr(first + 1, second - first - 1),
                            line.substr(second + 1, third - second - 1),
                            parsed_ribbons(line.substr(third + 1))};
      check_text(annotation.label, "label", Annotations::kLongestLabel);
      check_text(annotation.note, "note", Annotations::kLongestNote);
      return {id, annotation};
    }
  }
  throw std::invalid_argument("a line needs id, label, note and ribbons, separated by tabulators");
}

}  // namespace

void Annotations::set(std::int64_t id, const std::string& label, const std::string& note,
                      const std::vector<Plane>& planes) {
  const auto plane = std::find_if(planes.begin(), planes.end(),
                                  [&](const Plane& candidate) { return candidate.id == id; });
  if (plane == planes.end()) {
    throw std::invalid_argument("There is no plane with the id " + std::to_string(id) +
                                ". Ids are: " + listed_ids(planes) + ".");
  }
  check_text(label, "label", kLongestLabel);
  check_text(note, "note", kLongestNote);
  if (label.empty()) {
    if (by_id_.erase(id) == 0) {
      throw std::invalid_argument("Plane " + std::to_string(id) +
                                  " has no annotation to remove: give a label.");
    }
  } else {
    by_id_[id] = {label, note, some_of(plane->ribbons)};
  }
}

void Annotations::note_ribbons(const std::vector<Plane>& planes) {
  if (by_id_.empty()) return;
  for (const Plane& plane : planes) {
    const auto found = by_id_.find(plane.id);
    if (found != by_id_.end()) found->second.ribbons = some_of(plane.ribbons);
  }
}

void Annotations::forget_ribbons() {
  for (auto& [id, annotation] : by_id_) annotation.ribbons.clear();
}

std::vector<const Annotation*> Annotations::of(const std::vector<Plane>& planes) const {
  std::vector<const Annotation*> annotations(planes.size(), nullptr);
  if (by_id_.empty()) return annotations;
  std::unordered_map<std::int64_t, std::size_t> plane_of_id;
  std::unordered_map<std::uint32_t, std::size_t> plane_of_ribbon;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    plane_of_id[planes[i].id] = i;
    for (const std::uint32_t ribbon : planes[i].ribbons) plane_of_ribbon[ribbon] = i;
  }
  std::vector<const Annotation*> homeless;
  for (const auto& [id, annotation] : by_id_) {
    const auto found = plane_of_id.find(id);
    if (found == plane_of_id.end()) {
      homeless.push_back(&annotation);
    } else {
      annotations[found->second] = &annotation;
    }
  }
  for (const Annotation* annotation : homeless) {
    const auto holder = holder_of(annotation->ribbons, plane_of_ribbon);
    if (holder && !annotation->ribbons.empty() && annotations[*holder] == nullptr) {
      annotations[*holder] = annotation;
    }
  }
  return annotations;
}

std::string Annotations::to_text() const {
  std::string text;
  for (const auto& [id, annotation] : by_id_) {
    text += std::to_string(id) + "\t" + annotation.label + "\t" + annotation.note + "\t";
    for (std::size_t i = 0; i < annotation.ribbons.size(); ++i) {
      text += (i == 0 ? "" : " ") + std::to_string(annotation.ribbons[i]);
    }
    text += "\n";
  }
  return text;
}

Annotations Annotations::from_text(const std::string& text) {
  Annotations annotations;
  std::istringstream lines(text);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    try {
      const auto [id, annotation] = parsed(line);
      if (!annotations.by_id_.emplace(id, annotation).second) {
        throw std::invalid_argument("the id " + std::to_string(id) + " occurs twice");
      }
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("Annotations, line " + std::to_string(number) + ": " +
                                  error.what());
    }
  }
  return annotations;
}

}  // namespace ribbon_mapper
