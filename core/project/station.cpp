#include "project/station.h"

#include "base/error.h"
#include "base/files.h"
#include "project/block_file.h"
#include "project/file_frame.h"
#include "project/job_magic.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace voluta::project {

namespace {
using Json = nlohmann::ordered_json;

constexpr int kStationFormat = 1;
constexpr FileNames kNames{kStationMagic, "not the project of a station"_text,
                           "the file of the station is truncated"_text,
                           "the header of the station's file is damaged"_text};

Json placeJson(const Eigen::Isometry3d& place) {
  const Eigen::Quaterniond q(place.linear());
  const Eigen::Vector3d p = place.translation();
  return Json{{"mm", {p.x(), p.y(), p.z()}}, {"rotation", {q.w(), q.x(), q.y(), q.z()}}};
}

Eigen::Isometry3d readPlace(const Json& j) {
  const Json &mm = j.at("mm"), &q = j.at("rotation");
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.translation() =
      Eigen::Vector3d(mm.at(0).get<double>(), mm.at(1).get<double>(), mm.at(2).get<double>());
  const Eigen::Quaterniond rotation(q.at(0).get<double>(), q.at(1).get<double>(),
                                    q.at(2).get<double>(), q.at(3).get<double>());
  if (!place.translation().allFinite() || !(std::abs(rotation.norm() - 1.0) < 1e-6))
    throw base::Error(base::ErrorCode::UnreadableFile, "the place of a machine is damaged"_text);
  place.linear() = rotation.normalized().toRotationMatrix();
  return place;
}

Json rulesJson(const StationRules& rules) {
  Json j{{"clearanceMm", rules.clearanceMm}};
  if (std::isfinite(rules.pauseInBeadsS))
    j["pauseInBeadsS"] = rules.pauseInBeadsS;
  return j;
}

StationRules readRules(const Json& j) {
  StationRules rules;
  j.at("clearanceMm").get_to(rules.clearanceMm);
  rules.pauseInBeadsS = j.value("pauseInBeadsS", rules.pauseInBeadsS);
  if (!(rules.clearanceMm >= 0.0) || !std::isfinite(rules.clearanceMm) ||
      !(rules.pauseInBeadsS > 0.0))
    throw base::Error(base::ErrorCode::UnreadableFile, "the rules of the station are damaged"_text);
  return rules;
}

Station readMachines(std::string_view bytes, const std::string& where,
                     const base::ParameterTable& table) {
  const FileFrame frame = fileFrame(bytes, where, kNames, kStationFormat, kStationFormat);
  const Json header = Json::parse(frame.header);
  Station station;
  station.rules = readRules(header.at("rules"));
  std::string_view rest = frame.body;
  for (const Json& row : header.at("machines")) {
    const auto length = row.at("bytes").get<std::size_t>();
    if (length > rest.size())
      throw base::Error(base::ErrorCode::UnreadableFile, kNames.truncated, where);
    Machine& machine = station.machines.emplace_back();
    row.at("name").get_to(machine.name);
    machine.shared_T_world = readPlace(row.at("place"));
    machine.job = jobOf(rest.substr(0, length), where, table);
    rest.remove_prefix(length);
  }
  if (!rest.empty())
    throw base::Error(base::ErrorCode::UnreadableFile, kNames.damaged, where);
  if (station.machines.empty())
    throw base::Error(base::ErrorCode::UnreadableFile, "the station has no machines"_text, where);
  return station;
}

} // namespace

bool isStation(std::string_view bytes) {
  return bytes.starts_with(kStationMagic);
}

bool isStationFile(const std::filesystem::path& file) {
  return isStation(base::beginningOf(file, kStationMagic.size()));
}

std::string stationBytes(const Station& station) {
  Json machines = Json::array();
  std::string jobs;
  for (const Machine& machine : station.machines) {
    const std::string job = jobBytes(machine.job);
    machines.push_back({{"name", machine.name},
                        {"place", placeJson(machine.shared_T_world)},
                        {"bytes", job.size()}});
    jobs += job;
  }
  const Json header{{"rules", rulesJson(station.rules)}, {"machines", std::move(machines)}};
  return fileHead(kStationMagic, kStationFormat,
                  header.dump(1, ' ', false, Json::error_handler_t::replace)) +
         jobs;
}

void writeStation(const std::filesystem::path& file, const Station& station) {
  base::writeFile(file, stationBytes(station));
}

Station readStation(const std::filesystem::path& file, const base::ParameterTable& table) {
  const std::string where = file.string();
  const std::string bytes = base::readFile(file);
  if (!isStation(bytes)) {
    Station one;
    one.machines.push_back({{}, jobOf(bytes, where, table)});
    return one;
  }
  try {
    return readMachines(bytes, where, table);
  } catch (const nlohmann::json::exception&) {
    throw base::Error(base::ErrorCode::UnreadableFile, kNames.damaged, where);
  } catch (const base::Error& e) {
    if (!e.context().empty())
      throw;
    throw base::Error(e.code(), e.message(), where, e.remedy());
  }
}

} // namespace voluta::project
