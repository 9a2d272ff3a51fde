// One function a sub-command: typed options in, exit code out. Results go to stdout, progress and
// the one line about what went wrong to stderr.
#pragma once

#include "cli/exit_code.h"
#include "cli/progress.h"
#include "pipeline/compare.h"
#include "pipeline/compare_figures.h"
#include "pipeline/resume.h"
#include "pipeline/road.h"
#include "robot/urdf/urdf_reader.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace voluta::cli {

struct PlanOptions {
  pipeline::PlanRequest request;
  std::filesystem::path folder;
  int threads = 1;
  ProgressStyle progress = ProgressStyle::Bar;
};
ExitCode planCommand(const PlanOptions& options);
// What fills a folder and comes to a report.
using ReportingWork =
    std::function<project::Report(const std::filesystem::path& folder, const base::RunContext&)>;
// The folder appears when the work is done, and stays as it was otherwise. To stdout what was
// planned, to stderr the one line that says why it is not complete. `title`: as progressSink().
ExitCode reportingCommand(const ReportingWork& work, const std::filesystem::path& folder,
                          int threads, ProgressStyle progress,
                          const std::shared_ptr<const base::Message>& title = {});

struct CompareCommandOptions {
  pipeline::CompareOptions compared;
  pipeline::Weights weights;
  std::filesystem::path folder;
  bool pictures = true;
  int threads = 1;
  ProgressStyle progress = ProgressStyle::Bar;
};
// Writes compare.json, and a folder with report, programs and pictures for each row.
ExitCode compareCommand(const CompareCommandOptions& options);

struct VerifyOptions {
  std::filesystem::path program, job;
  int threads = 1;
  ProgressStyle progress = ProgressStyle::Bar;
};
ExitCode verifyCommand(const VerifyOptions& options);

struct ResumeOptions {
  pipeline::ResumeRequest request;
  std::filesystem::path folder;
  int threads = 1;
  ProgressStyle progress = ProgressStyle::Bar;
};
// Writes the rest of a print as a job of its own.
ExitCode resumeCommand(const ResumeOptions& options);

struct InspectOptions {
  std::string part;
  bool json = false;
};
ExitCode inspectCommand(const InspectOptions& options);

struct OrientOptions {
  pipeline::PlanRequest request; // a part and how it is placed
  bool json = false;
  int threads = 1;
};
// The ways in which a part can stand.
ExitCode orientCommand(const OrientOptions& options);

struct RobotOptions {
  std::string id;
  std::string forward, inverse; // comma separated; one of them
};
ExitCode robotCommand(const RobotOptions& options);

struct ImportRobotOptions {
  std::filesystem::path urdf, folder; // folder: empty for the user's own
  robot::UrdfOptions options;
  std::string cell = "moving"; // or "fixed"
  int threads = 1;
};
// Writes a robot's file and a cell's from a URDF, and says what the robot is, what of it is assumed
// and how to plan with it.
ExitCode importRobotCommand(const ImportRobotOptions& options);

// A table of points or poses that were measured (robot/measured/measured_json.h).
struct MeasuredOptions {
  std::filesystem::path table;
  std::string robot; // poses as its joints; empty: as poses
};
ExitCode cellFrameCommand(const MeasuredOptions& options);
ExitCode cellTipCommand(const MeasuredOptions& options);

struct ReachOptions {
  project::Choices choices; // cell, process, platform and parameters count
  double heightMm = 150.0;
  bool json = false;
  int threads = 1;
};
// Where the head of a cell reaches, and where its nozzle, if it stands still, stood best.
ExitCode cellReachCommand(const ReachOptions& options);
ExitCode cellNozzleCommand(const ReachOptions& options);

struct CheckCellOptions {
  std::string cell; // id, or a file
  std::string process = "fdm-1.0";
  double partKg = 0.0;
};
// A line for each thing that the cell cannot do.
ExitCode cellCheckCommand(const CheckCellOptions& options);

struct ListOptions {
  std::string what;
  bool json = false;
};
ExitCode listCommand(const ListOptions& options);

} // namespace voluta::cli
