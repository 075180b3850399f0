// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper::eval {

/// Something for each of the four cells of every table: {noisy, corrected trajectory} x {as built,
/// merged and filtered}.
template <typename Value>
struct PerModel {
  Value noisy_as_built;      ///< as built on the way, at the end of the tour
  Value noisy;               ///< what mere merging would have done: the control
  Value corrected_as_built;  ///< what the correction did
  Value corrected;           ///< the result
};

/// The same of each cell.
template <typename Value, typename Function>
auto for_each_model(const PerModel<Value>& cells, const Function& function)
    -> PerModel<decltype(function(cells.noisy_as_built))> {
  return {function(cells.noisy_as_built), function(cells.noisy), function(cells.corrected_as_built),
          function(cells.corrected)};
}

}  // namespace ribbon_mapper::eval
