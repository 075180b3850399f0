// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/storage/background_writer.hpp"

#include <chrono>
#include <exception>
#include <utility>

#include "modeler/storage/atomic_file.hpp"

namespace ribbon_mapper {
namespace {

std::string error_of_writing(const std::filesystem::path& path, const std::string& bytes) {
  try {
    write_file_atomically(path, bytes);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace

bool BackgroundWriter::is_busy() const {
  return error_.valid() && error_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

void BackgroundWriter::write(std::filesystem::path path, std::string bytes) {
  if (error_.valid()) error_.wait();
  error_ = std::async(std::launch::async, error_of_writing, std::move(path), std::move(bytes));
}

std::string BackgroundWriter::wait() { return error_.valid() ? error_.get() : std::string(); }

}  // namespace ribbon_mapper
