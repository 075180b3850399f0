// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/node/model_services.hpp"

#include <exception>
#include <regex>
#include <stdexcept>
#include <utility>

#include "modeler/exports/exports.hpp"
#include "modeler/io/save.hpp"
#include "modeler/model_file/autosave.hpp"
#include "modeler/program/version.hpp"
#include "modeler/report/model_history.hpp"
#include "modeler/ros/messages/plane_messages.hpp"
#include "modeler/storage/atomic_file.hpp"

namespace ribbon_mapper {
namespace {

/// Throws std::invalid_argument if a save of this name would write files of another one.
void check_files_of_its_own(const std::string& name) {
  if (is_reserved_name(name)) throw std::invalid_argument(name + " is a name of its own use");
  static const std::regex kFurtherFiles(".*_(cells|rooms|floor_plan|map)");
  if (!std::regex_match(name, kFurtherFiles)) return;
  throw std::invalid_argument(name +
                              " may be files of another save, as all names that end in "
                              "_cells, _rooms, _floor_plan or _map: choose another ending");
}

std::vector<Plane> planes_asked_for(const GetModel::Request& request, ModelKeeper& keeper) {
  if (request.which == GetModel::Request::BEFORE_CORRECTION)
    return request.as_built ? keeper.before().planes_as_built : keeper.before().planes;
  return request.as_built ? keeper.modeler().planes_as_built() : keeper.planes();
}

/// Returns what is wrong with the request; empty if nothing is.
std::string find_defect(const GetModel::Request& request, bool has_before) {
  if (request.which > GetModel::Request::BEFORE_CORRECTION)
    return "which must be CURRENT (0) or BEFORE_CORRECTION (1)";
  if (request.which == GetModel::Request::BEFORE_CORRECTION && !has_before)
    return "there was no correction yet";
  return "";
}

/// Returns a page to look at the model, and at that before the correction if there was one.
std::string page_of(ModelKeeper& keeper, const ReportHead& head) {
  const ModelStatistics statistics = keeper.modeler().statistics();
  const ModelKeeper::Before& before = keeper.before();
  ModelHistory history{
      "before the correction",       nullptr,         before.trajectory, "now", &keeper.planes(),
      keeper.modeler().trajectory(), keeper.labels(), keeper.rooms()};
  if (statistics.revision > 0 && !before.trajectory.empty()) history.planes_before = &before.planes;
  Report report = report_of(head, history);
  report.add_fact("Lines", std::to_string(keeper.log().lines()) + ", " +
                               std::to_string(keeper.log().dropped_lines()) + " of them dropped");
  report.add_fact("Ribbons", std::to_string(statistics.ribbons));
  report.add_fact("Corrections", std::to_string(statistics.revision));
  return report.html();
}

}  // namespace

GetModel::Response model_response(const GetModel::Request& request, ModelKeeper& keeper,
                                  const std::string& map_frame) {
  const ModelStatistics statistics = keeper.modeler().statistics();
  GetModel::Response response;
  response.message = find_defect(request, keeper.has_before());
  response.success = response.message.empty();
  if (!response.success) return response;
  std_msgs::Header header;
  header.frame_id = map_frame;
  header.stamp = ros::Time::now();
  const bool is_final = request.which == GetModel::Request::CURRENT && !request.as_built;
  response.planes =
      plane_array_message(planes_asked_for(request, keeper), header, statistics.revision,
                          request.cells, is_final ? keeper.labels() : std::vector<PlaneLabel>());
  response.message = std::to_string(response.planes.planes.size()) + " planes";
  response.lines = keeper.log().lines();
  response.dropped_lines = keeper.log().dropped_lines();
  response.ribbons = statistics.ribbons;
  response.us_per_line = keeper.log().median_line_us();
  response.correction_ms = keeper.correction_ms();
  return response;
}

Save::Response save_response(const std::string& name, ModelKeeper& keeper,
                             const std::filesystem::path& directory, const std::string& frame,
                             const std::vector<ChangedKey>& parameters,
                             const std::vector<MeshFormat>& mesh_formats) {
  Save::Response response;
  try {
    check_save_name(name);
    check_files_of_its_own(name);
    if (keeper.modeler().statistics().ribbons == 0) {
      throw std::runtime_error(
          "the model is empty: nothing is written, and a model of that name stays");
    }
    const std::vector<Plane>& planes = keeper.planes();
    response.message = std::to_string(planes.size()) + " planes written to";
    const auto page = [&](const std::string& run) {
      return page_of(keeper, {name, frame, run, "ribbon_mapper " + version(), "", parameters});
    };
    const auto exports = [&](const ModelLabel& label, FileSet& files) {
      add_meshes(planes, label, keeper.labels(), mesh_formats, name, files);
      add_floor_plan(keeper.floor_plan(), label, name + "_floor_plan", files);
    };
    for (const std::filesystem::path& file :
         save_model(planes, directory, name, keeper.stripe_gap_m(), frame,
                    {keeper.file_bytes(frame), keeper.labels(), page, keeper.rooms(), exports}))
      response.message += " " + file.string();
    response.success = true;
  } catch (const std::exception& error) {
    response.message = error.what();
  }
  return response;
}

Load::Response load_response(const std::string& name, ModelKeeper& keeper,
                             const std::filesystem::path& directory, const std::string& frame) {
  Load::Response response;
  try {
    check_save_name(name);
    const auto path_of = [&](const std::string& file) {
      return directory / (file + kModelFileEnding);
    };
    ModelFile file = load_model_file(path_of(name));
    if (!keeper.modeler().ribbons().empty()) {
      write_file_atomically(path_of(kBeforeLoad), keeper.file_bytes(frame));
    }
    response.message = load_into(keeper, std::move(file), path_of(name), frame);
    response.success = true;
  } catch (const std::exception& error) {
    response.message = error.what();
  }
  return response;
}

std::string load_into(ModelKeeper& keeper, ModelFile file, const std::filesystem::path& path,
                      const std::string& frame) {
  std::string text;
  for (const std::string& sentence : differences(file, keeper.modeler().config(), frame)) {
    text += "; " + sentence;
  }
  keeper.load(std::move(file));
  const ModelStatistics statistics = keeper.modeler().statistics();
  return path.string() + ": " + std::to_string(statistics.ribbons) + " ribbons of " +
         std::to_string(statistics.lines) + " lines, " + std::to_string(statistics.revision) +
         " corrections, " + std::to_string(keeper.planes().size()) + " planes" + text;
}

Annotate::Response annotate_response(const Annotate::Request& request, ModelKeeper& keeper) {
  Annotate::Response response;
  try {
    keeper.annotate(request.id, request.label, request.note);
    response.success = true;
    response.message = "plane " + std::to_string(request.id) +
                       (request.label.empty() ? ": annotation removed" : ": " + request.label);
  } catch (const std::invalid_argument& error) {
    response.message = error.what();
  }
  return response;
}

}  // namespace ribbon_mapper
