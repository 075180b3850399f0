// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

namespace ribbon_mapper {

/// Reads the private parameters of this node strictly. Each method throws std::invalid_argument
/// that names the parameter and what is allowed, if the parameter has a wrong type or is out of
/// range. A misspelt parameter that is silently ignored costs its user an afternoon.
class StrictParameters {
 public:
  /// Returns a text parameter, or `fallback` if it is not set.
  std::string text(const std::string& key, const std::string& fallback);
  /// Returns a text parameter, or `fallback` if it is not set. Throws if it is empty; the error
  /// says what it means.
  std::string filled_text(const std::string& key, const std::string& fallback,
                          const std::string& meaning);
  /// Returns a text parameter. Throws if it is not set; the error says what it means.
  std::string required_text(const std::string& key, const std::string& meaning);
  /// Returns the words of a text, separated by commas or spaces, or of a list of texts; none if it
  /// is not set.
  std::vector<std::string> words(const std::string& key);
  /// Returns the name of a frame without its leading slash, or `fallback` if it is not set. Throws
  /// if it is empty or too long.
  std::string frame(const std::string& key, const std::string& fallback);
  /// Returns a number from `min` to `max`, or `fallback` if it is not set. Integers are accepted.
  double number(const std::string& key, double fallback, double min, double max);
  /// Returns a whole number from `min` to `max`, or `fallback` if it is not set.
  int integer(const std::string& key, int fallback, int min, int max);
  /// Returns a boolean parameter, or `fallback` if it is not set.
  bool flag(const std::string& key, bool fallback);

  /// Throws if a private parameter is set that none of the calls before has read.
  void refuse_unknown() const;

 private:
  std::string full_name(const std::string& key);

  std::set<std::string> known_ = {"diagnostic_period"};  // read by diagnostic_updater
};

}  // namespace ribbon_mapper
