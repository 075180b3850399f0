// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/report/changed_keys.hpp"

#include "modeler/config_keys.hpp"
#include "modeler/text/number_text.hpp"

namespace ribbon_mapper {
namespace {

/// Lists all keys with their values.
struct Listing {
  std::vector<ChangedKey> keys;

  template <typename Number>
  void operator()(const char* key, const Number& value, double, double) {
    keys.push_back({key, shortest_text(value), ""});
  }
  void operator()(const char* key, const bool& value) {
    keys.push_back({key, value ? "true" : "false", ""});
  }
};

std::vector<ChangedKey> all_keys(const ModelerConfig& config) {
  Listing listing;
  visit_keys(config, listing);
  return listing.keys;
}

}  // namespace

std::vector<ChangedKey> changed_keys(const ModelerConfig& config) {
  const std::vector<ChangedKey> defaults = all_keys({});
  std::vector<ChangedKey> changed;
  std::size_t i = 0;
  for (ChangedKey& key : all_keys(config)) {
    key.default_value = defaults[i++].value;
    if (key.value != key.default_value) changed.push_back(key);
  }
  return changed;
}

}  // namespace ribbon_mapper
