#include "pipeline/outputs.h"

#include "base/files.h"
#include "base/memory.h"
#include "base/stopwatch.h"
#include "build3mf/build_writer.h"
#include "curved/vti_writer.h"
#include "geometry/append_mesh.h"
#include "geometry/formats/mesh_reader.h"
#include "layers/vtp_writer.h"
#include "motion/trajectory_csv.h"
#include "pipeline/checked_program.h"
#include "pipeline/pedestal.h"
#include "pipeline/plan_verdict.h"
#include "pipeline/program_files.h"
#include "pipeline/proof.h"
#include "pipeline/replay_stage.h"
#include "pipeline/reported_choices.h"
#include "planar/given_cuts.h"
#include "toolpath/path_vtp_writer.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace voluta::pipeline {

namespace {
constexpr const char* kReportName = "report.json";

void writePieces(const std::vector<planar::Piece>& pieces, const std::filesystem::path& folder,
                 const base::RunContext& ctx) {
  std::error_code failed; // a failure is reported when a file is written
  std::filesystem::create_directories(folder, failed);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    ctx.checkpoint();
    base::writeFile(folder / (std::to_string(i) + ".stl"),
                    geometry::writeStl(pieces[i].solid.mesh));
  }
  if (const auto cuts = planar::cutsOf(pieces); !cuts.empty())
    base::writeFile(folder / "cuts.json", planar::givenCutsText(cuts));
}

void writeDebug(const PlanResult& result, const std::filesystem::path& folder,
                const base::RunContext& ctx) {
  for (std::size_t i = 0; i < result.job.items.size(); ++i) {
    const project::JobItem& item = result.job.item(i);
    // The files of the first item have the names of a single one's.
    const std::string number = i == 0 ? "" : "-" + std::to_string(i + 1);
    if (const project::Voxels voxels = item.decomposition())
      base::writeFile(folder / ("voxels" + number + ".vti"), curved::voxelsVti(*voxels));
    if (const project::Pieces pieces = item.pieces())
      writePieces(pieces->pieces, folder / ("pieces" + number), ctx);
    ctx.checkpoint();
    if (item.layers)
      base::writeFile(folder / ("layers" + number + ".vtp"), layers::writeLayersVtp(*item.layers));
    ctx.checkpoint();
  }
  if (result.job.toolPlan)
    base::writeFile(folder / "toolpath.vtp", toolpath::writeToolpathVtp(*result.job.toolPlan));
  ctx.checkpoint();
  if (result.job.trajectory)
    base::writeFile(folder / "trajectory.csv",
                    motion::trajectoryCsv(*result.job.trajectory,
                                          result.cell ? robot::kindsOf(result.cell->limits())
                                                      : std::vector<robot::JointKind>{}));
}
} // namespace

std::string writtenName(const CheckedProgram& program, const plan::ProgramFile& file) {
  return program.safeToRun ? file.name : std::string(kRefusedPrefix) + file.name;
}

namespace {
void writeProgram(const CheckedProgram& checked, const std::filesystem::path& folder,
                  const base::RunContext& ctx) {
  for (const plan::ProgramFile& file : checked.program.files) {
    ctx.checkpoint();
    base::writeFile(folder / writtenName(checked, file), file.text);
  }
}
} // namespace

namespace {
// Names the files of a program that the folder holds, and whether they are released.
void nameWritten(project::ProgramReport& program, const std::filesystem::path& folder) {
  const auto isThere = [&](const std::string& prefix) {
    return !program.files.empty() &&
           std::ranges::all_of(program.files, [&](const std::string& name) {
             return std::filesystem::exists(folder / (prefix + name));
           });
  };
  const std::string refused(kRefusedPrefix);
  if (isThere("")) {
    program.state = "released";
  } else if (isThere(refused)) {
    program.state = "refused";
    for (std::string& name : program.files)
      name.insert(0, refused);
  } else {
    program.state = "notWritten";
    program.files.clear();
    program.bytes = 0;
  }
}

// Sorts blocking findings first; otherwise they keep the order of the stages.
void writeReport(project::Report report, const project::Job& job,
                 const std::filesystem::path& folder) {
  static_cast<project::VerdictReport&>(report) = verdictReport(report);
  for (project::ProgramReport& program : report.programs)
    nameWritten(program, folder);
  std::ranges::stable_partition(report.findings, &plan::Finding::blocking);
  const ReportedChoices choices = reportedChoices(job);
  auto json = nlohmann::ordered_json::parse(project::reportJson(report));
  json["preset"] = {{"name", choices.preset}, {"changed", choices.changed}};
  json["pauses"] = choices.pauses;
  base::writeFile(folder / kReportName, json.dump(2) + "\n");
}

// The build file contains the whole part's tool-paths, so a resumed print has none.
bool writesBuildFile(const PlanResult& result) {
  return result.buildFile && result.job.toolPlan && result.job.resumedAt == 0;
}
} // namespace

std::string buildName(const PlanResult& result) {
  return programsName(result.job) + build3mf::kEnding;
}

void writeBuildFile(const PlanResult& result, const std::filesystem::path& folder,
                    const base::RunContext& ctx) {
  if (!result.job.toolPlan || !result.job.item().part)
    return;
  geometry::TriangleMesh all = *result.job.item().part;
  for (std::size_t i = 1; i < result.job.items.size(); ++i)
    geometry::appendMesh(all, *result.job.item(i).part);
  base::writeFile(folder / buildName(result),
                  build3mf::writeBuild(*result.job.toolPlan, all, result.job.item().partName, ctx));
}

namespace {
// A dialect that refuses the motion has no text.
bool isHandedOver(const CheckedProgram& checked, bool refusedToo) {
  return checked.safeToRun || (refusedToo && !checked.program.files.empty());
}
} // namespace

void writeOutputs(PlanResult& result, const std::filesystem::path& folder,
                  const base::RunContext& ctx, const ProofStyle& proofStyle) {
  base::Stopwatch writing;
  ctx.report(0.0, "write files"_text);
  Programs written;
  for (const auto& checked : result.checked)
    if (isHandedOver(*checked, result.keepRefused))
      written.push_back(checked);
  for (const auto& checked : written)
    writeProgram(*checked, folder, ctx);
  for (const plan::ProgramFile& file : pedestalFiles(result))
    base::writeFile(folder / file.name, file.text);
  const auto writeJob = [&] { project::writeJob(folder / "job.voluta", result.job); };
  if (result.proofs)
    writeProofs(result, written, folder, ctx, proofStyle, writeJob);
  else
    writeJob();
  if (writesBuildFile(result))
    writeBuildFile(result, folder, ctx);
  if (result.debug)
    writeDebug(result, folder, ctx);
  ctx.checkpoint();
  result.job.report.timings.write += writing.seconds();
  result.job.report.timings.total += writing.seconds();
  result.job.report.peakRssMb = base::peakResidentMb();
  writeReport(result.job.report, result.job, folder);
}

Programs chosenPrograms(const PlanResult& result, const std::vector<std::string>& formats,
                        bool refusedToo) {
  Programs chosen;
  for (const auto& checked : result.checked)
    if (std::find(formats.begin(), formats.end(), checked->program.format) != formats.end() &&
        isHandedOver(*checked, refusedToo))
      chosen.push_back(checked);
  return chosen;
}

std::vector<std::string> handoverNames(const PlanResult& result, const Programs& programs) {
  std::vector<std::string> names;
  for (const plan::ProgramFile& file : pedestalFiles(result))
    names.push_back(file.name);
  if (result.proofs) {
    const std::vector<std::string> proofs = proofNames(result, programs);
    names.insert(names.end(), proofs.begin(), proofs.end());
  }
  if (writesBuildFile(result))
    names.push_back(buildName(result));
  for (const auto& checked : programs)
    for (const plan::ProgramFile& file : checked->program.files)
      names.push_back(writtenName(*checked, file));
  names.emplace_back(kReportName);
  return names;
}

void writeHandover(const PlanResult& result, const Programs& programs,
                   const std::filesystem::path& folder, const base::RunContext& ctx,
                   const ProofStyle& proofStyle) {
  for (const auto& checked : programs)
    writeProgram(*checked, folder, ctx);
  for (const plan::ProgramFile& file : pedestalFiles(result))
    base::writeFile(folder / file.name, file.text);
  if (result.proofs)
    writeProofs(result, programs, folder, ctx, proofStyle);
  if (writesBuildFile(result))
    writeBuildFile(result, folder, ctx);
  const auto isThere = [&](const std::string& format) {
    return std::any_of(programs.begin(), programs.end(),
                       [&](const auto& checked) { return checked->program.format == format; });
  };
  project::Report written = result.job.report;
  std::erase_if(written.programs,
                [&](const project::ProgramReport& row) { return !isThere(row.format); });
  std::erase_if(written.findings, [&](const plan::Finding& finding) {
    const std::string format = formatOf(finding);
    return !format.empty() && !isThere(format);
  });
  written.peakRssMb = base::peakResidentMb();
  writeReport(std::move(written), result.job, folder);
}

} // namespace voluta::pipeline
