// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag/bag_structure.hpp"

#include <bzlib.h>
#include <roslz4/lz4s.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace ribbon_mapper {
namespace {

// http://wiki.ros.org/Bags/Format/2.0
constexpr char kMagic[] = "#ROSBAG V2.0\n";
constexpr std::uint64_t kMaxHeader = 1 << 20;
constexpr std::uint64_t kMaxChunk = 1 << 29;  // rosbag writes chunks of 768 kB
enum class Op : std::uint8_t {
  message = 2,
  header = 3,
  index = 4,
  chunk = 5,
  chunk_info = 6,
  connection = 7
};

using Bytes = std::vector<char>;
using Fields = std::map<std::string, std::string>;

[[noreturn]] void fail(const std::string& what) { throw std::runtime_error(what); }

template <typename Number>
Number number_at(const char* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

/// Returns a field as a number. Throws if it is missing or of another size.
template <typename Number>
Number number_of(const Fields& fields, const char* name) {
  const auto found = fields.find(name);
  if (found == fields.end() || found->second.size() != sizeof(Number))
    fail(std::string("a record lacks its ") + name);
  return number_at<Number>(found->second.data());
}

Fields fields_of(const char* bytes, std::uint64_t size) {
  Fields fields;
  for (std::uint64_t at = 0; at < size;) {
    if (size - at < 4) fail("the header of a record is cut");
    const auto length = number_at<std::uint32_t>(bytes + at);
    at += 4;
    if (length > size - at) fail("a field reaches beyond its record");
    const std::string field(bytes + at, length);
    const std::size_t equal = field.find('=');
    if (equal == std::string::npos) fail("a field has no value");
    fields[field.substr(0, equal)] = field.substr(equal + 1);
    at += length;
  }
  return fields;
}

void require_op(const Fields& fields, Op op) {
  if (number_of<std::uint8_t>(fields, "op") != static_cast<std::uint8_t>(op))
    fail("a record is of another kind");
}

struct Record {
  Fields fields;
  std::uint64_t data_begin, data_size;
  std::uint64_t end() const { return data_begin + data_size; }
};

/// A file of which no byte beyond its end can be read.
class BagFile {
 public:
  explicit BagFile(const std::filesystem::path& file)
      : stream_(file, std::ios::binary), size_(std::filesystem::file_size(file)) {}

  Bytes bytes(std::uint64_t begin, std::uint64_t count) {
    if (begin > size_ || count > size_ - begin) fail("a record reaches beyond the end");
    Bytes bytes(count);
    stream_.seekg(static_cast<std::streamoff>(begin));
    if (!stream_.read(bytes.data(), static_cast<std::streamsize>(count))) fail("it cannot be read");
    return bytes;
  }

  Record record(std::uint64_t begin, Op op) {
    const std::uint64_t header_size = length(begin);
    if (header_size > kMaxHeader) fail("the header of a record is too long");
    const Bytes header = bytes(begin + 4, header_size);
    Record record{fields_of(header.data(), header.size()), begin + 8 + header_size, 0};
    require_op(record.fields, op);
    record.data_size = length(record.data_begin - 4);
    if (record.data_size > size_ - record.data_begin) fail("a record reaches beyond the end");
    return record;
  }

 private:
  std::uint32_t length(std::uint64_t at) { return number_at<std::uint32_t>(bytes(at, 4).data()); }

  std::ifstream stream_;
  std::uint64_t size_;
};

Bytes chunk_content(BagFile& file, const Record& chunk) {
  const auto size = number_of<std::uint32_t>(chunk.fields, "size");
  if (size > kMaxChunk || chunk.data_size > kMaxChunk) fail("a chunk is too large");
  Bytes data = file.bytes(chunk.data_begin, chunk.data_size);
  const auto found = chunk.fields.find("compression");
  const std::string compression = found == chunk.fields.end() ? "" : found->second;
  if (compression == "none" && size == data.size()) return data;
  Bytes content(size);
  unsigned int written = size;
  const auto data_size = static_cast<unsigned int>(data.size());
  const bool is_good =
      (compression == "bz2" && BZ2_bzBuffToBuffDecompress(content.data(), &written, data.data(),
                                                          data_size, 0, 0) == BZ_OK) ||
      (compression == "lz4" &&
       roslz4_buffToBuffDecompress(data.data(), data_size, content.data(), &written) == ROSLZ4_OK);
  if (!is_good || written != size) fail("a chunk cannot be unpacked");
  return content;
}

void check_message(const Bytes& chunk, std::uint64_t begin) {
  const auto length_at = [&](std::uint64_t at) -> std::uint64_t {
    if (at > chunk.size() || chunk.size() - at < 4) fail("a message lies beyond its chunk");
    return number_at<std::uint32_t>(chunk.data() + at);
  };
  const std::uint64_t header_size = length_at(begin);
  const std::uint64_t data_size = length_at(begin + 4 + header_size);
  if (data_size > chunk.size() - (begin + 8 + header_size))
    fail("a message reaches beyond its chunk");
  require_op(fields_of(chunk.data() + begin + 4, header_size), Op::message);
}

void check_chunk(BagFile& file, const Record& info) {
  const Record chunk = file.record(number_of<std::uint64_t>(info.fields, "chunk_pos"), Op::chunk);
  const Bytes content = chunk_content(file, chunk);
  std::uint64_t at = chunk.end();
  for (auto left = number_of<std::uint32_t>(info.fields, "count"); left > 0; --left) {
    const Record index = file.record(at, Op::index);
    const std::uint64_t count = number_of<std::uint32_t>(index.fields, "count");
    if (index.data_size != 12 * count) fail("an index has another length than it says");
    const Bytes entries = file.bytes(index.data_begin, index.data_size);
    for (std::uint64_t i = 0; i < count; ++i)
      check_message(content, number_at<std::uint32_t>(entries.data() + 12 * i + 8));
    at = index.end();
  }
}

}  // namespace

void check_bag_structure(const std::filesystem::path& path) {
  BagFile file(path);
  constexpr std::uint64_t kBegin = sizeof kMagic - 1;
  const Bytes magic = file.bytes(0, kBegin);
  if (std::memcmp(magic.data(), kMagic, kBegin) != 0) return;
  const Fields header = file.record(kBegin, Op::header).fields;
  auto at = number_of<std::uint64_t>(header, "index_pos");
  if (at == 0) return;
  for (auto left = number_of<std::uint32_t>(header, "conn_count"); left > 0; --left)
    at = file.record(at, Op::connection).end();
  for (auto left = number_of<std::uint32_t>(header, "chunk_count"); left > 0; --left) {
    const Record info = file.record(at, Op::chunk_info);
    check_chunk(file, info);
    at = info.end();
  }
}

}  // namespace ribbon_mapper
