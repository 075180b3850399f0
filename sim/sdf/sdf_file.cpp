// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sdf/sdf_file.hpp"

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "modeler/text/number_text.hpp"
namespace ribbon_mapper::sim {
namespace {

using tinyxml2::XMLDocument;
using tinyxml2::XMLElement;

constexpr int kOldestVersion = 102;  // before, poses and sizes were attributes
constexpr std::size_t kLongestQuotation = 60;
constexpr const char* kSpace = " \t\r\n";

/// Returns "1.6" as 106, 0 if the text is no version.
int version_from(const char* text) {
  int major = 0, minor = 0;
  if (text == nullptr || std::sscanf(text, "%2d.%2d", &major, &minor) != 2) return 0;
  return 100 * major + minor;
}

/// Returns the number that a whole word is, or nothing. Does not depend on the locale.
bool is_number(const std::string& word, double& number) {
  const auto found = number_from(word[0] == '+' ? word.substr(1) : word);
  number = found.value_or(0.0);
  return found.has_value();
}

void collect_references(const XMLElement& element, std::set<std::string>& references) {
  for (const char* name : {"relative_to", "attached_to"})
    if (const char* frame = element.Attribute(name)) references.insert(frame);
  for_each_child(element, [&](const XMLElement& child) { collect_references(child, references); });
}

std::string expected(std::size_t count, NumberRange range) {
  std::ostringstream text;
  text << count << (count == 1 ? " number" : " numbers") << " from " << range.least << " to "
       << range.most;
  return text.str();
}

}  // namespace

SdfFile::SdfFile(const std::string& path)
    : SdfFile(path, [&](XMLDocument& xml) { xml.LoadFile(path.c_str()); }) {}

std::unique_ptr<SdfFile> SdfFile::from_text(const char* text, const std::string& path) {
  return std::unique_ptr<SdfFile>(new SdfFile(path, [&](XMLDocument& xml) { xml.Parse(text); }));
}

SdfFile::SdfFile(const std::string& path, const std::function<void(XMLDocument&)>& load)
    : path_(path), folder_(std::filesystem::absolute(path).parent_path().string()) {
  load(xml_);
  if (xml_.Error())
    throw std::runtime_error("line " + std::to_string(xml_.ErrorLineNum()) +
                             ": no well-formed XML (" + XMLDocument::ErrorIDToName(xml_.ErrorID()) +
                             ")");
  const XMLElement* root = xml_.RootElement();
  if (root == nullptr ||
      (std::strcmp(root->Name(), "sdf") != 0 && std::strcmp(root->Name(), "gazebo") != 0))
    throw std::runtime_error("no SDF: the first element must be <sdf version='...'>" +
                             std::string(root == nullptr ? "" : ", is ") +
                             (root == nullptr ? "" : quoted(root->Name())));
  version_ = version_from(root->Attribute("version"));
  if (version_ < kOldestVersion)
    throw std::runtime_error("SDF of version 1.2 or later is read; convert it with `ign sdf -p`");
  collect_references(*root, references_);
}

SdfScope SdfScope::of(const XMLElement& child) const {
  return {world, file, (name.empty() ? "" : name + "::") + name_of(child)};
}

void SdfScope::fail(const XMLElement& at, const std::string& message) const {
  std::string place = "world " + world;
  if (file.path() != world) place += ", model " + file.path();
  place += ", line " + std::to_string(at.GetLineNum()) + ": ";
  if (!name.empty()) place += quoted(name) + " ";
  throw std::runtime_error(place + message);
}

std::vector<double> SdfScope::numbers(const XMLElement& at, std::size_t count,
                                      NumberRange range) const {
  std::vector<double> numbers;
  std::istringstream words(text_of(at));
  for (std::string word; words >> word;) {
    double number = 0.0;
    const bool is_good = numbers.size() < count && is_number(word, number) &&
                         range.least <= number && number <= range.most;
    if (!is_good) numbers.resize(count + 1);
    if (numbers.size() > count) break;
    numbers.push_back(number);
  }
  if (numbers.size() != count)
    fail(at, std::string("has <") + at.Name() + "> " + quoted(text_of(at)) + ": must be " +
                 expected(count, range));
  return numbers;
}

std::string text_of(const XMLElement& element) {
  const std::string text = element.GetText() ? element.GetText() : "";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::string without_colons(std::string name) {
  for (std::size_t at; (at = name.find("::")) != std::string::npos;) name.replace(at, 2, ".");
  return name;
}

std::string valid_name(const std::string& name, const std::string& fallback) {
  const std::string valid = without_colons(name);
  if (valid.empty()) return fallback;
  const bool is_reserved = valid == "world" || (valid.size() >= 4 && valid.substr(0, 2) == "__" &&
                                                valid.substr(valid.size() - 2) == "__");
  return is_reserved ? valid + "." : valid;
}

std::string name_of(const XMLElement& element) {
  const char* name = element.Attribute("name");
  return valid_name(name ? name : "", element.Name());
}

std::string quoted(const std::string& text) {
  std::string shown = text.substr(0, kLongestQuotation);
  for (char& c : shown)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return "'" + shown + (text.size() > shown.size() ? "..." : "") + "'";
}

}  // namespace ribbon_mapper::sim
