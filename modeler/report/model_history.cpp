// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/report/model_history.hpp"

namespace ribbon_mapper {

std::vector<PlaneRemarks> remarks_of(const std::vector<PlaneLabel>& labels) {
  std::vector<PlaneRemarks> remarks;
  for (const PlaneLabel& label : labels) remarks.push_back({label.text, {}});
  return remarks;
}

void add_rooms(const Rooms& rooms, Report& report) {
  for (std::size_t i = 0; i < rooms.rooms.size(); ++i) {
    const Room& room = rooms.rooms[i];
    report.add_room({"room " + room_name(i), room.area_m2, floor_outlines(room), room.centre});
  }
}

Report report_of(const ReportHead& head, const ModelHistory& history) {
  Report report(head);
  std::size_t trajectory = 0;
  if (history.planes_before != nullptr) {
    report.add_trajectory(history.name_before, history.trajectory_before);
    report.add_model({history.name_before, history.planes_before, {}, trajectory++});
  }
  report.add_trajectory(history.name, history.trajectory);
  report.add_model({history.name, history.planes, remarks_of(history.labels), trajectory});
  add_rooms(history.rooms, report);
  return report;
}

}  // namespace ribbon_mapper
