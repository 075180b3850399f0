// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ribbon_mapper {

/// A part of a model file. Its name has four letters. One that begins with a capital is needed to
/// understand the model; one that begins with a small letter is an addition, such as notes.
struct Section {
  std::string name;   ///< four letters
  std::string bytes;  ///< whatever the part is about
};

/// A part of the bytes of a file, which must outlive it.
struct SectionView {
  std::string name;        ///< four letters
  std::string_view bytes;  ///< its content
};

/// Format of the files that are written, and the newest that is read.
constexpr std::uint32_t kModelFormat = 1;

/// Number of bytes of the header, which is the same in all formats.
constexpr std::size_t kHeaderSize = 28;

/// Joins sections to the bytes of a file: a header with magic, format, size and checksum, then each
/// section with its name, length and CRC-32. docs/model_file.md has the layout. Throws
/// std::invalid_argument for a name that is not of four letters, or is there twice.
std::string join_sections(const std::vector<Section>& sections);

/// Checks a header against the size of the file, and returns the format. `header` are the first
/// bytes of the file, kHeaderSize of them if there are so many. Throws std::runtime_error that says
/// why this is no file, or not a whole one, that can be read: no model file, cut, of a newer
/// format, damaged.
std::uint32_t check_header(std::string_view header, std::uint64_t file_size);

/// Takes the bytes of a file apart. Throws std::runtime_error as check_header(), and if a checksum
/// is wrong, a name is bad, or there are fewer or more bytes than stated.
std::vector<SectionView> split_sections(std::string_view bytes);

}  // namespace ribbon_mapper
