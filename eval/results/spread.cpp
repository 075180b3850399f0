// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/spread.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "eval/metrics/statistics.hpp"
#include "modeler/program/version.hpp"

namespace ribbon_mapper::eval {
namespace {

/// How the table shows a figure of a run.
struct Column {
  const char* key;
  const char* head;
  int width, decimals;
  double scale;  ///< of the table's unit
};

const std::array<Column, 14> kColumns{{
    {"planes_noisy_as_built", "noisy", 6, 0, 1},
    {"planes_noisy", "merged", 7, 0, 1},
    {"planes_corrected_as_built", "corrected", 10, 0, 1},
    {"planes_corrected", "merged", 7, 0, 1},
    {"truth_planes", "truth", 6, 0, 1},
    {"missed", "missed", 7, 0, 1},
    {"extra", "extra", 6, 0, 1},
    {"duplicates", "double", 7, 0, 1},
    {"f1", "f1", 6, 3, 1},
    {"four_cells.corrected.segcomp.correct", "segcomp", 8, 0, 1},
    {"angle_error_deg_median", "deg", 6, 2, 1},
    {"offset_error_m_median", "mm", 6, 1, 1000},
    {"end_drift_m", "off m", 7, 2, 1},
    {"end_drift_deg", "off deg", 8, 1, 1},
}};

template <typename... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  std::array<char, 256> text;
  std::snprintf(text.data(), text.size(), pattern, arguments...);
  return text.data();
}

template <typename Value>
std::string table_row(const std::string& label, std::size_t label_width, const Value& value_of) {
  std::string row = format("%-*s", static_cast<int>(label_width), label.c_str());
  for (const Column& column : kColumns) {
    const double value = value_of(column.key) * column.scale;
    row += std::isnan(value) ? format("%*s", column.width, "-")
                             : format("%*.*f", column.width, column.decimals, value);
  }
  return row + "\n";
}

double figure(const Record& record, const std::string& key) {
  const auto found = record.figures.find(key);
  return found == record.figures.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

bool is_right(const Record& r) {
  return figure(r, "missed") == 0 && figure(r, "extra") == 0 && figure(r, "duplicates") == 0;
}

long right_count(const std::vector<Record>& records) {
  return std::count_if(records.begin(), records.end(), is_right);
}

/// Quantile over the runs that have the figure.
double spread_of(const std::vector<Record>& records, const std::string& key, double share) {
  std::vector<double> values;
  for (const Record& record : records) {
    const double value = figure(record, key);
    if (!std::isnan(value)) values.push_back(value);
  }
  return quantile(values, share);
}

std::vector<std::vector<Record>> groups_of(const std::vector<Record>& records) {
  std::vector<std::vector<Record>> groups;
  for (const Record& record : records) {
    if (groups.empty() || !is_repetition(groups.back().front().run, record.run)) {
      groups.emplace_back();
    }
    groups.back().push_back(record);
  }
  return groups;
}

std::vector<RunOptions> runs_of(const std::vector<Record>& records) {
  std::vector<RunOptions> runs;
  for (const Record& record : records) runs.push_back(record.run);
  return runs;
}

/// The label of its runs, without their seed.
std::string group_label(const std::vector<Record>& group, const std::vector<RunOptions>& all) {
  const std::string label = label_of(group.front().run, all);
  const std::size_t seed = label.rfind("seed ");
  return seed >= 2 ? label.substr(0, seed - 2) : "";
}

nlohmann::ordered_json spread_json(const std::vector<Record>& group) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& entry : group.front().figures) {
    const auto at = [&](double share) { return spread_of(group, entry.first, share); };
    json[entry.first] = {{"least", at(0.0)},
                         {"lower_quartile", at(0.25)},
                         {"median", at(0.5)},
                         {"upper_quartile", at(0.75)},
                         {"most", at(1.0)}};
  }
  return json;
}

/// The conditions as the lines have them.
nlohmann::ordered_json group_json(const std::vector<Record>& group) {
  const auto line = nlohmann::ordered_json::parse(group.front().line);
  nlohmann::ordered_json json;
  for (const char* key : {"world", "route", "config", "noise", "tilt", "caster", "beams",
                          "speed_m_s", "deskew", "drift"}) {
    json[key] = line.at(key);
  }
  json["runs"] = group.size();
  json["right"] = right_count(group);
  json["spread"] = spread_json(group);
  return json;
}

}  // namespace

std::string spread_head(std::size_t label_width) {
  std::string head(label_width, ' ');
  for (const Column& column : kColumns) head += format("%*s", column.width, column.head);
  return head + "\n";
}

std::string spread_row(const std::string& label, const Record& record, std::size_t label_width) {
  return table_row(label, label_width, [&](const char* key) { return figure(record, key); });
}

std::string spread_foot(const std::vector<Record>& records, std::size_t label_width) {
  std::string foot;
  const std::vector<RunOptions> all = runs_of(records);
  for (const auto& group : groups_of(records)) {
    const std::string label = group_label(group, all);
    if (!label.empty()) foot += label + ", " + std::to_string(group.size()) + " runs\n";
    const auto row = [&](const char* name, double share) {
      return table_row(name, label_width,
                       [&](const char* key) { return spread_of(group, key, share); });
    };
    foot += row("least", 0.0) + row("median", 0.5) + row("most", 1.0);
  }
  return foot + "\n" + std::to_string(right_count(records)) + " of " +
         std::to_string(records.size()) +
         " runs found every true plane once, and nothing else, after the correction\n";
}

std::size_t label_width_of(const std::vector<RunOptions>& runs) {
  std::size_t width = 8;
  for (const RunOptions& run : runs) width = std::max(width, label_of(run, runs).size() + 1);
  return width;
}

std::string sweep_summary_to_json(const std::vector<Record>& records, const std::string& command) {
  nlohmann::ordered_json json{{"command", command},
                              {"version", version()},
                              {"runs", records.size()},
                              {"right", right_count(records)}};
  json["groups"] = nlohmann::ordered_json::array();
  for (const auto& group : groups_of(records)) json["groups"].push_back(group_json(group));
  return json.dump(2) + "\n";
}

}  // namespace ribbon_mapper::eval
