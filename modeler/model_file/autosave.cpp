// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/model_file/autosave.hpp"

#include <stdexcept>
#include <utility>

#include "modeler/io/save.hpp"
#include "modeler/model_file/model_file.hpp"

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;

}  // namespace

bool is_reserved_name(const std::string& name) {
  return name == kAutosave || name == kAutosaveBefore || name == kBeforeLoad;
}

Autosave::Autosave(fs::path folder, double period_s)
    : folder_(std::move(folder)),
      file_(folder_ / (std::string(kAutosave) + kModelFileEnding)),
      period_s_(period_s) {
  if (is_on()) create_directory_for_files(folder_);
}

std::string Autosave::offer(std::size_t version, double now_s,
                            const std::function<std::string()>& bytes) {
  if (!is_on()) return {};
  const bool is_early = last_s_ && now_s < *last_s_ + period_s_;
  if (version == saved_version_ || is_early || writer_.is_busy()) return {};
  std::string error = writer_.wait();
  writer_.write(file_, bytes());
  saved_version_ = version;
  last_s_ = now_s;
  return error;
}

std::string Autosave::finish(std::size_t version, const std::function<std::string()>& bytes) {
  if (!is_on()) return {};
  std::string error = writer_.wait();
  if (version == saved_version_ && error.empty()) return {};
  writer_.write(file_, bytes());
  saved_version_ = version;
  return writer_.wait();
}

void Autosave::begin_another() {
  if (!is_on()) return;
  writer_.wait();
  saved_version_ = 0;
  last_s_.reset();
  std::error_code error;
  if (!fs::exists(file_, error)) return;
  const fs::path before = folder_ / (std::string(kAutosaveBefore) + kModelFileEnding);
  fs::rename(file_, before, error);
  if (error) throw std::runtime_error("cannot keep " + file_.string() + ": " + error.message());
}

std::optional<fs::path> file_to_start_from(const Start& start) {
  const fs::path autosave = start.folder / (std::string(kAutosave) + kModelFileEnding);
  if (start.resume && fs::exists(autosave)) return autosave;
  if (start.load.empty()) return std::nullopt;
  const fs::path given(start.load);
  if (given.has_parent_path() || given.extension() == kModelFileEnding) return given;
  check_save_name(start.load);
  return start.folder / (start.load + kModelFileEnding);
}

}  // namespace ribbon_mapper
