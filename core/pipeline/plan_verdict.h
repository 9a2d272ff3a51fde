// The verdict on a plan and its programs. Exit code, reports, window and export take it from here.
#pragma once

#include "plan/finding.h"
#include "project/report.h"

#include <cstdint>
#include <string>
#include <vector>

namespace voluta::process {
class Tooling;
}

namespace voluta::pipeline {

struct CheckedProgram;
struct VerifyResult;

enum class PlanVerdict : std::uint8_t {
  Passed,     // safe to run, and prints the part as asked
  NotAsAsked, // safe to run, but the part differs from the requested one
  Unchecked,  // safe to run but for the user's own statements, which nothing checks
  Blocked,    // the replay found it safe to run, but a finding of the plan concerns safety
  Refused     // by the replay
};

// Returns the format of the program that a finding concerns; empty: the plan.
std::string formatOf(const plan::Finding& finding);

// Returns the blocking findings of the plan and of its program in a format.
std::vector<plan::Finding> blockersOf(const project::Report& report, const std::string& format);

// Returns the first blocking finding that concerns safety; without one, the first by which the part
// differs; null: none blocks.
const plan::Finding* firstBlocking(const plan::Findings& findings);

// Of one program of the plan.
PlanVerdict verdictOf(const CheckedProgram& program, const project::Report& report);
// Of a replayed plan with all its programs.
PlanVerdict verdictOf(const project::Report& report);

// Returns whether a program must not run.
bool isRefused(PlanVerdict verdict);

// Returns the same for report.json. A plan without any program has none. `safeToRun` is false where
// nothing checks the user's own statements.
project::VerdictReport verdictReport(const project::Report& report);
// Returns the word of report.json.
std::string verdictId(PlanVerdict verdict);

// Returns the length that the material of the longest unsupported bead bridges; if no bead is too
// long, that of the tool that bridges most [mm].
double bridgedMm(const CheckedProgram& program, const process::Tooling& tooling);

// Of a program read from disk.
PlanVerdict verdictOf(const VerifyResult& result);

} // namespace voluta::pipeline
