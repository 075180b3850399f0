// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/config_file.hpp"

#include <yaml-cpp/yaml.h>

#include <array>
#include <charconv>
#include <ios>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "modeler/config_keys.hpp"
#include "modeler/io/renamed_keys.hpp"

namespace ribbon_mapper {
namespace {

using Values = std::map<std::string, YAML::Node>;  // by "section.key"

void flatten(const YAML::Node& node, const std::string& prefix, Values& values) {
  for (const auto& entry : node) {
    const std::string key = prefix + entry.first.as<std::string>();
    if (entry.second.IsMap()) {
      flatten(entry.second, key + ".", values);
    } else if (!values.emplace(key, entry.second).second) {
      throw std::invalid_argument(key + " is given twice");
    }
  }
}

/// Assigns the values of known keys and removes them from `values`.
struct Assignment {
  Values& values;
  std::string known;

  template <typename Number>
  void operator()(const char* key, Number& value, double, double) {
    assign(key, value, "a number");
  }
  void operator()(const char* key, bool& value) { assign(key, value, "true or false"); }

 private:
  template <typename Value>
  void assign(const char* key, Value& value, const char* kind) {
    known += std::string("\n  ") + key;
    const auto found = values.find(key);
    if (found == values.end()) return;
    try {
      value = found->second.as<Value>();
    } catch (const YAML::Exception&) {
      throw std::invalid_argument(std::string(key) + " must be " + kind);
    }
    values.erase(found);
  }
};

ModelerConfig read(const std::string& path) {
  const YAML::Node root = YAML::LoadFile(path);
  if (!root.IsMap() && !root.IsNull()) {
    throw std::invalid_argument("sections with keys are expected, as in config/pr2.yaml");
  }
  Values values;
  flatten(root, "", values);
  ModelerConfig config;
  Assignment assignment{values, {}};
  visit_keys(config, assignment);
  for (const auto& [key, value] : values) {
    if (const auto name = present_name_of(key)) {
      throw std::invalid_argument(key + " was renamed: write " + *name);
    }
    throw std::invalid_argument("unknown key " + key + "; known are" + assignment.known);
  }
  config.validate();
  return config;
}

/// Writes each key on its own line, below its sections.
struct Listing {
  std::string text;
  std::vector<std::string> sections;

  template <typename Number>
  void operator()(const char* key, const Number& value, double, double) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.begin(), digits.end(), value).ptr;
    add(key, std::string(digits.begin(), end));
  }
  void operator()(const char* key, const bool& value) { add(key, value ? "true" : "false"); }

 private:
  void add(const std::string& key, const std::string& value) {
    std::vector<std::string> path;
    std::istringstream parts(key);
    for (std::string part; std::getline(parts, part, '.');) path.push_back(part);
    std::size_t common = 0;
    while (common < sections.size() && common + 1 < path.size() &&
           sections[common] == path[common]) {
      ++common;
    }
    for (std::size_t i = common; i < path.size(); ++i) {
      text +=
          std::string(2 * i, ' ') + path[i] + (i + 1 < path.size() ? ":\n" : ": " + value + "\n");
    }
    sections.assign(path.begin(), path.end() - 1);
  }
};

}  // namespace

std::string config_to_yaml(const ModelerConfig& config) {
  Listing listing;
  visit_keys(config, listing);
  return listing.text;
}

ModelerConfig load_config(const std::string& path) {
  try {
    return read(path);
  } catch (const YAML::BadFile&) {
    throw std::invalid_argument(path + ": cannot be read: does the file exist?");
  } catch (const std::ios_base::failure& error) {  // for example, the path is a folder
    throw std::invalid_argument(path + ": cannot be read: " + error.what());
  } catch (const YAML::Exception& error) {
    throw std::invalid_argument(path + ": " + error.what());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path + ": " + error.what());
  }
}

}  // namespace ribbon_mapper
