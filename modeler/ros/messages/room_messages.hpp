// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ribbon_mapper/FloorRooms.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstddef>

#include "modeler/semantics/rooms.hpp"

namespace ribbon_mapper {

/// Returns rooms and passages as a message.
FloorRooms rooms_message(const Rooms& rooms, const std_msgs::Header& header, std::size_t revision);

/// Returns rooms and passages for rviz, in place of all that were drawn before. Namespaces are
/// "rooms" (their floors), "names" (with areas) and "passages" (jambs, sill and lintel).
visualization_msgs::MarkerArray room_markers(const Rooms& rooms, const std_msgs::Header& header);

}  // namespace ribbon_mapper
