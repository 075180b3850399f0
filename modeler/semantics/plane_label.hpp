// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/semantics/annotations.hpp"
#include "modeler/semantics/semantics.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// What a plane is, as files and messages say it.
struct PlaneLabel {
  std::string text;               ///< a person's own label, or that of the rules
  double confidence = 0.0;        ///< as Decision::confidence; 1 for a person's label
  std::string note = {};          ///< a person's note; may be empty
  Label rule = Label::furniture;  ///< what the rules say, whatever a person says
};

/// Returns semantics in which a person's own label goes before that of the rules, if it is one of
/// theirs, such as "wall". `annotations` are those of the planes, or none.
Semantics with_annotations(Semantics semantics, const std::vector<const Annotation*>& annotations);

/// Returns the labels of planes, in their order. A person's own label goes before that of the
/// rules. `semantics` are those of the same planes.
std::vector<PlaneLabel> plane_labels(const std::vector<Plane>& planes, const Semantics& semantics,
                                     const std::vector<const Annotation*>& annotations);

}  // namespace ribbon_mapper
