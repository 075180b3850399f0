// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper::eval {

/// A value for each of the four models that are compared: {noisy, corrected trajectory} x {as
/// built, final}.
template <typename Value>
struct PerModel {
  Value noisy_as_built;      ///< noisy trajectory, planes as built during the tour
  Value noisy;               ///< noisy trajectory, final planes: the control
  Value corrected_as_built;  ///< corrected trajectory, planes as built
  Value corrected;           ///< corrected trajectory, final planes: the result
};

/// Applies `function` to the value of each model.
template <typename Value, typename Function>
auto for_each_model(const PerModel<Value>& models, const Function& function)
    -> PerModel<decltype(function(models.noisy_as_built))> {
  return {function(models.noisy_as_built), function(models.noisy),
          function(models.corrected_as_built), function(models.corrected)};
}

}  // namespace ribbon_mapper::eval
