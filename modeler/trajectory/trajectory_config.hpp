// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// How a corrected trajectory bears on what comes after it.
struct CorrectionConfig {
  /// True: the SLAM that hands over a corrected trajectory has corrected its tf as well, so lines
  /// that follow are placed where tf says. False: tf goes on as if nothing had happened (the
  /// simulated SLAM, which does not close loops), so the last change is applied to them too.
  bool poses_follow = true;
};

}  // namespace ribbon_mapper
