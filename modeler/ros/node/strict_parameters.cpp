// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/node/strict_parameters.hpp"

#include <ros/param.h>
#include <ros/this_node.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper {
namespace {

using XmlRpc::XmlRpcValue;

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
  throw std::invalid_argument("parameter " + name + " " + why);
}

std::vector<std::string> words_of(std::string text) {
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

template <typename Number>
Number within(const std::string& name, Number value, Number min, Number max) {
  if (value >= min && value <= max) return value;
  std::ostringstream why;
  why << "is " << value << ", allowed are " << min << " to " << max;
  refuse(name, why.str());
}

}  // namespace

std::string StrictParameters::full_name(const std::string& key) {
  known_.insert(key);
  return ros::this_node::getName() + "/" + key;
}

std::string StrictParameters::text(const std::string& key, const std::string& fallback) {
  const std::string name = full_name(key);
  XmlRpcValue value;
  if (!ros::param::get(name, value)) return fallback;
  if (value.getType() != XmlRpcValue::TypeString) refuse(name, "must be a text");
  return static_cast<std::string>(value);
}

std::vector<std::string> StrictParameters::words(const std::string& key) {
  const std::string name = full_name(key);
  XmlRpcValue value;
  if (!ros::param::get(name, value)) return {};
  if (value.getType() == XmlRpcValue::TypeString) return words_of(static_cast<std::string>(value));
  std::vector<std::string> words;
  if (value.getType() != XmlRpcValue::TypeArray) refuse(name, "must be a text or a list of texts");
  for (int i = 0; i < value.size(); ++i) {
    if (value[i].getType() != XmlRpcValue::TypeString) refuse(name, "must be a list of texts");
    words.push_back(static_cast<std::string>(value[i]));
  }
  return words;
}

std::string StrictParameters::required_text(const std::string& key, const std::string& meaning) {
  std::string value = text(key, "");
  if (value.empty()) refuse(full_name(key), "is missing: set it to " + meaning);
  return value;
}

std::string StrictParameters::filled_text(const std::string& key, const std::string& fallback,
                                          const std::string& meaning) {
  std::string value = text(key, fallback);
  if (value.empty()) refuse(full_name(key), "is empty: set it to " + meaning);
  return value;
}

std::string StrictParameters::frame(const std::string& key, const std::string& fallback) {
  std::string name = without_slash(text(key, fallback));
  if (name.empty()) refuse(full_name(key), "is empty: set it to a frame of tf, or leave it out");
  if (name.size() > kMaxFrameName) refuse(full_name(key), "is too long for the name of a frame");
  return name;
}

double StrictParameters::number(const std::string& key, double fallback, double min, double max) {
  const std::string name = full_name(key);
  XmlRpcValue value;
  if (!ros::param::get(name, value)) return fallback;
  if (value.getType() == XmlRpcValue::TypeInt)
    return within(name, static_cast<double>(static_cast<int>(value)), min, max);
  if (value.getType() != XmlRpcValue::TypeDouble) refuse(name, "must be a number");
  return within(name, static_cast<double>(value), min, max);
}

int StrictParameters::integer(const std::string& key, int fallback, int min, int max) {
  const std::string name = full_name(key);
  XmlRpcValue value;
  if (!ros::param::get(name, value)) return fallback;
  if (value.getType() != XmlRpcValue::TypeInt) refuse(name, "must be a whole number");
  return within(name, static_cast<int>(value), min, max);
}

bool StrictParameters::flag(const std::string& key, bool fallback) {
  const std::string name = full_name(key);
  XmlRpcValue value;
  if (!ros::param::get(name, value)) return fallback;
  if (value.getType() != XmlRpcValue::TypeBoolean) refuse(name, "must be true or false");
  return static_cast<bool>(value);
}

void StrictParameters::refuse_unknown() const {
  const std::string prefix = ros::this_node::getName() + "/";
  std::vector<std::string> names;
  ros::param::getParamNames(names);
  for (const std::string& name : names) {
    if (name.rfind(prefix, 0) != 0) continue;
    const std::string key =
        name.substr(prefix.size(), name.find('/', prefix.size()) - prefix.size());
    if (known_.count(key) != 0) continue;
    std::string list;
    for (const std::string& known : known_) list += " ~" + known;
    refuse(prefix + shown(key), "is unknown; there are" + list);
  }
}

}  // namespace ribbon_mapper
