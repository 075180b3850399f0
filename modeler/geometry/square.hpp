// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// Returns the square of `x`.
inline double square(double x) { return x * x; }

}  // namespace ribbon_mapper
