// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/floor_plan/face_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "modeler/geometry/angles.hpp"
#include "modeler/semantics/top_view.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kSquare_m = 1.0;  // of the top view; more than a wall's thickness
constexpr double kStep_m = 0.5;    // between places at which a face is entered

/// Two faces that may be one wall.
struct Candidate {
  double thickness_m;
  std::size_t front, back;

  bool operator<(const Candidate& other) const {
    return std::tie(thickness_m, front, back) <
           std::tie(other.thickness_m, other.front, other.back);
  }
};

template <typename Visit>
void for_each_place(const WallFace& face, const Visit& visit) {
  for (const Interval& piece : face.seen) {
    for (double along_m = piece.begin; along_m < piece.end; along_m += kStep_m) {
      visit(face.at(along_m));
    }
    visit(face.at(piece.end));
  }
}

/// Returns the distance between two faces in the middle of where both were seen; nothing if they
/// cannot be one wall.
std::optional<double> thickness_of(const WallFace& front, const WallFace& back,
                                   const FloorPlanConfig& config) {
  if (front.normal.dot(back.normal) > -std::cos(config.parallel_deg * kDegree)) return std::nullopt;
  Intervals both;
  for (const Interval& piece : back.seen) {
    for (const Interval& common : intersection(front.seen, {on_face(front, back, piece)})) {
      both.push_back(common);
    }
  }
  if (both.empty()) return std::nullopt;
  const double along_m = 0.5 * (both.front().begin + both.back().end);
  const double depth_m = front.depth_m(back.at(back.along_m(front.at(along_m))));
  const bool is_wall =
      depth_m >= config.least_thickness_m && depth_m <= config.greatest_thickness_m;
  return is_wall ? std::optional<double>(depth_m) : std::nullopt;
}

/// Returns the faces that may be one wall, the thinnest walls first.
std::vector<Candidate> candidates_among(const std::vector<WallFace>& faces,
                                        const FloorPlanConfig& config) {
  TopView<std::size_t> view(kSquare_m);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for_each_place(faces[i], [&](const Eigen::Vector2d& place) {
      std::vector<std::size_t>& square = view.at(place);
      if (square.empty() || square.back() != i) square.push_back(i);
    });
  }
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    std::vector<std::size_t> near;
    for_each_place(faces[i], [&](const Eigen::Vector2d& place) {
      view.for_each_around(place, 1, [&](std::size_t other) {
        if (other > i) near.push_back(other);
      });
    });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const std::size_t other : near) {
      const auto thickness_m = thickness_of(faces[i], faces[other], config);
      if (thickness_m) candidates.push_back({*thickness_m, i, other});
    }
  }
  std::sort(candidates.begin(), candidates.end());
  return candidates;
}

/// Pairs faces, and lets walls go on where one face was not seen.
class Pairing {
 public:
  Pairing(const std::vector<WallFace>& faces, const FloorPlanConfig& config)
      : faces_(faces), config_(config), pairs_of_face_(faces.size()) {
    for (const WallFace& face : faces) result_.unpaired.push_back(face.seen);
    for (const Candidate& candidate : candidates_among(faces, config)) pair(candidate);
    for (std::size_t i = 0; i < faces.size(); ++i) go_on(i);
    merge();
  }

  FacePairs take() { return std::move(result_); }

 private:
  /// Pairs two faces where nothing else was nearer.
  void pair(const Candidate& c) {
    const WallFace &front = faces_[c.front], &back = faces_[c.back];
    Intervals pieces;
    for (const Interval& piece : result_.unpaired[c.back]) {
      for (const Interval& common :
           intersection(result_.unpaired[c.front], {on_face(front, back, piece)})) {
        pieces.push_back(common);
      }
    }
    for (const Interval& piece : pieces) {
      for (const std::size_t face : {c.front, c.back}) {
        pairs_of_face_[face].push_back(result_.pairs.size());
      }
      result_.pairs.push_back({c.front, c.back, piece});
      remove(c.front, piece);
      remove(c.back, on_face(back, front, piece));
    }
  }

  void remove(std::size_t face, const Interval& piece) {
    result_.unpaired[face] = difference(result_.unpaired[face], piece);
  }

  /// Lets the walls of a face go on where the other face was not seen.
  void go_on(std::size_t face) {
    const Intervals unpaired = result_.unpaired[face];
    for (const Interval& piece : unpaired) {
      FacePair* before = nullptr;
      FacePair* after = nullptr;
      for (const std::size_t index : pairs_of_face_[face]) {
        FacePair& pair = result_.pairs[index];
        const Interval own = piece_on(face, pair);
        if (std::abs(own.end - piece.begin) <= config_.joint_m) before = &pair;
        if (std::abs(own.begin - piece.end) <= config_.joint_m) after = &pair;
      }
      const bool is_between = before != nullptr && after != nullptr &&
                              before->front == after->front && before->back == after->back;
      if (!is_between && piece.length() > config_.greatest_thickness_m) continue;
      FacePair* pair = before != nullptr ? before : after;
      if (pair == nullptr) continue;
      extend(face, piece, *pair);
      remove(face, piece);
    }
  }

  Interval piece_on(std::size_t face, const FacePair& pair) const {
    return face == pair.front ? pair.piece : on_face(faces_[face], faces_[pair.front], pair.piece);
  }

  void extend(std::size_t face, const Interval& piece, FacePair& pair) const {
    const Interval own =
        face == pair.front ? piece : on_face(faces_[pair.front], faces_[face], piece);
    pair.piece.begin = std::min(pair.piece.begin, own.begin);
    pair.piece.end = std::max(pair.piece.end, own.end);
  }

  /// Unites pieces of the same two faces that touch.
  void merge() {
    std::vector<FacePair>& pairs = result_.pairs;
    std::sort(pairs.begin(), pairs.end(), [](const FacePair& a, const FacePair& b) {
      return std::tie(a.front, a.back, a.piece.begin) < std::tie(b.front, b.back, b.piece.begin);
    });
    std::vector<FacePair> merged;
    for (const FacePair& pair : pairs) {
      const bool touches = !merged.empty() && merged.back().front == pair.front &&
                           merged.back().back == pair.back &&
                           pair.piece.begin <= merged.back().piece.end + config_.joint_m;
      if (touches) {
        merged.back().piece.end = std::max(merged.back().piece.end, pair.piece.end);
      } else {
        merged.push_back(pair);
      }
    }
    pairs = std::move(merged);
  }

  const std::vector<WallFace>& faces_;
  const FloorPlanConfig& config_;
  std::vector<std::vector<std::size_t>> pairs_of_face_;
  FacePairs result_;
};

}  // namespace

Interval on_face(const WallFace& to, const WallFace& from, const Interval& piece) {
  const double a_m = to.along_m(from.at(piece.begin)), b_m = to.along_m(from.at(piece.end));
  return {std::min(a_m, b_m), std::max(a_m, b_m)};
}

FacePairs pairs_of(const std::vector<WallFace>& faces, const FloorPlanConfig& config) {
  return Pairing(faces, config).take();
}

}  // namespace ribbon_mapper
