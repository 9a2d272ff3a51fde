// Writes the output files of a plan (docs/design.md, Command line).
#pragma once

#include "base/run_context.h"
#include "pipeline/proof_style.h"
#include "pipeline/road.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace voluta::plan {
struct ProgramFile;
}

namespace voluta::pipeline {

// Returns the name under which a program's file is written: prefixed with "refused-" if the replay
// refused the program.
std::string writtenName(const CheckedProgram& program, const plan::ProgramFile& file);

// Returns NAME.build.3mf, where NAME is the part's.
std::string buildName(const PlanResult& result);
// Writes the plan's beads for other programs (build3mf/build_writer.h); writes nothing before they
// exist. Throws Error{CannotWrite}; Cancelled.
void writeBuildFile(const PlanResult& result, const std::filesystem::path& folder,
                    const base::RunContext& ctx);

// Writes job.voluta, report.json, the programs, the pedestal's files (pedestal.h) and, on request,
// each stage's intermediate results. Sets timings.write and peakRssMb of the report. Throws
// Error{CannotWrite}.
void writeOutputs(PlanResult& result, const std::filesystem::path& folder,
                  const base::RunContext& ctx, const ProofStyle& proofStyle = {});

// Returns the plan's programs in these formats; refused programs only if `refusedToo`.
using Programs = std::vector<std::shared_ptr<const CheckedProgram>>;
Programs chosenPrograms(const PlanResult& result, const std::vector<std::string>& formats,
                        bool refusedToo);
// Returns the names of the files that writeHandover() writes.
std::vector<std::string> handoverNames(const PlanResult& result, const Programs& programs);
// Writes the files for the robot and its operator: the programs, their proofs (proof.h) and the
// build file if requested, the pedestal's files (pedestal.h) and report.json, which lists only
// these programs. Throws Error{CannotWrite}.
void writeHandover(const PlanResult& result, const Programs& programs,
                   const std::filesystem::path& folder, const base::RunContext& ctx,
                   const ProofStyle& proofStyle = {});

} // namespace voluta::pipeline
