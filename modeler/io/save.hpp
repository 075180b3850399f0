// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "modeler/io/model_label.hpp"
#include "modeler/semantics/plane_label.hpp"
#include "modeler/semantics/rooms.hpp"
#include "modeler/storage/file_set.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Checks that `name` is a plain file name: a letter, digit or '_', then up to 63 letters, digits,
/// '_', '.' or '-', without "..". Throws std::invalid_argument otherwise.
void check_save_name(const std::string& name);

/// Adds the four files of a model to a set: <name>.json, the mesh <name>.ply with stripes of up to
/// `stripe_gap_m` closed, the cells <name>_cells.ply and the OctoMap <name>.bt. The label's origin
/// is replaced by origin_of(). `labels` are those of the planes, or none. Throws as FileSet::add().
void add_model(const std::vector<Plane>& planes, ModelLabel label, const std::string& name,
               double stripe_gap_m, FileSet& files, const std::vector<PlaneLabel>& labels = {});

/// A function that returns the bytes of a file of a run, given the run's id.
using FileOfRun = std::function<std::string(const std::string& run)>;

/// A function that adds files to the set of a model, given what they say beside its planes.
using FilesOfModel = std::function<void(const ModelLabel& label, FileSet& files)>;

/// What is saved beside the planes of a model.
struct SavedBeside {
  std::string model_file;               ///< bytes of a model file; empty: none
  std::vector<PlaneLabel> labels = {};  ///< of the planes, in their order; empty: none
  FileOfRun page = {};                  ///< makes a page to look at; empty: none
  std::optional<Rooms> rooms = {};      ///< of the planes
  FilesOfModel more = {};               ///< adds other files to the set; empty: none
};

/// Writes the four files of a model, as add_model(), into `directory`, which is created if needed,
/// and, if they are given, the model file <name>.ribbons, the page <name>.html and the rooms
/// <name>_rooms.json. They are a set of this name, see FileSet. Returns their paths. Throws
/// std::invalid_argument for a bad name, and std::runtime_error with the file, the reason and a
/// remedy.
std::vector<std::filesystem::path> save_model(const std::vector<Plane>& planes,
                                              const std::filesystem::path& directory,
                                              const std::string& name, double stripe_gap_m,
                                              const std::string& frame = "map",
                                              const SavedBeside& beside = {});

}  // namespace ribbon_mapper
