// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/model_file/sections.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include "modeler/model_file/byte_reader.hpp"
#include "modeler/model_file/byte_writer.hpp"

namespace ribbon_mapper {
namespace {

// As in PNG, a byte beyond ASCII, and a line end, which a transfer as text would change.
constexpr std::string_view kMagic = "\x89RIBBON\n";
constexpr std::size_t kNameSize = 4;
constexpr std::size_t kSectionHead = kNameSize + 8 + 4;  // name, length, checksum

std::uint32_t crc_of(std::string_view bytes, uLong before = 0) {
  constexpr std::size_t kStep = std::numeric_limits<uInt>::max();
  uLong crc = before;
  while (!bytes.empty()) {
    const std::string_view step = bytes.substr(0, kStep);
    crc = crc32(crc, reinterpret_cast<const Bytef*>(step.data()), static_cast<uInt>(step.size()));
    bytes.remove_prefix(step.size());
  }
  return static_cast<std::uint32_t>(crc);
}

bool is_name(std::string_view name) {
  const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
  return name.size() == kNameSize && std::all_of(name.begin(), name.end(), is_letter);
}

std::string head_of(const Section& section) {
  ByteWriter head;
  head.bytes(section.name);
  head.integer(std::uint64_t{section.bytes.size()});
  return head.take();
}

std::string header_of(std::size_t sections, std::uint64_t file_size) {
  ByteWriter header;
  header.bytes(kMagic);
  header.integer(kModelFormat);
  header.integer(static_cast<std::uint32_t>(sections));
  header.integer(file_size);
  std::string bytes = header.take();
  ByteWriter crc;
  crc.integer(crc_of(bytes));
  return bytes + crc.take();
}

SectionView next_section(ByteReader& file) {
  const std::string_view head = file.bytes(kNameSize + 8);
  const auto crc = file.integer<std::uint32_t>();
  const std::string name(head.substr(0, kNameSize));
  ByteReader length(head.substr(kNameSize), "list");
  const auto size = length.integer<std::uint64_t>();
  if (!is_name(name) || size > file.left()) {
    throw std::runtime_error("it is damaged: the list of its parts is wrong");
  }
  const std::string_view bytes = file.bytes(static_cast<std::size_t>(size));
  if (crc_of(bytes, crc_of(head)) != crc) {
    throw std::runtime_error("it is damaged: the checksum of part " + name + " is wrong");
  }
  return {name, bytes};
}

}  // namespace

std::string join_sections(const std::vector<Section>& sections) {
  std::uint64_t size = kHeaderSize;
  std::set<std::string> names;
  for (const Section& section : sections) {
    if (!is_name(section.name) || !names.insert(section.name).second) {
      throw std::invalid_argument("a part of a model file needs a name of four letters, its own: " +
                                  section.name);
    }
    size += kSectionHead + section.bytes.size();
  }
  ByteWriter file;
  file.reserve(static_cast<std::size_t>(size));
  file.bytes(header_of(sections.size(), size));
  for (const Section& section : sections) {
    const std::string head = head_of(section);
    file.bytes(head);
    file.integer(crc_of(section.bytes, crc_of(head)));
    file.bytes(section.bytes);
  }
  return file.take();
}

std::uint32_t check_header(std::string_view header, std::uint64_t file_size) {
  if (header.substr(0, kMagic.size()) != kMagic) {
    throw std::runtime_error("it is no model file of ribbon_mapper (*.ribbons)");
  }
  if (header.size() < kHeaderSize) throw std::runtime_error("it is cut off in its header");
  ByteReader reader(header.substr(kMagic.size(), kHeaderSize - kMagic.size()), "header");
  const auto format = reader.integer<std::uint32_t>();
  reader.integer<std::uint32_t>();
  const auto size = reader.integer<std::uint64_t>();
  if (reader.integer<std::uint32_t>() != crc_of(header.substr(0, kHeaderSize - 4)) || format == 0) {
    throw std::runtime_error("it is damaged: the checksum of its header is wrong");
  }
  if (format > kModelFormat) {
    throw std::runtime_error("it is of format " + std::to_string(format) +
                             ", and this program reads up to format " +
                             std::to_string(kModelFormat) + ": use the version that wrote it");
  }
  if (file_size != size) {
    throw std::runtime_error((file_size < size ? "it is cut off: " : "it is too long: ") +
                             std::to_string(file_size) + " bytes instead of " +
                             std::to_string(size));
  }
  return format;
}

std::vector<SectionView> split_sections(std::string_view bytes) {
  check_header(bytes.substr(0, kHeaderSize), bytes.size());
  ByteReader count(bytes.substr(kMagic.size() + 4, 4), "header");
  ByteReader file(bytes.substr(kHeaderSize), "list");
  std::vector<SectionView> sections;
  std::set<std::string> names;
  for (auto left = count.integer<std::uint32_t>(); left > 0; --left) {
    sections.push_back(next_section(file));
    const std::string& name = sections.back().name;
    if (!names.insert(name).second) throw std::runtime_error("it has part " + name + " twice");
  }
  file.expect_end();
  return sections;
}

}  // namespace ribbon_mapper
