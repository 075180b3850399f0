// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/maps/map_worker.hpp"

#include <ros/console.h>

#include <exception>
#include <utility>

namespace ribbon_mapper {

MapWorker::MapWorker(const MapsConfig& config, OnMade on_made)
    : config_(config), on_made_(std::move(on_made)) {
  thread_ = std::thread([this] { work(); });
}

MapWorker::~MapWorker() {
  close();
  thread_.join();
}

void MapWorker::close() {
  {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
  }
  has_task_.notify_all();
  has_maps_.notify_all();
}

std::uint64_t MapWorker::ask() {
  const std::lock_guard lock(mutex_);
  return ++asked_;
}

bool MapWorker::is_asked() const {
  const std::lock_guard lock(mutex_);
  return asked_ > given_;
}

void MapWorker::give(MapSnapshot snapshot) {
  {
    const std::lock_guard lock(mutex_);
    given_ = asked_;
    task_ = Task{std::move(snapshot), given_};
  }
  has_task_.notify_all();
}

std::shared_ptr<const ModelMaps> MapWorker::wait_for(std::uint64_t ticket) {
  std::unique_lock lock(mutex_);
  has_maps_.wait(lock, [&] { return is_closed_ || made_ >= ticket; });
  return is_closed_ ? nullptr : maps_;
}

std::optional<MapWorker::Task> MapWorker::next_task() {
  std::unique_lock lock(mutex_);
  has_task_.wait(lock, [this] { return is_closed_ || task_; });
  if (is_closed_) return std::nullopt;
  return std::exchange(task_, std::nullopt);
}

void MapWorker::work() {
  while (const std::optional<Task> task = next_task()) {
    std::shared_ptr<const ModelMaps> maps;
    try {
      maps = std::make_shared<const ModelMaps>(
          make_maps(task->snapshot.planes, task->snapshot.sights, config_));
      on_made_(*maps);
    } catch (const std::exception& error) {
      ROS_ERROR("No map could be made: %s", error.what());
    }
    {
      const std::lock_guard lock(mutex_);
      made_ = task->tickets;
      maps_ = std::move(maps);
    }
    has_maps_.notify_all();
  }
}

}  // namespace ribbon_mapper
