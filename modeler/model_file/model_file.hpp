// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "modeler/model_file/sections.hpp"
#include "modeler/modeler.hpp"

namespace ribbon_mapper {

/// Ending of the names of model files.
constexpr const char* kModelFileEnding = ".ribbons";

/// A model as a file has it. Modeler(config, std::move(model)) goes on from it.
struct ModelFile {
  ModelerConfig config;  ///< that the model was saved with
  SavedModel model;      ///< all else that decides what becomes of it
  std::string frame;     ///< of the map that the model is in
  /// Parts of other programs or later versions, whose names begin with a small letter. Whoever
  /// saves the model again passes them on.
  std::vector<Section> additions;
};

/// Returns the bytes of a model file: the same for the same model, on every machine.
std::string to_model_file(const Modeler& modeler, const std::string& frame = "map",
                          const std::vector<Section>& additions = {});

/// Reads the bytes of a model file. Throws std::runtime_error that says what is wrong: no model
/// file, cut, damaged, of a newer format, or with numbers that no model can have.
ModelFile from_model_file(std::string_view bytes);

/// Returns a sentence for each value of the configuration that differs, and for the frame, and what
/// holds for a session that goes on from the file with these.
std::vector<std::string> differences(const ModelFile& file, const ModelerConfig& config,
                                     const std::string& frame);

/// Replaces a file by one with this model, see write_file_atomically() for crashes and errors.
void save_model_file(const Modeler& modeler, const std::filesystem::path& path,
                     const std::string& frame = "map", const std::vector<Section>& additions = {});

/// Reads a model file. Throws std::runtime_error with the file and the reason, as
/// from_model_file(), or if it cannot be read.
ModelFile load_model_file(const std::filesystem::path& path);

}  // namespace ribbon_mapper
