// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/spread.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

namespace ribbon_mapper::eval {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

const MapMetrics& result(const Summary& s) { return s.cells.corrected_merged; }

/// A figure of a run: its key in summary.json, and how the table shows it.
struct Column {
  const char* key;
  const char* head;
  int width, decimals;
  double scale;  ///< of the table's unit
  double (*value)(const Summary&);
};

const std::array<Column, 15> kColumns{{
    {"planes_noisy_raw", "noisy", 6, 0, 1,
     [](const Summary& s) { return double(s.cells.noisy_raw.planes); }},
    {"planes_noisy_merged", "merged", 7, 0, 1,
     [](const Summary& s) { return double(s.cells.noisy_merged.planes); }},
    {"planes_corrected_raw", "corrected", 10, 0, 1,
     [](const Summary& s) { return double(s.cells.corrected_raw.planes); }},
    {"planes_corrected_merged", "merged", 7, 0, 1,
     [](const Summary& s) { return double(result(s).planes); }},
    {"truth_planes", "truth", 6, 0, 1, [](const Summary& s) { return double(result(s).truth); }},
    {"missed", "missed", 7, 0, 1, [](const Summary& s) { return double(result(s).missed.size()); }},
    {"extra", "extra", 6, 0, 1, [](const Summary& s) { return double(result(s).extra.size()); }},
    {"duplicates", "double", 7, 0, 1,
     [](const Summary& s) { return double(result(s).duplicates.size()); }},
    {"f1", "f1", 6, 3, 1, [](const Summary& s) { return result(s).f1; }},
    {"angle_error_deg_mean", "deg", 6, 2, 1,
     [](const Summary& s) { return result(s).angle_error_deg_mean.value_or(kNothing); }},
    {"offset_error_m_mean", "mm", 6, 1, 1000,
     [](const Summary& s) { return result(s).offset_error_m_mean.value_or(kNothing); }},
    {"end_drift_m", "off m", 7, 2, 1, [](const Summary& s) { return s.end_drift_m; }},
    {"end_drift_deg", "off deg", 8, 1, 1, [](const Summary& s) { return s.end_drift_deg; }},
    {"us_per_line", "us/line", 8, 0, 1, [](const Summary& s) { return s.us_per_line; }},
    {"correction_ms", "corr. ms", 9, 0, 1, [](const Summary& s) { return s.correction_ms; }},
}};

template <typename Value>
std::string table_row(const std::string& name, const Value& value_of) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%-8s", name.c_str());
  std::string row = text.data();
  for (const Column& column : kColumns) {
    const double value = value_of(column) * column.scale;
    std::snprintf(text.data(), text.size(), "%*.*f", column.width, column.decimals, value);
    row += std::isnan(value) ? std::string(std::size_t(column.width) - 1, ' ') + "-" : text.data();
  }
  return row + "\n";
}

bool is_right(const Summary& summary) {
  const MapMetrics& m = result(summary);
  return m.missed.empty() && m.extra.empty() && m.duplicates.empty();
}

long right_count(const std::vector<Summary>& summaries) {
  return std::count_if(summaries.begin(), summaries.end(), is_right);
}

struct Spread {
  double least = kNothing, median = kNothing, most = kNothing;
};

/// Over the runs that have the figure.
Spread spread_of(const std::vector<Summary>& summaries, const Column& column) {
  std::vector<double> values;
  for (const Summary& summary : summaries) values.push_back(column.value(summary));
  values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return std::isnan(v); }),
               values.end());
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  const double median =
      values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
  return {values.front(), median, values.back()};
}

}  // namespace

std::string spread_head() {
  std::string head = "seed    ";
  std::array<char, 32> text;
  for (const Column& column : kColumns) {
    std::snprintf(text.data(), text.size(), "%*s", column.width, column.head);
    head += text.data();
  }
  return head + "\n";
}

std::string spread_row(const Summary& summary) {
  return table_row(std::to_string(summary.seed),
                   [&](const Column& column) { return column.value(summary); });
}

std::string spread_foot(const std::vector<Summary>& summaries) {
  const auto row = [&](const char* name, double Spread::*which) {
    return table_row(name, [&](const Column& c) { return spread_of(summaries, c).*which; });
  };
  return row("least", &Spread::least) + row("median", &Spread::median) +
         row("most", &Spread::most) + "\n" + std::to_string(right_count(summaries)) + " of " +
         std::to_string(summaries.size()) +
         " runs found every true plane once, and nothing else, after the correction\n";
}

std::string spread_to_json(const std::vector<Summary>& summaries) {
  nlohmann::ordered_json json{{"runs", summaries.size()}, {"right", right_count(summaries)}};
  for (const Column& column : kColumns) {
    const Spread spread = spread_of(summaries, column);  // NaN becomes null
    json["spread"][column.key] = {
        {"least", spread.least}, {"median", spread.median}, {"most", spread.most}};
  }
  json["version"] = RIBBON_MAPPER_VERSION;
  return json.dump(2) + "\n";
}

}  // namespace ribbon_mapper::eval
