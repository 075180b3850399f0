// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/slam_adapter/wire_reader.hpp"

#include <cstring>
#include <sstream>
#include <stdexcept>

namespace ribbon_mapper {
namespace {

const std::map<std::string, std::size_t>& primitive_sizes() {
  static const std::map<std::string, std::size_t> kSizes{
      {"bool", 1},   {"byte", 1},    {"char", 1},    {"int8", 1},   {"uint8", 1},
      {"int16", 2},  {"uint16", 2},  {"int32", 4},   {"uint32", 4}, {"int64", 8},
      {"uint64", 8}, {"float32", 4}, {"float64", 8}, {"time", 8},   {"duration", 8}};
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
    if (bytes > left_) throw std::invalid_argument("the message is shorter than its definition");
    const std::uint8_t* here = data_;
    data_ += bytes, left_ -= bytes;
    return here;
  }
  std::size_t take_length() { return static_cast<std::size_t>(as<std::uint32_t>(take(4))); }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

WireReader::WireReader(const std::string& definition) {
  std::istringstream lines(definition);
  std::string type;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("MSG: ", 0) == 0) {
      type = line.substr(5);
      types_[type];
    } else if (line.rfind("====", 0) != 0) {
      parse_line(std::move(line), type);
    }
  }
}

void WireReader::parse_line(std::string line, const std::string& type) {
  if (line.find('=') != std::string::npos) return;  // a constant
  line = line.substr(0, line.find('#'));
  std::istringstream words(line);
  Field field;
  if (!(words >> field.type)) return;
  if (!(words >> field.name)) throw std::invalid_argument("no field name in '" + line + "'");
  const std::size_t bracket = field.type.find('[');
  if (bracket != std::string::npos) {
    field.is_array = true;
    const std::string length = field.type.substr(bracket + 1, field.type.size() - bracket - 2);
    if (!length.empty()) field.length = std::stoi(length);
    field.type.resize(bracket);
  }
  types_[type].push_back(field);
}

std::string WireReader::full_name(const std::string& type) const {
  if (type == "Header") return "std_msgs/Header";
  if (types_.count(type) != 0) return type;
  for (const auto& [name, fields] : types_) {
    const std::size_t slash = name.find('/');
    if (slash != std::string::npos && name.substr(slash + 1) == type) return name;
  }
  throw std::invalid_argument("the definition lacks the type " + type);
}

void WireReader::read(const std::uint8_t* data, std::size_t size, const Visitor& visit) const {
  Cursor cursor(data, size);
  read_type("", "", cursor, visit);
}

void WireReader::read_type(const std::string& type, const std::string& path, Cursor& cursor,
                           const Visitor& visit) const {
  const auto fields = types_.find(type);
  if (fields == types_.end()) throw std::invalid_argument("the definition is empty");
  for (const Field& field : fields->second) {
    read_field(field, path.empty() ? field.name : path + "." + field.name, cursor, visit);
  }
}

void WireReader::read_field(const Field& field, const std::string& path, Cursor& cursor,
                            const Visitor& visit) const {
  std::size_t count = 1;
  if (field.is_array) {
    count = field.length >= 0 ? static_cast<std::size_t>(field.length) : cursor.take_length();
  }
  const auto size = primitive_sizes().find(field.type);
  if (size != primitive_sizes().end()) {
    if (field.is_array && size->second == 1) {
      cursor.take(count);
      return;
    }
    for (std::size_t i = 0; i < count; ++i) {
      visit(path, number_of(field.type, cursor.take(size->second)));
    }
    return;
  }
  if (field.type == "string") {
    for (std::size_t i = 0; i < count; ++i) cursor.take(cursor.take_length());
    return;
  }
  const std::string type = full_name(field.type);
  if (types_.at(type).empty()) return;  // else a wrong count would cost much time
  for (std::size_t i = 0; i < count; ++i) read_type(type, path, cursor, visit);
}

}  // namespace ribbon_mapper
