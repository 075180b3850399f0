// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ribbon_mapper/PlaneArray.h>
#include <ribbon_mapper/PlaneOutline.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>

#include <vector>

#include "modeler/semantics/plane_label.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Returns outlines as messages.
std::vector<PlaneOutline> outline_messages(const std::vector<Outline>& outlines);

/// Returns planes as a message, on request with the centres of their cells. `labels` are those of
/// the planes, or none.
PlaneArray plane_array_message(const std::vector<Plane>& planes, const std_msgs::Header& header,
                               std::size_t revision, bool with_cells,
                               const std::vector<PlaneLabel>& labels = {});

/// Returns the centres of the seen cells: x, y, z and rgb, the colour of their plane, see
/// shown_colour(). `labels` are those of the planes.
sensor_msgs::PointCloud2 cell_cloud(const std::vector<Plane>& planes,
                                    const std::vector<PlaneLabel>& labels,
                                    const std_msgs::Header& header);

}  // namespace ribbon_mapper
