// The project of a station: machines that work in one cell, each with its job.
#pragma once

#include "project/job.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::base {
class ParameterTable;
}

namespace voluta::project {

struct Machine {
  std::string name; // shown to the user; may be empty
  Job job;
  // The world of its cell in the frame that all machines share; usually that of the first one's.
  Eigen::Isometry3d shared_T_world = Eigen::Isometry3d::Identity();
};

// How machines share a station.
struct StationRules {
  double clearanceMm = 10.0; // minimum distance of moving bodies of two machines
  // A machine may wait inside a bead, with the extruder off, if it has passed no other place to
  // wait for that long [s]; infinite: never.
  double pauseInBeadsS = std::numeric_limits<double>::infinity();
};

// A job alone is a station of one machine.
struct Station {
  std::vector<Machine> machines;
  StationRules rules;
};

// Name of the file in the folder of a station's results.
inline constexpr const char* kStationFile = "station.voluta";

// Returns whether the bytes, or those of a file, begin as the project of a station.
bool isStation(std::string_view bytes);
bool isStationFile(const std::filesystem::path& file);

// Returns the content of the file: a line "VOLUTA STATION 1", a line with length and CRC-32 of a
// JSON header (rules, and for each machine its name, place and the length of its job), the header,
// and the jobs as jobBytes(). Precondition: every item of every job is loaded.
std::string stationBytes(const Station& station);
// Writes stationBytes(), completely or not at all. Throws Error{CannotWrite}.
void writeStation(const std::filesystem::path& file, const Station& station);

// Reads the project of a station, or of a job as a station of one machine. `table`: as for
// readJob(). Throws as readJob().
Station readStation(const std::filesystem::path& file, const base::ParameterTable& table);

} // namespace voluta::project
