// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/semantics/plane_label.hpp"

namespace ribbon_mapper {

Semantics with_annotations(Semantics semantics, const std::vector<const Annotation*>& annotations) {
  for (std::size_t i = 0; i < annotations.size(); ++i) {
    if (annotations[i] == nullptr) continue;
    if (const auto label = label_from(annotations[i]->label)) {
      semantics.labels.at(i) = {*label, 1.0};
    }
  }
  return semantics;
}

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
