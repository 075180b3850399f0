// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/label_report.hpp"

#include "eval/results/format.hpp"
#include "modeler/text/ordered_json.hpp"

namespace ribbon_mapper::eval {

std::string label_table(const LabelConfusion& confusion) {
  const auto is_used = [&](Label label) {
    double sum = 0.0;
    for (const Label other : kLabels)
      sum += confusion.at(label, other) + confusion.at(other, label);
    return sum > 0.0;
  };
  std::string text = format("%-32s", "labels: true, of the model [m2]");
  for (const Label label : kLabels) {
    if (is_used(label)) text += format(" %18s", to_string(label).c_str());
  }
  for (const Label truth : kLabels) {
    if (!is_used(truth)) continue;
    text += format("\n%-32s", to_string(truth).c_str());
    for (const Label label : kLabels) {
      if (is_used(label)) text += format(" %18.2f", confusion.at(truth, label));
    }
  }
  return text +
         format("\nlabels: %.2f %% of %.1f m2 right; %.1f m2 of the model are where nothing is\n",
                100.0 * confusion.right_share(), confusion.compared_m2(), confusion.no_truth_m2);
}

Json label_json(const LabelConfusion& confusion) {
  Json matrix = Json::object();
  for (const Label truth : kLabels) {
    for (const Label label : kLabels) {
      const double area_m2 = confusion.at(truth, label);
      if (area_m2 > 0.0) matrix[to_string(truth)][to_string(label)] = area_m2;
    }
  }
  return {{"right", confusion.right_share()},
          {"compared_m2", confusion.compared_m2()},
          {"no_truth_m2", confusion.no_truth_m2},
          {"confusion_m2", matrix}};
}

LabelConfusion label_confusion_of(const std::map<std::string, double>& figures,
                                  const std::string& prefix) {
  const auto figure = [&](const std::string& key) {
    const auto found = figures.find(prefix + key);
    return found == figures.end() ? 0.0 : found->second;
  };
  LabelConfusion confusion;
  confusion.no_truth_m2 = figure("no_truth_m2");
  for (std::size_t i = 0; i < kLabels.size(); ++i) {
    for (std::size_t k = 0; k < kLabels.size(); ++k) {
      confusion.area_m2[i][k] =
          figure("confusion_m2." + to_string(kLabels[i]) + "." + to_string(kLabels[k]));
    }
  }
  return confusion;
}

}  // namespace ribbon_mapper::eval
