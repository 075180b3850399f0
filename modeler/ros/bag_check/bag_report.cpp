// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/bag_report.hpp"

#include <algorithm>

#include "modeler/ros/bag_check/number_text.hpp"

namespace ribbon_mapper {

std::size_t BagReport::count(Finding::Weight weight) const {
  return static_cast<std::size_t>(
      std::count_if(findings_.begin(), findings_.end(),
                    [weight](const Finding& finding) { return finding.weight == weight; }));
}

void BagReport::turn_faults_into_warnings() {
  for (Finding& finding : findings_) {
    if (finding.weight == Finding::Weight::fault) finding.weight = Finding::Weight::warning;
  }
}

std::string BagReport::text() const {
  struct Section {
    Finding::Weight weight;
    const char* mark;
  };
  std::string text;
  for (const Section& section :
       {Section{Finding::Weight::fact, "         "}, Section{Finding::Weight::warning, "WARNING  "},
        Section{Finding::Weight::fault, "FAULT    "}}) {
    for (const Finding& finding : findings_) {
      if (finding.weight == section.weight) text += section.mark + finding.text + "\n";
    }
  }
  if (!can_be_mapped()) return text + "VERDICT  this cannot be mapped\n";
  const std::size_t warnings = count(Finding::Weight::warning);
  return text + "VERDICT  this can be mapped" +
         (warnings == 0 ? "" : ", but see " + counted(warnings, "warning")) + "\n";
}

}  // namespace ribbon_mapper
