// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/config_file.hpp"

#include <yaml-cpp/yaml.h>

#include <charconv>
#include <ios>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

#include "modeler/config_keys.hpp"
#include "modeler/io/model_label.hpp"
#include "modeler/io/renamed_keys.hpp"
#include "modeler/text/number_text.hpp"
#include "modeler/text/yaml_error.hpp"

namespace ribbon_mapper {
namespace {

using Values = std::map<std::string, YAML::Node>;  // by "section.key"

/// The names of all keys and of the sections that hold them.
struct KnownNames {
  std::set<std::string> keys, sections;

  template <typename Value, typename... Range>
  void operator()(const std::string& key, const Value&, Range...) {
    keys.insert(key);
    for (auto dot = key.find('.'); dot != std::string::npos; dot = key.find('.', dot + 1)) {
      sections.insert(key.substr(0, dot));
    }
  }

  /// Returns the keys of the section that a key begins with, or all if there is no such section.
  std::string listed_for(const std::string& key) const {
    const std::string top = key.substr(0, key.find('.'));
    std::string list;
    for (const std::string& name : keys) {
      if (sections.count(top) == 0 || name.substr(0, name.find('.')) == top) list += "\n  " + name;
    }
    return list;
  }
};

[[noreturn]] void refuse(std::string key, YAML::Node value, const KnownNames& known) {
  constexpr int kDeepest = 3;  // an alias may lead to its own section
  for (int depth = 0; depth < kDeepest && value.IsMap() && value.size() > 0; ++depth) {
    const auto first = value.begin();
    key += "." + first->first.Scalar();
    value.reset(first->second);
  }
  if (const auto name = present_name_of(key)) {
    throw std::invalid_argument(key + " was renamed: write " + *name);
  }
  throw std::invalid_argument("unknown key " + in_one_line(key, 80) + "; known are" +
                              known.listed_for(key));
}

/// Collects the values of known keys. Refuses the first other one, so that the work is limited by
/// the number of keys, wherever aliases lead.
void collect(const YAML::Node& section, const std::string& prefix, const KnownNames& known,
             Values& values) {
  for (const auto& entry : section) {
    const std::string key = prefix + entry.first.Scalar();
    if (entry.second.IsMap() && known.sections.count(key) != 0) {
      collect(entry.second, key + ".", known, values);
    } else if (known.keys.count(key) == 0) {
      refuse(key, entry.second, known);
    } else if (!values.emplace(key, entry.second).second) {
      throw std::invalid_argument(key + " is given twice");
    }
  }
}

/// Parses a number, whatever the locale. Returns false if the text is none.
template <typename Number>
bool parse(const std::string& text, Number& number) {
  const bool has_mark = text.rfind('+', 0) == 0 || text == ".nan" || text == ".inf";
  const std::string digits = text.substr(has_mark ? 1 : 0);
  if constexpr (std::is_floating_point_v<Number>) {
    const std::optional<double> found = number_from(digits);
    number = found.value_or(number);
    return found.has_value();
  } else {
    const char* const end = digits.data() + digits.size();
    const auto [at, error] = std::from_chars(digits.data(), end, number);
    return error == std::errc() && at == end;
  }
}

/// Assigns the values of keys.
struct Assignment {
  const Values& values;

  template <typename Number>
  void operator()(const char* key, Number& number, double, double) const {
    const auto found = values.find(key);
    if (found == values.end()) return;
    if (found->second.IsScalar() && parse(found->second.Scalar(), number)) return;
    throw std::invalid_argument(std::string(key) + " must be a number");
  }
  void operator()(const char* key, bool& value) const {
    const auto found = values.find(key);
    if (found == values.end()) return;
    if (!YAML::convert<bool>::decode(found->second, value)) {
      throw std::invalid_argument(std::string(key) + " must be true or false");
    }
  }
};

ModelerConfig read(const std::string& path) {
  const YAML::Node root = YAML::LoadFile(path);
  if (!root.IsMap() && !root.IsNull()) {
    throw std::invalid_argument("sections with keys are expected, as in config/pr2.yaml");
  }
  ModelerConfig config;
  KnownNames known;
  visit_keys(config, known);
  Values values;
  collect(root, "", known, values);
  const Assignment assignment{values};
  visit_keys(config, assignment);
  config.validate();
  return config;
}

/// Writes each key on its own line, below its sections.
struct Listing {
  std::string text;
  std::vector<std::string> sections;

  template <typename Number>
  void operator()(const char* key, const Number& value, double, double) {
    add(key, shortest_text(value));
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
  } catch (const YAML::BadFile& error) {
    throw std::invalid_argument(path + ": " + defect_of(error));
  } catch (const std::ios_base::failure& error) {  // for example, the path is a folder
    throw std::invalid_argument(path + ": cannot be read: " + error.what());
  } catch (const YAML::Exception& error) {
    throw std::invalid_argument(path + ": " + in_one_line(defect_of(error)) +
                                "; compare with config/pr2.yaml");
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path + ": " + error.what());
  }
}

}  // namespace ribbon_mapper
