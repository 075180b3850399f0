// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/report.hpp"

#include <cstdio>
#include <fstream>
#include <set>

#include "modeler/storage/atomic_file.hpp"
#include "modeler/storage/disk.hpp"

namespace ribbon_mapper::bench {
namespace {

std::string formatted(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string time_text(double seconds) {
  if (seconds >= 1.0) return formatted("%.2f s", seconds);
  if (seconds >= 1e-3) return formatted("%.2f ms", 1e3 * seconds);
  if (seconds >= 1e-6) return formatted("%.2f us", 1e6 * seconds);
  return formatted("%.1f ns", 1e9 * seconds);
}

std::string or_dash(const char* format, const std::optional<double>& value) {
  return value ? formatted(format, *value) : "-";
}

nlohmann::json or_null(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

nlohmann::json to_json(const Row& row) {
  return {{"section", row.section},
          {"name", row.name},
          {"seconds", or_null(row.seconds)},
          {"ns_per_item", or_null(row.ns_per_item)},
          {"over_ours", or_null(row.over_ours)},
          {"peak_mb", or_null(row.peak_mb)},
          {"accuracy", row.accuracy},
          {"details", row.details}};
}

nlohmann::json read_json(const std::filesystem::path& path) {
  std::ifstream file(path);
  const auto json = nlohmann::json::parse(file, nullptr, false);
  return json.is_object() ? json : nlohmann::json::object();
}

std::string value_of(const std::filesystem::path& file, const std::string& key) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind(key, 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

}  // namespace

void Report::begin_with(const std::string& section_prefix, const std::string& ratio_prefix) {
  section_prefix_ = section_prefix;
  ratio_prefix_ = ratio_prefix;
}

void Report::add(Row row) {
  row.section = section_prefix_ + row.section;
  if (rows_.empty() || rows_.back().section != row.section) {
    std::printf("\n%-68s %10s %9s %10s %8s  %s\n", row.section.c_str(), "time", "ns/item",
                "over ours", "peak MB", "accuracy");
  }
  std::printf("%-68s %10s %9s %10s %8s  %s\n", row.name.c_str(),
              row.seconds ? time_text(*row.seconds).c_str() : "-",
              or_dash("%.1f", row.ns_per_item).c_str(), or_dash("%.2f", row.over_ours).c_str(),
              or_dash("%.0f", row.peak_mb).c_str(), row.accuracy.c_str());
  std::fflush(stdout);
  rows_.push_back(row);
}

std::string Report::summary_text() const {
  std::string text;
  for (const auto& [name, value] : summary_) {
    text += name + std::string(name.size() < 34 ? 34 - name.size() : 1, ' ') +
            formatted("%10.3f\n", value);
  }
  return text;
}

void Report::write(const std::filesystem::path& directory, bool keep_others) const {
  nlohmann::json before =
      keep_others ? read_json(directory / "bench.json") : nlohmann::json::object();
  nlohmann::json rows = nlohmann::json::array();
  std::set<std::string> sections;
  for (const Row& row : rows_) sections.insert(row.section);
  for (const auto& row : before.value("rows", nlohmann::json::array())) {
    if (sections.count(row["section"].get<std::string>()) == 0) rows.push_back(row);
  }
  for (const Row& row : rows_) rows.push_back(to_json(row));
  nlohmann::json summary = before.value("summary", nlohmann::json::object());
  summary.update(nlohmann::json(summary_));
  const nlohmann::json all = {{"machine", machine()}, {"rows", rows}, {"summary", summary}};
  create_directory_for_files(directory);
  write_file_atomically(directory / "bench.json", all.dump(2) + "\n");
  write_file_atomically(directory / "summary.json", summary.dump(2) + "\n");
}

nlohmann::json machine() {
  return {{"processor", value_of("/proc/cpuinfo", "model name")},
          {"cache", value_of("/proc/cpuinfo", "cache size")},
          {"compiler", std::string("gcc ") + __VERSION__},
          {"flags", RIBBON_MAPPER_FLAGS},
          {"peers", RIBBON_MAPPER_PEERS}};
}

}  // namespace ribbon_mapper::bench
