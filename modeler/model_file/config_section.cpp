// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/model_file/config_section.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "modeler/config_keys.hpp"
#include "modeler/text/number_text.hpp"

namespace ribbon_mapper {
namespace {

using Values = std::vector<std::pair<std::string, double>>;  // in the order of visit_keys()

/// Lists all values; a switch is 0 or 1.
struct Listing {
  Values values;

  template <typename Value, typename... Range>
  void operator()(const char* key, const Value& value, Range...) {
    values.emplace_back(key, static_cast<double>(value));
  }
};

Values values_of(const ModelerConfig& config) {
  Listing listing;
  visit_keys(config, listing);
  return listing.values;
}

/// Sets the values of known keys.
struct Assignment {
  const std::map<std::string, double>& values;
  const ByteReader& from;

  template <typename Value>
  void operator()(const char* key, Value& value, double least, double most) const {
    const auto found = values.find(key);
    if (found == values.end()) return;
    if (!(found->second >= least && found->second <= most)) refuse(key);
    value = static_cast<Value>(found->second);
    if (static_cast<double>(value) != found->second) refuse(key);  // a fraction for a whole number
  }
  void operator()(const char* key, bool& value) const {
    const auto found = values.find(key);
    if (found == values.end()) return;
    if (found->second != 0.0 && found->second != 1.0) refuse(key);
    value = found->second == 1.0;
  }
  [[noreturn]] void refuse(const char* key) const {
    from.fail(std::string("has a value of ") + key + " that is out of range");
  }
};

}  // namespace

void write_config(const ModelerConfig& config, ByteWriter& to) {
  const Values values = values_of(config);
  to.integer(std::uint64_t{values.size()});
  for (const auto& [key, value] : values) {
    to.text(key);
    to.number(value);
  }
}

ModelerConfig read_config(ByteReader& from) {
  constexpr std::size_t kLeastBytes = 2 + 8;
  std::map<std::string, double> values;
  for (std::size_t left = from.count(kLeastBytes); left > 0; --left) {
    std::string key = from.text();
    values[std::move(key)] = from.number<double>();
  }
  ModelerConfig config;
  const Assignment assignment{values, from};
  visit_keys(config, assignment);
  return config;
}

std::vector<std::string> changed_keys(const ModelerConfig& before, const ModelerConfig& now) {
  const Values was = values_of(before), is = values_of(now);
  std::vector<std::string> changes;
  for (std::size_t i = 0; i < is.size(); ++i) {
    if (was[i].second == is[i].second) continue;
    changes.push_back(is[i].first + " was " + shortest_text(was[i].second) + ", is " +
                      shortest_text(is[i].second));
  }
  return changes;
}

}  // namespace ribbon_mapper
