// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace ribbon_mapper {

/// A finding in a bag, in plain words.
struct Finding {
  /// How much a finding matters.
  enum class Weight {
    fact,     ///< good to know
    warning,  ///< the model suffers
    fault,    ///< cannot be mapped
  };
  Weight weight = Weight::fact;  ///< how much it matters
  std::string text;              ///< one sentence without a full stop
};

/// The findings in one or several bags.
class BagReport {
 public:
  /// Adds a finding that is good to know.
  void fact(std::string text) { add(Finding::Weight::fact, std::move(text)); }
  /// Adds a finding that the model suffers from.
  void warning(std::string text) { add(Finding::Weight::warning, std::move(text)); }
  /// Adds a finding that makes mapping impossible.
  void fault(std::string text) { add(Finding::Weight::fault, std::move(text)); }

  /// Turns the faults into warnings, because a model was made all the same.
  void turn_faults_into_warnings();

  /// Returns all findings in the order in which they were added.
  const std::vector<Finding>& findings() const { return findings_; }
  /// Returns the number of findings of a weight.
  std::size_t count(Finding::Weight weight) const;
  /// Returns whether there is no fault.
  bool can_be_mapped() const { return count(Finding::Weight::fault) == 0; }

  /// Returns one line for each finding, faults last, and the verdict.
  std::string text() const;

 private:
  void add(Finding::Weight weight, std::string text) {
    findings_.push_back({weight, std::move(text)});
  }
  std::vector<Finding> findings_;
};

}  // namespace ribbon_mapper
