// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace ribbon_mapper {

/// What was found in a bag, in plain words.
struct Finding {
  enum class Weight {
    fact,     ///< good to know
    warning,  ///< the model suffers
    fault,    ///< cannot be mapped
  };
  Weight weight = Weight::fact;
  std::string text;
};

class BagReport {
 public:
  void fact(std::string text) { add(Finding::Weight::fact, std::move(text)); }
  void warning(std::string text) { add(Finding::Weight::warning, std::move(text)); }
  void fault(std::string text) { add(Finding::Weight::fault, std::move(text)); }

  const std::vector<Finding>& findings() const { return findings_; }
  std::size_t count(Finding::Weight weight) const;
  bool can_be_mapped() const { return count(Finding::Weight::fault) == 0; }

  /// One finding a line, faults first, and the verdict.
  std::string text() const;

 private:
  void add(Finding::Weight weight, std::string text) {
    findings_.push_back({weight, std::move(text)});
  }
  std::vector<Finding> findings_;
};

}  // namespace ribbon_mapper
