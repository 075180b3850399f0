// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "modeler/storage/background_writer.hpp"

namespace ribbon_mapper {

/// Name of the file that a running model is saved in, without its ending.
constexpr const char* kAutosave = "autosave";
/// Name of the last autosave of the model before this one: nobody's model is lost by a restart.
constexpr const char* kAutosaveBefore = "autosave_before";
/// Name of the model that a load has replaced.
constexpr const char* kBeforeLoad = "before_load";

/// Returns true for the names above, which are no names for a save of one's own.
bool is_reserved_name(const std::string& name);

/// Saves a running model now and then: its bytes are copied at once, and written in a thread.
class Autosave {
 public:
  /// Saves into `folder` each `period_s`; never, if that is 0.
  Autosave(std::filesystem::path folder, double period_s);

  /// Returns true if it saves at all.
  bool is_on() const { return period_s_ > 0.0; }
  /// Returns the file.
  const std::filesystem::path& file() const { return file_; }

  /// Begins to save if the period is over, or the model was never saved, and the model has changed:
  /// `version` is a number that every change increases, `now_s` the time of a clock that never goes
  /// back. To be called often. Returns why the save before this one has failed, once, or an empty
  /// text.
  std::string offer(std::size_t version, double now_s, const std::function<std::string()>& bytes);

  /// Saves the last changes and waits until they are written. Returns as offer().
  std::string finish(std::size_t version, const std::function<std::string()>& bytes);

  /// Keeps the file of the model so far as kAutosaveBefore, because another model begins. Throws
  /// std::runtime_error with the reason if that fails.
  void begin_another();

 private:
  std::filesystem::path folder_, file_;
  double period_s_;
  std::optional<double> last_s_;  // time of the last save of this model
  std::size_t saved_version_ = 0;
  BackgroundWriter writer_;
};

/// Where a session begins.
struct Start {
  std::filesystem::path folder;  ///< with saved models and the autosave
  std::string load;              ///< a saved model's name, or a path with / or an ending; or empty
  bool resume = false;           ///< go on from the autosave, if it is there
};

/// Returns the file that a session begins with: the autosave if it is to be resumed and is there,
/// else the one to load; nothing for an empty model. Throws std::invalid_argument for a bad name.
std::optional<std::filesystem::path> file_to_start_from(const Start& start);

}  // namespace ribbon_mapper
