// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/offline/offline_summary.hpp"

#include <iomanip>
#include <locale>
#include <sstream>

#include "modeler/program/version.hpp"
#include "modeler/text/ordered_json.hpp"

namespace ribbon_mapper {
namespace {

Json counts(const std::map<std::string, std::size_t>& by_reason) {
  return by_reason.empty() ? Json::object() : Json(by_reason);
}

Json to_json(const std::vector<ChangedKey>& keys) {
  Json json = Json::object();
  for (const ChangedKey& key : keys) json[key.name] = Json::parse(key.value);
  return json;
}

Json to_json(const std::optional<BaseScanFigures>& base) {
  if (!base) return nullptr;
  return {{"scan_topic", base->topic},
          {"scans", base->scans},
          {"matched", base->matched},
          {"dropped", counts(base->dropped)}};
}

Json to_json(const std::optional<EstimateFigures>& estimate) {
  if (!estimate) return nullptr;
  Json json;
  for (const auto& [name, sigma] : named_sigmas(estimate->precision)) json[name] = sigma;
  json["noise_scale"] = estimate->noise_scale;
  json["base_laser"] = to_json(estimate->base_scans);
  json["decisions"] = estimate->decisions;
  return json;
}

}  // namespace

std::size_t dropped_total(const OfflineSummary& summary) {
  std::size_t total = 0;
  for (const auto& [reason, count] : summary.dropped_lines) total += count;
  return total;
}

double real_time_factor(const OfflineSummary& summary) {
  return summary.wall_s > 0.0 ? summary.recording_s / summary.wall_s : 0.0;
}

std::string summary_to_json(const OfflineSummary& s, const std::string& run_id) {
  const Json json{
      {"run", run_id},
      {"bags", s.bags},
      {"config", s.config},
      {"parameters", to_json(s.parameters)},
      {"scan_topic", s.scan_topic},
      {"trajectory", s.trajectory},
      {"moved_m", s.moved_m ? Json(*s.moved_m) : Json(nullptr)},
      {"estimate", to_json(s.estimate)},
      {"notes", s.notes},
      {"lines", s.lines},
      {"lost_lines", s.lost_lines},
      {"dropped_lines", counts(s.dropped_lines)},
      {"dropped_lines_total", dropped_total(s)},
      {"newest_drop", s.newest_drop},
      {"handled_lines", counts(s.handled_lines)},
      {"repeated_transforms", s.repeated_transforms},
      {"refused_transforms", s.refused_transforms},
      {"ribbons", s.ribbons},
      {"planes_before", s.planes_before},
      {"planes", s.planes},
      {"duplicates", s.duplicates},
      {"points", s.points},
      {"residual_m_median", s.residual_m_median ? Json(*s.residual_m_median) : Json(nullptr)},
      {"recording_s", s.recording_s},
      {"real_time_factor", real_time_factor(s)},
      {"wall_s", s.wall_s},
      {"cpu_s", s.cpu_s},
      {"peak_memory_mib", s.peak_memory_mib},
      {"version", version()}};
  return json.dump(2) + "\n";
}

std::string summary_text(const OfflineSummary& s) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::fixed << std::setprecision(1);
  for (const std::string& note : s.notes) text << "WARNING " << note << "\n";
  text << s.lines << " lines, " << dropped_total(s) << " dropped, " << s.ribbons << " ribbons\n";
  for (const auto& [reason, count] : s.dropped_lines) {
    text << "  dropped: " << count << " x " << reason << "\n";
  }
  if (!s.newest_drop.empty()) text << "  the last of these: " << s.newest_drop << "\n";
  for (const auto& [outcome, count] : s.handled_lines)
    text << "  " << outcome << ": " << count << "\n";
  text << s.planes << " planes (" << s.planes_before << " as built on the way), " << s.duplicates
       << (s.duplicates == 1 ? " duplicate" : " duplicates");
  if (s.residual_m_median) text << ", median residual " << 1e3 * *s.residual_m_median << " mm";
  text << "\nposes: " << s.trajectory;
  if (s.moved_m) text << "; moved by up to " << std::setprecision(2) << *s.moved_m << " m";
  text << std::setprecision(1) << "\n";
  text << s.recording_s << " s of recording in " << std::setprecision(2) << s.wall_s << " s ("
       << std::setprecision(0) << real_time_factor(s) << " x real time, " << std::setprecision(2)
       << s.cpu_s << " s CPU), peak memory " << std::setprecision(0) << s.peak_memory_mib
       << " MiB\n";
  return text.str();
}

}  // namespace ribbon_mapper
