// One function per sub-command: takes typed options and returns the exit code. Results are written
// to stdout, progress and the one-line error message to stderr.
#pragma once

#include "base/run_context.h"
#include "cli/exit_code.h"
#include "cli/plate_options.h"
#include "cli/progress.h"
#include "pipeline/compare.h"
#include "pipeline/compare_figures.h"
#include "pipeline/compare_run.h"
#include "pipeline/resume.h"
#include "pipeline/road.h"
#include "robot/urdf/urdf_reader.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}
namespace voluta::process {
struct LibraryItem;
}

namespace voluta::cli {

// Throws Error{Usage} if a number of the parsed options is infinite or no number (nan), which
// ranges let through.
void requireFiniteNumbers(const CLI::App& app);

// Returns "; 1 more finding", "; 3 more findings" or, for 0, nothing.
std::string moreFindings(std::size_t more);
// Prints the first finding that blocks to stderr, as the one-line reason why a result is not
// complete: of safety, if there is one; nothing if none blocks. `nameOf`: returns "kitten.stl: "
// for a finding about one of several parts. `isReleased`: the programs are safe to run, so that the
// finding says how the part differs.
void sayBlocker(const plan::Findings& findings,
                const std::function<std::string(const plan::Finding&)>& nameOf, bool isReleased);

struct PlanOptions {
  pipeline::PlanRequest request; // its item has the choices common to all parts
  PlateOptions plate;
  std::filesystem::path folder;
  bool replace = false; // files of the folder that are not of such a job
  int threads = 1;
  ProgressStyle progress = ProgressStyle::Bar;
};
ExitCode planCommand(const PlanOptions& options);
// Work that fills a folder and returns a report.
using ReportingWork =
    std::function<project::Report(const std::filesystem::path& folder, const base::RunContext&)>;
// Runs the work; `folder`: of a plan; it appears when the work is done, and is unchanged otherwise.
// Prints a summary of the plan to stdout, and to stderr one line that says why it is not complete.
// `title`: as for progressSink().
ExitCode reportingCommand(const ReportingWork& work, const std::filesystem::path& folder,
                          bool replace, int threads, ProgressStyle progress,
                          const std::shared_ptr<const base::Message>& title = {});

struct CompareCommandOptions {
  pipeline::CompareOptions compared;
  pipeline::Weights weights;
  std::filesystem::path folder;
  bool replace = false; // files of the folder that are not of such a job
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

struct CompareRunOptions {
  std::filesystem::path job, record;
  std::filesystem::path curve; // file for the errors along the record; empty: none
  bool replace = false;        // the file of the curve, if it exists
  record::RunTolerances tolerances;
  std::size_t places = 10; // listed of each kind
  int threads = 1;
  ProgressStyle progress = ProgressStyle::Bar;
};
// Prints the errors of a recorded run and their worst places.
ExitCode compareRunCommand(const CompareRunOptions& options);

struct ResumeOptions {
  pipeline::ResumeRequest request;
  std::filesystem::path folder;
  bool replace = false; // files of the folder that are not of such a job
  int threads = 1;
  ProgressStyle progress = ProgressStyle::Bar;
};
// Writes the rest of a print as a new job.
ExitCode resumeCommand(const ResumeOptions& options);

struct InspectOptions {
  std::string part;
  bool json = false;
  int threads = 1;
};
ExitCode inspectCommand(const InspectOptions& options, const base::RunContext& ctx);

struct OrientOptions {
  pipeline::PlanRequest request; // A part and its placement
  bool json = false;
  int threads = 1;
};
// Prints the poses in which a part can stand.
ExitCode orientCommand(const OrientOptions& options);

struct RobotOptions {
  std::string id;
  std::string forward, inverse; // Comma-separated; exactly one of them is set
};
ExitCode robotCommand(const RobotOptions& options);

struct ImportRobotOptions {
  std::filesystem::path urdf, folder; // folder: empty for the user's data folder
  robot::UrdfOptions options;
  std::string cell = "moving"; // Or "fixed"
  int threads = 1;
  bool replace = false; // files of an earlier import
};
// Writes robot and cell files from a URDF, and prints the kind of the robot, the assumed values and
// the command for planning with it.
ExitCode importRobotCommand(const ImportRobotOptions& options);

// A table of measured points or poses (robot/measured/measured_json.h).
struct MeasuredOptions {
  std::filesystem::path table;
  std::string robot; // The robot whose joints the rows contain; empty: the rows are poses
};
ExitCode cellFrameCommand(const MeasuredOptions& options);
ExitCode cellTipCommand(const MeasuredOptions& options);

struct ReachOptions {
  project::Choices choices; // Uses cell, process, platform and parameters
  double heightMm = 150.0;
  bool json = false;
  int threads = 1;
};
// Print where the head of a cell reaches, and the best position of its stationary nozzle.
ExitCode cellReachCommand(const ReachOptions& options);
ExitCode cellNozzleCommand(const ReachOptions& options, const base::RunContext& ctx);

struct AdviseOptions {
  pipeline::PlanRequest request;
  std::vector<std::string> cells;
  bool plan = false; // also plans the part in each cell
  bool json = false;
  int threads = 1;
};
// Compares cells for a part and prints the best with a sentence why.
ExitCode cellAdviseCommand(const AdviseOptions& options);

struct PlaceCellOptions {
  pipeline::PlanRequest request; // Uses part, mode and process
  std::string robot;
  bool fixed = false;            // The nozzle is stationary
  std::optional<double> tiltDeg; // Largest tilt of the nozzle; default: as the mode needs
  std::filesystem::path file;    // Of the cell; empty: not written
  bool replace = false;          // the file, if it exists
  int threads = 1;
};
// Finds the nozzle's bend and the place of plate or nozzle for a part, and writes the cell.
ExitCode cellPlaceCommand(const PlaceCellOptions& options);

struct MaterialOptions {
  std::string material;       // id, or a material's file
  std::string other;          // to compare with
  std::filesystem::path file; // to write
  bool replace = false;       // the file, if it exists
};
// Prints the fields that differ, one per line. Precondition: items of one shelf.
void sayDifferences(const process::LibraryItem& first, const process::LibraryItem& second);
ExitCode materialShowCommand(const MaterialOptions& options);   // its file's text
ExitCode materialCheckCommand(const MaterialOptions& options);  // whether it can be used
ExitCode materialImportCommand(const MaterialOptions& options); // copies it to the user's own
ExitCode materialExportCommand(const MaterialOptions& options);
ExitCode materialCompareCommand(const MaterialOptions& options); // prints the fields that differ

struct ProcessOptions {
  std::string process;         // id, or a process's file
  std::string other;           // to compare with
  std::filesystem::path file;  // to write
  std::filesystem::path table; // of measured sizes (process/measured_sizes.h)
  bool replace = false;        // the file, if it exists
};
ExitCode processShowCommand(const ProcessOptions& options);   // its file's text
ExitCode processCheckCommand(const ProcessOptions& options);  // whether it can be used
ExitCode processImportCommand(const ProcessOptions& options); // copies it to the user's own
ExitCode processExportCommand(const ProcessOptions& options);
ExitCode processCompareCommand(const ProcessOptions& options); // prints the fields that differ
// Prints the corrections that measured sizes of a part of this process give, and writes the process
// with them to `file` if it is set.
ExitCode processSizesCommand(const ProcessOptions& options);
ExitCode processListCommand(const ProcessOptions& options); // all, and which are the user's own

struct CellFileOptions {
  std::string cell;           // id, or a cell's file
  std::filesystem::path file; // to write
  bool replace = false;       // the file, if it exists
};
ExitCode cellImportCommand(const CellFileOptions& options); // copies it to the user's own
ExitCode cellExportCommand(const CellFileOptions& options); // with its robot, if that is an own one

struct CheckCellOptions {
  std::string cell; // Id, or a file
  std::string process = "fdm-1.0";
  double partKg = 0.0;
};
// Prints one line for each limitation of the cell.
ExitCode cellCheckCommand(const CheckCellOptions& options, const base::RunContext& ctx);

struct ListOptions {
  std::string what;
  bool json = false;
};
ExitCode listCommand(const ListOptions& options);
std::vector<std::string> listedKinds(); // the words of `what`

} // namespace voluta::cli
