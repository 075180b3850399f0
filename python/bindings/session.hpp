// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "modeler/model_file/model_file.hpp"
#include "modeler/modeler.hpp"

namespace ribbon_mapper::python {

/// A modeler that Python's threads may share. Each call works without Python's global lock (GIL);
/// calls of several threads wait for each other.
class Session {
 public:
  /// Begins with an empty model. Throws as Modeler does.
  explicit Session(const ModelerConfig& config) : modeler_(config) {}

  /// Goes on from a file with another configuration than it has. Throws as Modeler does.
  Session(const ModelerConfig& config, ModelFile file)
      : modeler_(config, std::move(file.model)),
        frame_(std::move(file.frame)),
        additions_(std::move(file.additions)) {}

  /// Returns what `work` returns for the modeler, which nobody else uses meanwhile. `work` must
  /// leave Python's objects alone.
  template <typename Work>
  auto run(Work work) {
    const pybind11::gil_scoped_release without_gil;
    const std::lock_guard<std::mutex> lock(mutex_);
    return work(modeler_);
  }

  /// Replaces a file by one with this model. Throws std::runtime_error with the reason.
  void save(const std::string& path) {
    run([&](Modeler& modeler) { save_model_file(modeler, path, frame_, additions_); });
  }

 private:
  std::mutex mutex_;
  Modeler modeler_;
  std::string frame_ = "map";
  std::vector<Section> additions_;  // parts of other programs, which are passed on
};

}  // namespace ribbon_mapper::python
