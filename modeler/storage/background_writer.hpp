// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <future>
#include <string>

namespace ribbon_mapper {

/// Writes a file in a thread of its own, so that nobody waits for the disk.
class BackgroundWriter {
 public:
  /// Returns true while a file is being written.
  bool is_busy() const;

  /// Waits for the file before, then begins to write this one, as write_file_atomically().
  void write(std::filesystem::path path, std::string bytes);

  /// Waits until the file is written. Returns why it was not, or an empty text. An error is
  /// returned once.
  std::string wait();

 private:
  std::future<std::string> error_;  // of the file being written
};

}  // namespace ribbon_mapper
