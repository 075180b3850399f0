// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "modeler/association/association_config.hpp"
#include "modeler/association/hypothesis.hpp"
#include "modeler/association/voxel_index.hpp"

namespace ribbon_mapper {

/// Aggregation of ribbons into planes, on the fly (section 4.3). A ribbon joins the likeliest of
/// the planes that it nearly touches; hypotheses that have grown together are merged as they meet.
class PlaneMap {
 public:
  /// Creates an empty map. A ribbon joins planes within `reach_m` of their ribbons; new hypotheses
  /// are numbered from `first_id` on.
  PlaneMap(double reach_m, const AssociationGates& gates, std::int64_t first_id = 0);

  /// `index`: by which the ribbon is remembered as a member.
  void add(const PosedRibbon& ribbon, std::uint32_t index);

  std::vector<Hypothesis> hypotheses() const;  ///< as built on the way, by id

  /// The hypotheses with all that are one plane within the gates merged, by id.
  std::vector<Hypothesis> merged_hypotheses() const;

  /// For a map of the same ribbons evaluated again: a hypothesis takes the id of the one in
  /// `before` with which it shares the most ribbons, as far as that is still free. `index_before`:
  /// of each ribbon, if they are numbered anew.
  void take_ids_from(const PlaneMap& before, const std::vector<std::uint32_t>& index_before = {});
  std::int64_t next_id() const { return next_id_; }
  const AssociationGates& gates() const { return gates_; }

  std::size_t memory_bytes() const;

 private:
  std::vector<std::int64_t> ids_of_ribbons() const;

  /// Tells at once that most ribbons near a hypothesis are none of it, a quarter of a cache line.
  struct Side {
    Eigen::Vector3f normal;
    float d_m;
  };
  std::uint32_t new_slot();
  void refresh(std::uint32_t slot);
  std::vector<std::uint32_t> parallel_neighbours(std::uint32_t slot);
  bool is_alive(std::uint32_t slot) const { return !hypotheses_[slot].members().empty(); }
  void merge(std::uint32_t into, std::uint32_t from);
  void merge_with(const std::vector<std::uint32_t>& others, std::uint32_t slot);
  bool absorb_neighbours(std::uint32_t slot);

  AssociationGates gates_;
  float min_cosine_, max_distance_m_;  // of a Side; the margins are far above rounding
  double reach_;                       // from a normal to those of its ribbons
  VoxelIndex index_;
  std::int64_t next_id_;
  std::vector<Hypothesis> hypotheses_;        // by slot; without members: slot is free
  std::vector<Side> sides_;                   // by slot
  std::vector<std::uint32_t> free_slots_;     // of what merged into others
  std::vector<std::uint32_t> voxels_;         // scratch
  std::vector<std::uint32_t> near_, others_;  // scratch
};

}  // namespace ribbon_mapper
