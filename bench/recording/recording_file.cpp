// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/recording/recording_file.hpp"

#include <fstream>

namespace ribbon_mapper::bench {
namespace {

const std::string kVersion = "ribbon_mapper tour 1\n";

/// Archive for writing; pass_line() and pass_patch() list the fields for both directions.
struct Writer {
  std::ofstream stream;

  template <typename Plain>
  void plain(const Plain& value) {
    stream.write(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <typename Plain>
  void list(const std::vector<Plain>& values) {
    plain(values.size());
    stream.write(reinterpret_cast<const char*>(values.data()),
                 static_cast<std::streamsize>(values.size() * sizeof(Plain)));
  }
  void pose(const Pose& pose) { plain(pose.matrix()); }
};

/// Archive for reading.
struct Reader {
  std::ifstream stream;

  template <typename Plain>
  void plain(Plain& value) {
    stream.read(reinterpret_cast<char*>(&value), sizeof value);
  }
  template <typename Plain>
  void list(std::vector<Plain>& values) {
    std::size_t size = 0;
    plain(size);
    if (!stream || size > (std::size_t{1} << 32)) return stream.setstate(std::ios::failbit);
    values.resize(size);
    stream.read(reinterpret_cast<char*>(values.data()),
                static_cast<std::streamsize>(size * sizeof(Plain)));
  }
  void pose(Pose& pose) { plain(pose.matrix()); }
};

template <typename Archive, typename Line>
void pass_line(Archive& archive, Line& line) {
  archive.plain(line.beams.stamp);
  archive.plain(line.beams.angle_min_rad);
  archive.plain(line.beams.angle_increment_rad);
  archive.plain(line.beams.time_increment_s);
  archive.plain(line.beams.range_min_m);
  archive.plain(line.beams.range_max_m);
  archive.list(line.beams.ranges_m);
  archive.pose(line.poses.T_odom_base_first);
  archive.pose(line.poses.T_odom_base_last);
  archive.pose(line.poses.T_base_laser_first);
  archive.pose(line.poses.T_base_laser_last);
  archive.pose(line.poses.T_map_base);
  archive.pose(line.T_map_base_true);
  archive.pose(line.T_map_odom_true);
  archive.list(line.faces);
}

template <typename Archive, typename Patch>
void pass_patch(Archive& archive, Patch& patch) {
  archive.plain(patch.normal);
  archive.plain(patch.d_m);
  archive.plain(patch.area_m2);
  archive.list(patch.cells);
}

}  // namespace

void write_recording(const Recording& recording, const std::filesystem::path& file) {
  std::filesystem::create_directories(file.parent_path());
  auto unfinished = file;
  unfinished += ".part";
  {
    Writer writer{std::ofstream(unfinished, std::ios::binary)};
    writer.stream << kVersion << recording.name << '\n';
    writer.plain(recording.duration_s);
    writer.list(recording.face_normals);
    writer.plain(recording.lines.size());
    for (const RecordedLine& line : recording.lines) pass_line(writer, line);
    writer.plain(recording.truth.size());
    for (const eval::Patch& patch : recording.truth) pass_patch(writer, patch);
  }
  std::filesystem::rename(unfinished, file);
}

std::optional<Recording> read_recording(const std::filesystem::path& file) {
  Reader reader{std::ifstream(file, std::ios::binary)};
  std::string version;
  if (!std::getline(reader.stream, version) || version + "\n" != kVersion) return std::nullopt;
  Recording recording;
  std::getline(reader.stream, recording.name);
  reader.plain(recording.duration_s);
  reader.list(recording.face_normals);
  std::size_t count = 0;
  reader.plain(count);
  for (std::size_t i = 0; i < count && reader.stream; ++i) {
    pass_line(reader, recording.lines.emplace_back());
  }
  reader.plain(count);
  for (std::size_t i = 0; i < count && reader.stream; ++i) {
    pass_patch(reader, recording.truth.emplace_back());
  }
  if (!reader.stream) return std::nullopt;
  return recording;
}

}  // namespace ribbon_mapper::bench
