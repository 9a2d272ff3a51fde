// What was checked of a program, for whoever has to answer for running it.
#pragma once

#include "base/run_context.h"
#include "page/sheet.h"
#include "pipeline/fill_map.h"
#include "pipeline/outputs.h"
#include "pipeline/proof_style.h"
#include "pipeline/road.h"
#include "pipeline/stages.h"

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace voluta::pipeline {

// A place on the part and in the program. What is not known is empty, 0 or below 0.
struct ProofPlace {
  std::optional<Eigen::Vector3d> at; // of the nozzle's tip, work frame, mm
  int layer = 0;                     // from 1
  double atS = -1.0;                 // from the program's start
  std::string file;
  std::size_t line = 0;
};

// A value at its worst.
struct ProofValue {
  double value = 0.0;
  ProofPlace place;
};

struct Proof {
  std::string part, format, printed;  // printed: file of the mesh
  bool foreign = false, rest = false; // rest: of a print that was stopped
  struct File {
    std::string name, sha256;
    std::size_t bytes = 0;
  };
  std::vector<File> files;
  std::string date, version; // local time; Voluta's
  std::string robot, cell;
  base::Text mode;
  process::Process process;
  Eigen::Vector3d sizeMm = Eigen::Vector3d::Zero();
  int layers = 0;
  project::ReplayReport verdict;
  std::size_t deviations = 0;            // places where the text is not what was planned
  double plannedS = 0.0, programS = 0.0; // how long: by the plan, and as the program is run
  double materialMm3 = 0.0;
  // Of a program that says where the nozzle is and not where the arm is, nothing of an arm was
  // checked: clearance, joints and isotropy are then empty.
  bool armChecked = false;
  ProofValue clearance; // of arm, plate and part, mm; the head's to plate and part left out
  struct Joint {
    std::string name;
    bool slides = false; // then mm, else degrees
    ProofValue margin;   // to the nearer limit
    ProofValue speed;    // share of its limit, at most
  };
  std::vector<Joint> joints;
  ProofValue isotropy; // motion/margins.h; 0: singular
  // Where the replay's figures are at their worst (replay/worst_places.h).
  ProofPlace gap, overfill, unsupported, halfCarried, longestUnsupported, deviation, flowError;
  FillMap fill;

  double massG() const { return 1e-3 * materialMm3 * process.material.densityGPerCm3; }
};

// NAME of a program's first file, as it is written.
std::string proofName(const CheckedProgram& program);
std::string proofJson(const Proof& proof);
// The sheet without its pictures.
page::Sheet proofSheet(const Proof& proof, const base::Language& language);

// NAME.proof.html, .pdf and .json for each of the programs, and PART.printed.stl. `meanwhile` is
// called as well, side by side with what takes longest. Throws Error{CannotWrite}; Cancelled.
void writeProofs(
    const PlanResult& result, const Programs& programs, const std::filesystem::path& folder,
    const base::RunContext& ctx, const ProofStyle& style = {},
    const std::function<void()>& meanwhile = [] {});
std::vector<std::string> proofNames(const PlanResult& result, const Programs& programs);

} // namespace voluta::pipeline
