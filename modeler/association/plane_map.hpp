// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "modeler/association/association_config.hpp"
#include "modeler/association/hypothesis.hpp"
#include "modeler/association/voxel_index.hpp"
#include "modeler/geometry/shared_vector.hpp"

namespace ribbon_mapper {

/// Aggregates ribbons into plane hypotheses, one after the other (section 4.3 of the paper).
///
/// A ribbon joins the most likely of the hypotheses near it, or founds a new one. Hypotheses that
/// have grown together are merged when a ribbon fits both.
class PlaneMap {
 public:
  /// Creates an empty map. A ribbon joins planes within `reach_m` of their ribbons; new hypotheses
  /// are numbered from `first_id` on.
  PlaneMap(double reach_m, const AssociationGates& gates, std::int64_t first_id = 0);

  /// Adds a ribbon, which becomes a member with this index.
  void add(const PosedRibbon& ribbon, std::uint32_t index);

  /// Returns the hypotheses near a ribbon that were seen from a similar direction. They are valid
  /// until the map changes.
  std::vector<const Hypothesis*> near(const PosedRibbon& ribbon);

  /// Returns the hypotheses as built on the way, ordered by id.
  std::vector<Hypothesis> hypotheses() const;

  /// Returns the hypotheses after merging all that are one plane within the gates, ordered by id.
  std::vector<Hypothesis> merged_hypotheses() const;

  /// Replaces the ids by those of `before`, a map of the same ribbons before they were evaluated
  /// again. Each hypothesis takes the id of the one with which it shares the most ribbons, unless
  /// another shares more. `index_before[i]` is the former index of ribbon i; empty if unchanged.
  void take_ids_from(const PlaneMap& before, const std::vector<std::uint32_t>& index_before = {});
  /// Returns the id of each ribbon's hypothesis, by ribbon.
  std::vector<std::int64_t> ids_of_ribbons() const { return ids_of_ribbons({}); }
  /// Replaces the ids by those that the ribbons' hypotheses had, as ids_of_ribbons() has returned
  /// them, by the rule of take_ids_from(). Other hypotheses are numbered from `next_id` on.
  void take_ids(const std::vector<std::int64_t>& ids_of_ribbons, std::int64_t next_id);
  /// Returns the id that the next new hypothesis will have.
  std::int64_t next_id() const { return next_id_; }
  /// Returns the gates.
  const AssociationGates& gates() const { return gates_; }

  /// What a map was when it had aggregated the first of its ribbons. It shares with the map what
  /// has not changed since.
  struct State {
    /// Returns the memory of what this state has and a later one of the same map does not share.
    std::size_t unshared_bytes(const State& later) const;

    SharedVector<Hypothesis> hypotheses;    ///< by slot, see PlaneMap
    std::vector<std::uint32_t> free_slots;  ///< of hypotheses that were merged into others
    VoxelIndex::State index;                ///< where hypotheses are
    std::int64_t created = 0;               ///< number of hypotheses that were created
  };
  /// Returns the present state.
  State state() const { return {hypotheses_, free_slots_, index_.state(), created_}; }
  /// Returns the map as it was in a former state, with all hypotheses numbered from `first_id` on
  /// in the order of their creation.
  PlaneMap restored(const State& state, std::int64_t first_id) const;

  /// Returns the memory in use. Visits every hypothesis.
  std::size_t memory_bytes() const;

 private:
  /// The number of ribbons that the hypothesis at a slot shares with a former one.
  struct Share {
    std::size_t ribbons;
    std::int64_t id;  // of the former one
    std::uint32_t slot;
  };
  std::vector<std::int64_t> ids_of_ribbons(const SharedVector<Hypothesis>& now) const;
  static void add_shares(std::uint32_t slot, std::vector<std::int64_t>& ids,
                         std::vector<Share>& shares);
  std::vector<Share> shares_with(const std::vector<std::int64_t>& ids_before,
                                 const PlaneMap* before,
                                 const std::vector<std::uint32_t>& index_before) const;
  std::vector<bool> name_by(std::vector<Share> shares);

  /// A hypothesis' plane in single precision, a quarter of a cache line. Rejects most of the
  /// ribbons near a hypothesis that do not belong to it.
  struct FloatPlane {
    Eigen::Vector3f normal;
    float d_m;
  };
  std::uint32_t new_slot();
  void refresh(std::uint32_t slot);
  std::vector<std::uint32_t> parallel_neighbours(std::uint32_t slot);
  bool is_alive(std::uint32_t slot) const { return !hypotheses_[slot].members().empty(); }
  void merge(std::uint32_t into, std::uint32_t from);
  void merge_with(const std::vector<std::uint32_t>& matches, std::uint32_t slot);
  bool absorb_neighbours(std::uint32_t slot);

  AssociationGates gates_;
  float min_cosine_, max_distance_m_;  // gates for a FloatPlane, with margins far above rounding
  double reach_;  // largest distance from a hypothesis' unit normal to those of its ribbons
  VoxelIndex index_;
  std::int64_t created_ = 0, next_id_;
  // By slot; a free slot has no members. Their ids are numbers in the order of creation, which a
  // state can share with maps of other ids.
  SharedVector<Hypothesis> hypotheses_;
  std::vector<std::int64_t> ids_;              // by slot
  std::vector<FloatPlane> float_planes_;       // by slot
  std::vector<std::uint32_t> free_slots_;      // of hypotheses that were merged into others
  std::vector<std::uint32_t> voxels_;          // working memory
  std::vector<std::uint32_t> near_, matches_;  // working memory
};

}  // namespace ribbon_mapper
