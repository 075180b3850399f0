// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/semantics/plane_label.hpp"

namespace ribbon_mapper {

std::vector<PlaneLabel> plane_labels(const std::vector<Plane>& planes, const Semantics& semantics,
                                     const std::vector<const Annotation*>& annotations) {
  std::vector<PlaneLabel> labels;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Decision& decision = semantics.labels.at(i);
    const Annotation* annotation = i < annotations.size() ? annotations[i] : nullptr;
    if (annotation != nullptr) {
      labels.push_back({annotation->label, 1.0, annotation->note, decision.label});
    } else {
      labels.push_back({to_string(decision.label), decision.confidence, "", decision.label});
    }
  }
  return labels;
}

}  // namespace ribbon_mapper
