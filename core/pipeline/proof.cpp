#include "pipeline/proof.h"

#include "base/files.h"
#include "base/parallel.h"
#include "base/sha256.h"
#include "base/units.h"
#include "collision/growing_part.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "motion/margins.h"
#include "motion/resume.h"
#include "pipeline/printed_mesh.h"
#include "pipeline/replay_stage.h"
#include "voxel/column_parity.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>

namespace voluta::pipeline {

namespace {

using Json = nlohmann::ordered_json;

// What all programs of a plan have in common.
struct Measured {
  plan::Trajectory trajectory; // of the programs, from their start
  motion::MotionMargins margins;
  FillMap fill;
  std::string printed;
};

std::string printedName(const PlanResult& result) {
  return programsName(result.job) + ".printed.stl";
}

bool isProved(const CheckedProgram& program) {
  return program.passed && !program.program.files.empty();
}

// The value with its place: `point` of the programs' own motion.
ProofValue valueAt(double value, std::size_t point, const PlanResult& result,
                   const Measured& measured, const CheckedProgram& checked) {
  ProofValue at{value, {}, 0, measured.trajectory.timeS[point]};
  const TextLine line = checked.pointLines[result.job.resumedAt + point];
  if (line.line > 0 && line.file < checked.program.files.size()) {
    at.file = checked.program.files[line.file].name;
    at.line = line.line;
  }
  return at;
}

Proof proofOf(const CheckedProgram& checked, const PlanResult& result, const Measured& measured) {
  Proof proof;
  proof.part = result.job.partName;
  proof.format = checked.program.format;
  proof.foreign = checked.program.foreign;
  proof.printed = measured.printed;
  for (const plan::ProgramFile& file : checked.program.files)
    proof.files.push_back({file.name, base::sha256(file.text), file.text.size()});
  proof.verdict = checked.verdict;
  const project::MotionReport& motion = result.job.report.motion;
  proof.plannedS = motion.durationS;
  proof.programS = checked.verdict.controllerDurationS;
  const plan::Trajectory& t = measured.trajectory;
  proof.materialMm3 = t.extrudedMm3.back();
  const auto closest = std::lower_bound(t.timeS.begin(), t.timeS.end(), motion.minClearanceAtS);
  proof.clearance =
      valueAt(motion.minClearanceMm,
              std::min(static_cast<std::size_t>(closest - t.timeS.begin()), t.pointCount() - 1),
              result, measured, checked);
  const int arm = result.cell->armDof();
  for (std::size_t j = 0; j < measured.margins.joints.size(); ++j) {
    const motion::LimitMargin& margin = measured.margins.joints[j];
    const int external = static_cast<int>(j) - arm;
    const robot::JointKind kind = result.cell->limits()[j].kind;
    proof.joints.push_back(
        {external < 0 ? std::to_string(j + 1)
                      : result.cell->externalAxes()[static_cast<std::size_t>(external)].name,
         kind == robot::JointKind::Sliding,
         valueAt(robot::shownValue(kind, margin.rad), margin.point, result, measured, checked)});
  }
  proof.isotropy =
      valueAt(measured.margins.isotropy, measured.margins.isotropyPoint, result, measured, checked);
  proof.fill = measured.fill;
  return proof;
}

Json placeJson(const ProofValue& value, const char* key) {
  return Json{{key, value.value}, {"file", value.file}, {"line", value.line}, {"atS", value.atS}};
}

// Where the shares stand in the text: in one line, not in thousands.
constexpr const char* kFilled = "@filled@";

Json fillJson(const FillMap& fill) {
  return Json{{"cellMm", fill.cellMm},
              {"originMm", {fill.origin.x(), fill.origin.y(), fill.origin.z()}},
              {"size", {fill.size.x(), fill.size.y(), fill.size.z()}},
              {"filled", kFilled}};
}

void sideBySide(const base::RunContext& ctx, const std::vector<std::function<void()>>& pieces) {
  base::parallelChunks(ctx, pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      pieces[i]();
  });
}

std::string filledJson(const FillMap& fill) {
  Json filled = Json::array();
  for (const double share : fill.filled)
    filled.push_back(share < 0.0 ? Json() : Json(std::round(1e4 * share) / 1e4));
  return filled.dump();
}

} // namespace

FillMap fillMap(const geometry::TriangleMesh& part, const collision::GrowingPart& growing,
                const base::RunContext& ctx) {
  constexpr double kAcross = 40.0;
  const Eigen::AlignedBox3d box = geometry::bounds(part);
  voxel::VoxelGrid grid;
  grid.pitch = growing.grid().pitch;
  const Eigen::Vector3i shift =
      ((box.min() - growing.grid().origin) / grid.pitch).array().floor().cast<int>();
  grid.origin = growing.grid().origin + grid.pitch * shift.cast<double>();
  grid.size = ((box.max() - grid.origin) / grid.pitch).array().ceil().cast<int>().max(1);
  std::vector<std::uint8_t> inside(grid.cellCount(), 0);
  if (const geometry::TriangleMesh caps = voxel::capsOf(part); caps.triangles.empty())
    voxel::fillClosed(part, grid, inside, ctx);
  else
    voxel::fillOpen(part, caps, grid, inside, ctx);

  FillMap map;
  const int times =
      std::max(1, static_cast<int>(std::ceil(box.sizes().maxCoeff() / kAcross / grid.pitch)));
  map.cellMm = times * grid.pitch;
  map.origin = grid.origin;
  map.size = (grid.size.array() + times - 1) / times;
  const voxel::VoxelGrid cubes{map.origin, map.cellMm, map.size};
  std::vector<double> there(cubes.cellCount(), 0.0), filled(there);
  for (std::size_t c = 0; c < inside.size(); ++c) {
    if (inside[c] == 0)
      continue;
    const Eigen::Vector3i cell = grid.cell(c);
    const std::size_t cube = cubes.index(cell.x() / times, cell.y() / times, cell.z() / times);
    there[cube] += 1.0;
    const Eigen::Vector3i bead = cell + shift;
    if (growing.grid().contains(bead.x(), bead.y(), bead.z()) &&
        growing.filledAt(growing.grid().index(bead.x(), bead.y(), bead.z())) !=
            collision::GrowingPart::kNeverFilled)
      filled[cube] += 1.0;
  }
  for (std::size_t c = 0; c < there.size(); ++c)
    map.filled.push_back(there[c] > 0.0 ? filled[c] / there[c] : -1.0);
  return map;
}

std::string proofName(const CheckedProgram& program) {
  return program.program.files.front().name + ".proof";
}

std::string proofJson(const Proof& proof) {
  Json files = Json::array(), joints = Json::array();
  for (const Proof::File& file : proof.files)
    files.push_back({{"name", file.name}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  for (const Proof::Joint& joint : proof.joints) {
    Json row = placeJson(joint.margin, joint.slides ? "marginMm" : "marginDeg");
    row["joint"] = joint.name;
    joints.push_back(std::move(row));
  }
  const project::ReplayReport& v = proof.verdict;
  std::string text = Json{
      {"part", proof.part},
      {"format", proof.format},
      {"foreign", proof.foreign},
      {"files", std::move(files)},
      {"durationS", {{"planned", proof.plannedS}, {"program", proof.programS}}},
      {"materialMm3", proof.materialMm3},
      {"replay",
       {{"passed", v.passed},
        {"coveredFraction", v.coveredFraction},
        {"unsupportedFraction", v.unsupportedFraction},
        {"overfillFraction", v.overfillFraction},
        {"massRatio", v.massRatio},
        {"collisions", v.collisions},
        {"limitViolations", v.limitViolations},
        {"maxDeviationMm", v.maxDeviationMm}}},
      {"leastClearance", placeJson(proof.clearance, "mm")},
      {"jointLimits", std::move(joints)},
      {"singularity", placeJson(proof.isotropy, "isotropy")},
      {"fillMap", fillJson(proof.fill)},
      {"printedMesh",
       proof.printed}}.dump(1, ' ', false, Json::error_handler_t::replace);
  const std::string mark = std::string("\"") + kFilled + "\"";
  return text.replace(text.rfind(mark), mark.size(), filledJson(proof.fill)) + "\n";
}

std::vector<std::string> proofNames(const PlanResult& result, const Programs& programs) {
  std::vector<std::string> names;
  for (const auto& checked : programs)
    if (isProved(*checked)) {
      names.push_back(proofName(*checked) + ".html");
      names.push_back(proofName(*checked) + ".json");
    }
  if (!names.empty())
    names.push_back(printedName(result));
  return names;
}

void writeProofs(const PlanResult& result, const Programs& programs,
                 const std::filesystem::path& folder, const base::RunContext& ctx,
                 const std::function<void()>& meanwhile) {
  if (proofNames(result, programs).empty() || !result.job.trajectory || !result.cell)
    return meanwhile();
  const plan::ToolPlan& plan = *result.job.toolPlan;
  const plan::Trajectory& whole = *result.job.trajectory;
  const collision::GrowingPart growing(plan, collision::growingPitch(plan, *result.process), ctx);
  Measured measured;
  measured.trajectory = motion::partOf(whole, result.job.resumedAt, whole.pointCount());
  measured.printed = printedName(result);
  sideBySide(ctx,
             {[&] { measured.margins = motion::marginsOf(measured.trajectory, *result.cell, ctx); },
              [&] { measured.fill = fillMap(result.job.printed(), growing, ctx); },
              [&] {
                base::writeFile(folder / measured.printed,
                                geometry::writeStl(outerBeads(plan, growing)));
              },
              meanwhile});
  std::vector<std::function<void()>> proofs;
  for (const auto& checked : programs)
    if (isProved(*checked))
      proofs.push_back([&] {
        const Proof proof = proofOf(*checked, result, measured);
        base::writeFile(folder / (proofName(*checked) + ".json"), proofJson(proof));
        base::writeFile(folder / (proofName(*checked) + ".html"), proofPage(proof));
      });
  sideBySide(ctx, proofs);
}

} // namespace voluta::pipeline
