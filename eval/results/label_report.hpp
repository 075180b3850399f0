// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "eval/semantics/label_confusion.hpp"
#include "modeler/text/ordered_json.hpp"

namespace ribbon_mapper::eval {

/// Formats a matrix as a table for a terminal, with a line about the share that is right. Rows and
/// columns without area are left out.
std::string label_table(const LabelConfusion& confusion);

/// Converts a matrix to JSON: {"right", "compared_m2", "no_truth_m2", "confusion_m2": {true label:
/// {label of the model: area}}}. Labels and areas of zero are left out.
Json label_json(const LabelConfusion& confusion);

/// Returns the matrix of label_json() from figures whose nested keys are joined by dots, as in
/// LoggedRun::figures, below `prefix`.
LabelConfusion label_confusion_of(const std::map<std::string, double>& figures,
                                  const std::string& prefix);

}  // namespace ribbon_mapper::eval
