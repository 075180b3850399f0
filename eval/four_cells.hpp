// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper::eval {

/// Something for each of the four cells of every table: {noisy, corrected trajectory} x {as built,
/// merged and filtered}.
template <typename Value>
struct PerCell {
  Value noisy_raw;         ///< as built on the way, at the end of the tour
  Value noisy_merged;      ///< what mere merging would have done: the control
  Value corrected_raw;     ///< what the correction did
  Value corrected_merged;  ///< the result
};

/// The same of each cell.
template <typename Value, typename Function>
auto for_each_cell(const PerCell<Value>& cells, const Function& function)
    -> PerCell<decltype(function(cells.noisy_raw))> {
  return {function(cells.noisy_raw), function(cells.noisy_merged), function(cells.corrected_raw),
          function(cells.corrected_merged)};
}

}  // namespace ribbon_mapper::eval
