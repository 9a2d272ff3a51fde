// Verification report of a program, for those responsible for running it.
#pragma once

#include "base/run_context.h"
#include "page/sheet.h"
#include "pipeline/fill_map.h"
#include "pipeline/outputs.h"
#include "pipeline/plan_verdict.h"
#include "pipeline/proof_style.h"
#include "pipeline/reported_choices.h"
#include "pipeline/road.h"
#include "process/process.h"

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace voluta::pipeline {

// A place on the part and in the program. Unknown members are empty, 0 or negative.
struct ProofPlace {
  std::optional<Eigen::Vector3d> at; // of the nozzle tip, work frame [mm]
  int layer = 0;                     // from 1
  double atS = -1.0;                 // from the program's start
  std::string file;
  std::size_t line = 0;
};

// A worst-case value.
struct ProofValue {
  double value = 0.0;
  ProofPlace place;
};

struct Proof {
  std::string part, format, printed;  // printed: name of the mesh file
  bool foreign = false, rest = false; // rest: the program resumes a stopped print
  struct File {
    std::string name, sha256;
    std::size_t bytes = 0;
  };
  std::vector<File> files;
  std::string date, version; // local time; Voluta's version
  std::string robot, cell;
  base::Text mode;
  ReportedChoices choices;
  process::Process process;
  Eigen::Vector3d sizeMm = Eigen::Vector3d::Zero();
  int layers = 0;
  project::ReplayReport verdict;
  PlanVerdict decision = PlanVerdict::Passed;
  struct Blocker {
    base::Message reason;
    bool concernsSafety = false;
    ProofPlace place;
  };
  std::vector<Blocker> blockers;         // the plan's blocking findings
  std::size_t deviations = 0;            // places where the program differs from the plan
  double plannedS = 0.0, programS = 0.0; // durations by the plan and as the program runs
  double materialMm3 = 0.0;
  double massG = 0.0;
  // Of a job with several tools, one row each; else empty
  struct Tool {
    std::string process, material;
    double printedG = 0.0, purgedG = 0.0;
  };
  std::vector<Tool> tools;
  std::size_t toolChanges = 0;
  // Programs of nozzle positions without joint values are checked without the arm: clearance,
  // joints and isotropy are then empty.
  bool armChecked = false;
  ProofValue clearance; // of arm, plate and part [mm]; without the head's to plate and part
  struct Joint {
    std::string name;
    bool slides = false; // true: values in mm, false: in degrees
    ProofValue margin;   // to the nearer limit
    ProofValue speed;    // maximum share of its limit
  };
  std::vector<Joint> joints;
  ProofValue isotropy; // motion/joint_margins.h; 0: singular
  // Worst places of the replay's figures (replay/worst_places.h).
  ProofPlace gap, thin, overfill, unsupported, halfCarried, longestUnsupported, deviation,
      flowError, layerTime;
  double minLayerTimeS = 0.0; // required; 0: none
  FillMap fill;
};

// Returns the name of a program's first file as written, with ".proof" appended.
std::string proofName(const CheckedProgram& program);
std::string proofJson(const Proof& proof);
// Returns the sheet without its pictures.
page::Sheet proofSheet(const Proof& proof, const base::Language& language);

// Writes NAME.proof.html, .pdf and .json for each program, and PART.printed.stl. Calls `meanwhile`
// in parallel with the slowest step. Throws Error{CannotWrite}; Cancelled.
void writeProofs(
    const PlanResult& result, const Programs& programs, const std::filesystem::path& folder,
    const base::RunContext& ctx, const ProofStyle& style = {},
    const std::function<void()>& meanwhile = [] {});
std::vector<std::string> proofNames(const PlanResult& result, const Programs& programs);

} // namespace voluta::pipeline
