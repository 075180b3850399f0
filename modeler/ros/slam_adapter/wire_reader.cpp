// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/slam_adapter/wire_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace ribbon_mapper {
namespace {

constexpr const char* kText = "string";
constexpr int kDeepest = 32;                              // types within types; those of ROS have 5
constexpr std::size_t kMostBytes = std::size_t{1} << 40;  // beyond any message

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument("the definition " + why.substr(0, 300));
}

/// Returns a * b, or kMostBytes if that is less.
std::size_t limited_product(std::size_t a, std::size_t b) {
  return b != 0 && a > kMostBytes / b ? kMostBytes : a * b;
}

std::size_t array_length(const std::string& digits) {
  std::uint32_t length = 0;
  const char* const end = digits.data() + digits.size();
  const auto [at, error] = std::from_chars(digits.data(), end, length);
  if (error != std::errc() || at != end) refuse("has the array length '" + digits + "'");
  return length;
}

/// Returns the smallest size of each type that is not made of others [bytes].
const std::map<std::string, std::size_t>& primitive_sizes() {
  static const std::map<std::string, std::size_t> kSizes{
      {"bool", 1},    {"byte", 1},  {"char", 1},     {"int8", 1},  {"uint8", 1},  {"int16", 2},
      {"uint16", 2},  {"int32", 4}, {"uint32", 4},   {"int64", 8}, {"uint64", 8}, {"float32", 4},
      {"float64", 8}, {"time", 8},  {"duration", 8}, {kText, 4}};  // its length
  return kSizes;
}

template <typename Number>
double as(const std::uint8_t* data) {
  Number number;
  std::memcpy(&number, data, sizeof number);  // messages are little-endian, as this machine
  return static_cast<double>(number);
}

double number_of(const std::string& type, const std::uint8_t* data) {
  if (type == "float64") return as<double>(data);
  if (type == "float32") return as<float>(data);
  if (type == "int64") return as<std::int64_t>(data);
  if (type == "uint64") return as<std::uint64_t>(data);
  if (type == "int32") return as<std::int32_t>(data);
  if (type == "uint32") return as<std::uint32_t>(data);
  if (type == "int16") return as<std::int16_t>(data);
  if (type == "uint16") return as<std::uint16_t>(data);
  if (type == "int8" || type == "byte") return as<std::int8_t>(data);
  if (type == "time") return as<std::uint32_t>(data) + 1e-9 * as<std::uint32_t>(data + 4);
  if (type == "duration") return as<std::int32_t>(data) + 1e-9 * as<std::int32_t>(data + 4);
  return as<std::uint8_t>(data);
}

}  // namespace

class WireReader::Cursor {
 public:
  Cursor(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  const std::uint8_t* take(std::size_t bytes) {
    require(bytes);
    const std::uint8_t* here = data_;
    data_ += bytes, left_ -= bytes;
    return here;
  }
  std::size_t take_length() { return static_cast<std::size_t>(as<std::uint32_t>(take(4))); }

  void require(std::size_t bytes) const {
    if (bytes > left_) throw std::invalid_argument("the message is shorter than its definition");
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

WireReader::WireReader(const std::string& definition) {
  std::istringstream lines(definition);
  std::string type;
  types_[type];
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("MSG: ", 0) == 0) {
      type = line.substr(5);
      if (!types_.try_emplace(type).second) refuse("defines the type " + type + " twice");
    } else if (line.rfind("====", 0) != 0) {
      parse_line(std::move(line), type);
    }
  }
  if (types_.at("").empty()) refuse("is empty");
  resolve("", 0);
}

void WireReader::parse_line(std::string line, const std::string& type) {
  line = line.substr(0, line.find('#'));
  if (line.find('=') != std::string::npos) return;  // a constant
  std::istringstream words(line);
  Field field;
  if (!(words >> field.type)) return;
  if (!(words >> field.name)) refuse("has no field name in '" + line + "'");
  const std::size_t bracket = field.type.find('[');
  if (bracket != std::string::npos) {
    field.is_array = true;
    if (field.type.back() != ']') refuse("has no ']' in '" + line + "'");
    const std::string length = field.type.substr(bracket + 1, field.type.size() - bracket - 2);
    if (!length.empty()) field.length = array_length(length);
    field.type.resize(bracket);
  }
  types_[type].push_back(field);
}

/// Returns the full name of a type that a field of the type `user` names. As in ROS, a name without
/// a package means the package of the user; publishers differ in that, so any package will do.
std::string WireReader::full_name(const std::string& type, const std::string& user) const {
  std::string header = "std_msgs/Header";
  const std::string beside = user.substr(0, user.find('/') + 1) + type;
  if (type == "Header" && types_.count(header) != 0) return header;
  for (const std::string& name : {type, beside}) {
    if (!name.empty() && types_.count(name) != 0) return name;
  }
  for (const auto& [name, fields] : types_) {
    const std::size_t slash = name.find('/');
    if (slash != std::string::npos && name.substr(slash + 1) == type) return name;
  }
  refuse("lacks the type " + type);
}

/// Gives the fields of a type, and of all types that it uses, their full type names and sizes, and
/// removes those without any content. Returns the smallest size of the type. Each field that is
/// left takes a byte of the message at least, so that reading ends after as many steps.
std::size_t WireReader::resolve(const std::string& type, int depth) {
  const auto resolved = min_bytes_.find(type);
  if (resolved != min_bytes_.end()) return resolved->second;
  if (depth > kDeepest) refuse("has types within types without end; the type " + type + " is one");
  std::vector<Field> fields;
  std::size_t bytes = 0;
  for (Field field : types_.at(type)) {
    const auto primitive = primitive_sizes().find(field.type);
    if (primitive != primitive_sizes().end()) {
      field.min_bytes = primitive->second;
    } else {
      field.type = full_name(field.type, type);
      field.min_bytes = resolve(field.type, depth + 1);
    }
    const bool has_length = field.is_array && !field.length;
    const std::size_t least =
        has_length ? 4 : limited_product(field.length.value_or(1), field.min_bytes);
    if (least == 0) continue;
    bytes = std::min(kMostBytes, bytes + least);
    fields.push_back(std::move(field));
  }
  types_[type] = std::move(fields);
  return min_bytes_[type] = bytes;
}

void WireReader::read(const std::uint8_t* data, std::size_t size, const Visitor& visit) const {
  Cursor cursor(data, size);
  cursor.require(min_bytes_.at(""));
  read_type("", "", cursor, visit);
}

void WireReader::read_type(const std::string& type, const std::string& path, Cursor& cursor,
                           const Visitor& visit) const {
  for (const Field& field : types_.at(type)) {
    read_field(field, path.empty() ? field.name : path + "." + field.name, cursor, visit);
  }
}

void WireReader::read_field(const Field& field, const std::string& path, Cursor& cursor,
                            const Visitor& visit) const {
  std::size_t count = 1;
  if (field.is_array) count = field.length ? *field.length : cursor.take_length();
  if (field.min_bytes == 0) return;  // whatever the count
  cursor.require(limited_product(count, field.min_bytes));
  if (field.is_array && field.min_bytes == 1 && primitive_sizes().count(field.type) != 0) {
    cursor.take(count);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (field.type == kText) {
      cursor.take(cursor.take_length());
    } else if (primitive_sizes().count(field.type) != 0) {
      visit(path, number_of(field.type, cursor.take(field.min_bytes)));
    } else {
      read_type(field.type, path, cursor, visit);
    }
  }
}

}  // namespace ribbon_mapper
