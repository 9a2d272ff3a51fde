// What a plan leaves in its folder (docs/design.md, Command line).
#pragma once

#include "base/run_context.h"
#include "pipeline/proof_style.h"
#include "pipeline/road.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace voluta::pipeline {

// The name under which a program's file is written: "refused-" before it where the replay refused
// it.
std::string writtenName(const CheckedProgram& program, const plan::ProgramFile& file);

// NAME.build.3mf, NAME being the part's.
std::string buildName(const PlanResult& result);
// The plan's beads for other programs (build3mf/build_writer.h); nothing where there are none yet.
// Throws Error{CannotWrite}; Cancelled.
void writeBuildFile(const PlanResult& result, const std::filesystem::path& folder,
                    const base::RunContext& ctx);

// job.voluta, report.json, the programs, the pedestal's files (pedestal.h) and, where asked for,
// what every stage made. Fills in the report's timings.write and peakRssMb. Throws
// Error{CannotWrite}.
void writeOutputs(PlanResult& result, const std::filesystem::path& folder,
                  const base::RunContext& ctx, const ProofStyle& proofStyle = {});

// Of a plan's programs those in these formats, refused ones only where `refusedToo`.
using Programs = std::vector<std::shared_ptr<const CheckedProgram>>;
Programs chosenPrograms(const PlanResult& result, const std::vector<std::string>& formats,
                        bool refusedToo);
// What writeHandover leaves in its folder.
std::vector<std::string> handoverNames(const PlanResult& result, const Programs& programs);
// What goes to the robot and its operator: the programs, their proofs (proof.h) and the build file
// where they are asked for, the pedestal's files (pedestal.h) and report.json, which names no other
// programs. Throws Error{CannotWrite}.
void writeHandover(const PlanResult& result, const Programs& programs,
                   const std::filesystem::path& folder, const base::RunContext& ctx,
                   const ProofStyle& proofStyle = {});

} // namespace voluta::pipeline
