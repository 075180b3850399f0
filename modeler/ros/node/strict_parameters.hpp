// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>

namespace ribbon_mapper {

/// The private parameters of this node, read strictly: a wrong type, a value out of range or a
/// parameter that nobody asked for throws std::invalid_argument that names the parameter and what
/// is allowed. A misspelt parameter that is silently ignored costs its user an afternoon.
class StrictParameters {
 public:
  std::string text(const std::string& key, const std::string& fallback);
  std::string required_text(const std::string& key, const std::string& meaning);
  double number(const std::string& key, double fallback, double least, double most);
  int integer(const std::string& key, int fallback, int least, int most);
  bool flag(const std::string& key, bool fallback);

  /// To be called when all have been read.
  void refuse_unknown() const;

 private:
  std::string full_name(const std::string& key);

  std::set<std::string> known_ = {"diagnostic_period"};  // read by diagnostic_updater
};

}  // namespace ribbon_mapper
