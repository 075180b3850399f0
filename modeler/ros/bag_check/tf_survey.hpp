// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/ros/bag/bag_lines.hpp"
#include "modeler/ros/bag_check/bag_report.hpp"
#include "modeler/ros/bag_check/scan_survey.hpp"

namespace ribbon_mapper {

/// Adds what is to be said about the transforms of a recording: the frames, which of them were
/// chosen, parents, repetitions, delays, gaps. Gaps of several periods of the scans are warned
/// about: motion within them is unknown.
void report_transforms(const BagLines& lines, const ScanSurvey& scans, BagReport& report);

/// Returns a sentence for each fault of the transforms that does not stop the modeler: unusable and
/// repeated ones, frames that are both static and moving.
std::vector<std::string> transform_warnings(const TransformLog& transforms);

}  // namespace ribbon_mapper
