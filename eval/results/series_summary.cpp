// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/series_summary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "eval/metrics/statistics.hpp"
#include "eval/results/format.hpp"
#include "eval/results/label_report.hpp"
#include "modeler/program/version.hpp"
#include "modeler/text/ordered_json.hpp"

namespace ribbon_mapper::eval {
namespace {

/// A column of the table.
struct Column {
  const char* key;                  ///< in LoggedRun::figures
  std::array<const char*, 2> head;  ///< upper and lower line
  int width, decimals;
  double scale;  ///< from the figure's unit to the table's
};

const std::array<Column, 14> kColumns{{
    {"planes_noisy_as_built", {"noisy", "as built"}, 9, 0, 1},
    {"planes_noisy", {"noisy", "final"}, 6, 0, 1},
    {"planes_corrected_as_built", {"corrected", "as built"}, 10, 0, 1},
    {"planes_corrected", {"corrected", "final"}, 10, 0, 1},
    {"truth_planes", {"", "truth"}, 6, 0, 1},
    {"missed", {"", "missed"}, 7, 0, 1},
    {"extra", {"", "extra"}, 6, 0, 1},
    {"duplicates", {"", "duplicates"}, 11, 0, 1},
    {"f1", {"", "f1"}, 6, 3, 1},
    {"four_models.corrected.segcomp.correct", {"segcomp", "correct"}, 8, 0, 1},
    {"angle_error_deg_median", {"angle", "deg"}, 6, 2, 1},
    {"offset_error_m_median", {"offset", "mm"}, 7, 1, 1000},
    {"end_drift_m", {"end drift", "m"}, 10, 2, 1},
    {"end_drift_deg", {"end drift", "deg"}, 10, 1, 1},
}};

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

double figure(const LoggedRun& logged, const std::string& key) {
  const auto found = logged.figures.find(key);
  return found == logged.figures.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

bool is_right(const LoggedRun& r) {
  return figure(r, "missed") == 0 && figure(r, "extra") == 0 && figure(r, "duplicates") == 0;
}

long right_count(const std::vector<LoggedRun>& runs) {
  return std::count_if(runs.begin(), runs.end(), is_right);
}

/// Returns a quantile over the runs that have the figure.
double quantile_of(const std::vector<LoggedRun>& runs, const std::string& key, double share) {
  std::vector<double> values;
  for (const LoggedRun& logged : runs) {
    const double value = figure(logged, key);
    if (!std::isnan(value)) values.push_back(value);
  }
  return quantile(values, share);
}

std::vector<std::vector<LoggedRun>> groups_of(const std::vector<LoggedRun>& runs) {
  std::vector<std::vector<LoggedRun>> groups;
  for (const LoggedRun& logged : runs) {
    if (groups.empty() || !is_repetition(groups.back().front().run, logged.run)) {
      groups.emplace_back();
    }
    groups.back().push_back(logged);
  }
  return groups;
}

std::vector<RunOptions> options_of(const std::vector<LoggedRun>& runs) {
  std::vector<RunOptions> options;
  for (const LoggedRun& logged : runs) options.push_back(logged.run);
  return options;
}

/// Returns the label of the group's runs without the seed.
std::string group_label(const std::vector<LoggedRun>& group, const std::vector<RunOptions>& all) {
  const std::string label = label_of(group.front().run, all);
  const std::size_t seed = label.rfind("seed ");
  return seed >= 2 ? label.substr(0, seed - 2) : "";
}

Json distribution_json(const std::vector<LoggedRun>& group) {
  Json json = Json::object();
  for (const auto& entry : group.front().figures) {
    const auto at = [&](double share) { return quantile_of(group, entry.first, share); };
    json[entry.first] = {{"min", at(0.0)},
                         {"lower_quartile", at(0.25)},
                         {"median", at(0.5)},
                         {"upper_quartile", at(0.75)},
                         {"max", at(1.0)}};
  }
  return json;
}

/// Returns the summary of a group with the conditions as in runs.jsonl.
Json group_json(const std::vector<LoggedRun>& group) {
  const auto line = Json::parse(group.front().line);
  Json json;
  for (const char* key : {"world", "route", "config", "noise", "tilt", "closure", "caster", "beams",
                          "rate_hz", "speed_m_s", "deskew", "drift"}) {
    json[key] = line.at(key);
  }
  for (const char* key : {"base_laser", "odometry_faults"}) {
    if (line.contains(key)) json[key] = line.at(key);
  }
  json["runs"] = group.size();
  json["right"] = right_count(group);
  json["distribution"] = distribution_json(group);
  return json;
}

/// Returns the matrix of labels over all runs, empty if none has one.
std::string labels_foot(const std::vector<LoggedRun>& runs) {
  LabelConfusion all;
  for (const LoggedRun& logged : runs) all.add(label_confusion_of(logged.figures, "labels."));
  return all.compared_m2() > 0.0 ? "\n" + label_table(all) : "";
}

}  // namespace

std::string series_table_head(std::size_t label_width) {
  std::string text;
  for (const std::size_t line : {0U, 1U}) {
    text += std::string(label_width, ' ');
    for (const Column& column : kColumns) text += format("%*s", column.width, column.head[line]);
    text += "\n";
  }
  return text;
}

std::string series_table_row(const std::string& label, const LoggedRun& logged,
                             std::size_t label_width) {
  return table_row(label, label_width, [&](const char* key) { return figure(logged, key); });
}

std::string series_table_foot(const std::vector<LoggedRun>& runs, std::size_t label_width) {
  std::string foot;
  const std::vector<RunOptions> all = options_of(runs);
  for (const auto& group : groups_of(runs)) {
    const std::string label = group_label(group, all);
    if (!label.empty()) foot += label + ", " + std::to_string(group.size()) + " runs\n";
    const auto row = [&](const char* name, double share) {
      return table_row(name, label_width,
                       [&](const char* key) { return quantile_of(group, key, share); });
    };
    foot += row("min", 0.0) + row("median", 0.5) + row("max", 1.0);
  }
  return foot + labels_foot(runs) + "\n" + std::to_string(right_count(runs)) + " of " +
         std::to_string(runs.size()) +
         " runs found every true plane once, and nothing else, after the correction\n";
}

std::size_t label_width_of(const std::vector<RunOptions>& runs) {
  std::size_t width = 8;
  for (const RunOptions& run : runs) width = std::max(width, label_of(run, runs).size() + 1);
  return width;
}

std::string series_summary_to_json(const std::vector<LoggedRun>& runs, const std::string& command) {
  Json json{{"command", command},
            {"version", version()},
            {"runs", runs.size()},
            {"right", right_count(runs)}};
  json["groups"] = Json::array();
  for (const auto& group : groups_of(runs)) json["groups"].push_back(group_json(group));
  return json.dump(2) + "\n";
}

}  // namespace ribbon_mapper::eval
