// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "modeler/maps/model_maps.hpp"

namespace ribbon_mapper {

/// What maps are made from: a copy, so that the model goes on meanwhile.
struct MapSnapshot {
  std::vector<Plane> planes;  ///< of a model
  SightLines sights;          ///< of the same model
};

/// Makes maps in a thread of its own, from snapshots that the thread of the model gives when
/// somebody has asked. All members but the destructor may be called by any thread.
class MapWorker {
 public:
  /// Called by the worker's thread with each new map.
  using OnMade = std::function<void(const ModelMaps&)>;

  /// Starts the thread.
  MapWorker(const MapsConfig& config, OnMade on_made);
  /// Ends the thread after the map that it makes.
  ~MapWorker();
  MapWorker(const MapWorker&) = delete;
  MapWorker& operator=(const MapWorker&) = delete;

  /// Asks for maps of a later snapshot. Returns a ticket for wait_for().
  std::uint64_t ask();
  /// Returns true if somebody has asked since the last snapshot.
  bool is_asked() const;
  /// Makes maps of a snapshot, in place of one that waits.
  void give(MapSnapshot snapshot);
  /// Waits for the maps of a ticket, or later ones. Returns nothing if they could not be made or
  /// after close().
  std::shared_ptr<const ModelMaps> wait_for(std::uint64_t ticket);
  /// Ends all waiting.
  void close();

 private:
  struct Task {
    MapSnapshot snapshot;
    std::uint64_t tickets;  ///< all up to this one are served
  };
  void work();
  std::optional<Task> next_task();

  MapsConfig config_;
  OnMade on_made_;
  mutable std::mutex mutex_;
  std::condition_variable has_task_, has_maps_;
  std::optional<Task> task_;
  std::uint64_t asked_ = 0, given_ = 0, made_ = 0;  // tickets
  std::shared_ptr<const ModelMaps> maps_;           // of made_
  bool is_closed_ = false;
  std::thread thread_;
};

}  // namespace ribbon_mapper
