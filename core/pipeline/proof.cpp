#include "pipeline/proof.h"

#include "base/files.h"
#include "base/parallel.h"
#include "base/sha256.h"
#include "collision/growing_part.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "modes/mode_table.h"
#include "motion/joint_margins.h"
#include "motion/motion_options.h"
#include "motion/resumed_motion.h"
#include "pipeline/checked_program.h"
#include "pipeline/printed_mesh.h"
#include "pipeline/replay_stage.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "project/version.h"
#include "replay/covering_times.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fmt/chrono.h>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace voluta::pipeline {

namespace {

using Json = nlohmann::ordered_json;

// Data shared by all programs of a plan.
struct Measured {
  plan::Trajectory trajectory; // of the programs, from their start
  motion::MotionMargins margins;
  FillMap fill;
  std::string printed;
  std::vector<page::Picture> pictures;
};

std::string printedName(const PlanResult& result) {
  return programsName(result.job) + ".printed.stl";
}

bool isProved(const CheckedProgram& program) {
  return !program.program.files.empty();
}

// Local time, to the minute.
std::string now() {
  return fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(std::time(nullptr)));
}

// Finds places in one program by points of the plan's motion and by positions on the part.
class Places {
public:
  Places(const PlanResult& result, const CheckedProgram& checked)
      : plan_(*result.job.toolPlan), whole_(*result.job.trajectory), cell_(*result.cell),
        checked_(checked), resumedAt_(result.job.resumedAt) {}

  // `point` counts from the start of the programs' own motion.
  ProofPlace ofPoint(std::size_t point) const { return at(resumedAt_ + point); }

  // Returns the place of the nearest waypoint.
  ProofPlace near(const std::optional<Eigen::Vector3d>& position) const {
    if (!position)
      return {};
    double minimum = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < plan_.waypointCount(); ++i)
      if (const double far = (plan_.position[i] - *position).squaredNorm(); far < minimum) {
        minimum = far;
        nearest = i;
      }
    const auto point = std::ranges::find(whole_.waypoint, nearest);
    ProofPlace place;
    if (point != whole_.waypoint.end())
      place = at(static_cast<std::size_t>(point - whole_.waypoint.begin()));
    place.at = position;
    return place;
  }

private:
  ProofPlace at(std::size_t point) const {
    ProofPlace place;
    const robot::JointVector joints =
        Eigen::Map<const robot::JointVector>(whole_.at(point), whole_.dof);
    place.at = cell_.work_T_tool(joints).translation();
    place.layer = layerOf(point);
    if (point < resumedAt_) // printed by an earlier program
      return place;
    place.atS = whole_.timeS[point] - whole_.timeS[resumedAt_];
    const TextLine line = checked_.pointLines[point];
    if (line.line > 0 && line.file < checked_.program.files.size()) {
      place.file = writtenName(checked_, checked_.program.files[line.file]);
      place.line = line.line;
    }
    return place;
  }

  // Returns the layer of the bead printed at the point, or of the last one before it.
  int layerOf(std::size_t point) const {
    for (std::size_t i = point + 1; i-- > 0;)
      if (const std::size_t waypoint = whole_.waypoint[i]; waypoint != plan::kNoWaypoint) {
        const auto path =
            std::ranges::upper_bound(plan_.paths, waypoint, {}, &plan::ToolPath::first);
        return path == plan_.paths.begin() ? 0 : std::prev(path)->layer + 1;
      }
    return 0;
  }

  const plan::ToolPlan& plan_;
  const plan::Trajectory& whole_;
  const robot::Cell& cell_;
  const CheckedProgram& checked_;
  std::size_t resumedAt_;
};

void putMargins(Proof& proof, const PlanResult& result, const Measured& measured,
                const Places& places) {
  const project::MotionReport& motion = result.job.report.motion;
  const plan::Trajectory& t = measured.trajectory;
  const auto closest = std::ranges::lower_bound(t.timeS, motion.minClearanceAtS) - t.timeS.begin();
  proof.clearance = {
      motion.minClearanceMm,
      places.ofPoint(std::min(static_cast<std::size_t>(closest), t.pointCount() - 1))};
  const int arm = result.cell->armDof();
  for (std::size_t j = 0; j < measured.margins.joints.size(); ++j) {
    const motion::LimitMargin& margin = measured.margins.joints[j];
    const motion::SpeedUse& speed = measured.margins.speeds[j];
    const int external = static_cast<int>(j) - arm;
    const robot::JointKind kind = result.cell->limits()[j].kind;
    proof.joints.push_back(
        {external < 0 ? std::to_string(j + 1)
                      : result.cell->externalAxes()[static_cast<std::size_t>(external)].name,
         kind == robot::JointKind::Sliding,
         {robot::shownValue(kind, margin.rad), places.ofPoint(margin.point)},
         {speed.share, places.ofPoint(speed.point)}});
  }
  proof.isotropy = {measured.margins.isotropy, places.ofPoint(measured.margins.isotropyPoint)};
}

// Returns "kitten.stl", or "2 x kitten.stl, spot.stl" for several items.
std::string partNames(const project::Job& job) {
  std::vector<std::pair<std::string, int>> counts;
  for (const project::JobItem& item : job.items) {
    const auto known =
        std::ranges::find(counts, item.partName, &std::pair<std::string, int>::first);
    if (known == counts.end())
      counts.emplace_back(item.partName, 1);
    else
      ++known->second;
  }
  std::string names;
  for (const auto& [name, count] : counts)
    names += (names.empty() ? "" : ", ") + (count > 1 ? std::to_string(count) + " x " : "") + name;
  return names;
}

base::Text modeLabel(const project::Job& job) {
  const std::string& first = job.choices.item().mode;
  const bool same = std::ranges::all_of(
      job.choices.items, [&](const project::ItemChoices& item) { return item.mode == first; });
  return same ? modes::findMode(first).label : "different for each part"_text;
}

int layersOf(const project::Report& report) {
  int layers = 0;
  for (const project::ItemReport& item : report.items)
    layers += item.layers.count;
  return layers;
}

void putTools(Proof& proof, const process::Tooling& tooling, const plan::Trajectory& trajectory) {
  proof.massG = tooling.printedG(trajectory);
  if (tooling.tools().size() == 1)
    return;
  const std::vector<process::ToolUse> uses = tooling.usesOf(trajectory);
  for (std::size_t tool = 0; tool < uses.size(); ++tool) {
    const process::Process& process = tooling.tools()[tool].process;
    const double gPerMm3 = 1e-3 * process.material.densityGPerCm3;
    proof.tools.push_back({process.id, process.material.label, gPerMm3 * uses[tool].printedMm3,
                           gPerMm3 * uses[tool].purgedMm3});
  }
  proof.toolChanges = static_cast<std::size_t>(std::ranges::count(
      trajectory.events, plan::EventKind::ToolChange, &plan::TrajectoryEvent::kind));
}

Proof proofOf(const CheckedProgram& checked, const PlanResult& result, const Measured& measured) {
  Proof proof;
  proof.part = partNames(result.job);
  proof.format = checked.program.format;
  proof.foreign = checked.program.foreign;
  proof.rest = result.job.resumedAt > 0;
  proof.printed = measured.printed;
  for (const plan::ProgramFile& file : checked.program.files)
    proof.files.push_back({writtenName(checked, file), base::sha256(file.text), file.text.size()});
  proof.date = now();
  proof.version = project::kVersion;
  proof.robot = result.cell->robot().label;
  proof.cell = result.cell->label();
  proof.mode = modeLabel(result.job);
  proof.choices = reportedChoices(result.job);
  proof.process = result.tooling().first().process;
  proof.sizeMm = geometry::bounds(*project::printedOf(result.job)).sizes();
  proof.layers = layersOf(result.job.report);
  proof.verdict = checked.verdict;
  proof.decision = verdictOf(checked, result.job.report);
  for (const plan::Finding& finding : blockersOf(result.job.report, checked.program.format))
    if (formatOf(finding).empty()) { // the program's own are among the checks
      ProofPlace place;
      place.at = finding.where;
      place.atS = finding.whenS.value_or(-1.0);
      proof.blockers.push_back({plan::reasonOf(finding), plan::blocksRunning(finding), place});
    }
  proof.deviations = checked.deviations;
  proof.plannedS = result.job.report.motion.durationS;
  proof.programS = checked.verdict.controllerDurationS;
  proof.materialMm3 = measured.trajectory.extrudedMm3.back();
  putTools(proof, result.tooling(), measured.trajectory);
  const Places places(result, checked);
  proof.armChecked = checked.armChecked;
  if (proof.armChecked)
    putMargins(proof, result, measured, places);
  proof.gap = places.near(checked.worst.gap);
  proof.thin = places.near(checked.worst.thin);
  proof.overfill = places.near(checked.worst.overfill);
  proof.unsupported = places.near(checked.worst.unsupported);
  proof.halfCarried = places.near(checked.worst.halfCarried);
  proof.longestUnsupported = places.near(checked.worst.longestUnsupported);
  proof.deviation = places.near(checked.worst.deviation);
  proof.flowError = places.near(checked.worst.flowError);
  proof.layerTime = places.near(checked.worst.layerTime);
  proof.minLayerTimeS = motion::layerTimes(result.resolved().values).minS;
  proof.fill = measured.fill;
  return proof;
}

Json placeJson(const ProofPlace& place) {
  Json json{{"file", place.file}, {"line", place.line}, {"atS", place.atS}};
  if (place.at)
    json["atMm"] = {place.at->x(), place.at->y(), place.at->z()};
  if (place.layer > 0)
    json["layer"] = place.layer;
  return json;
}

Json valueJson(const ProofValue& value, const char* key) {
  Json json{{key, value.value}};
  json.update(placeJson(value.place));
  return json;
}

Json replayJson(const Proof& proof) {
  const project::ReplayReport& v = proof.verdict;
  Json blockers = Json::array();
  for (const Proof::Blocker& blocker : proof.blockers)
    blockers.push_back(base::english(blocker.reason));
  return Json{{"verdict", verdictId(proof.decision)},
              {"passed", v.passed},
              {"safeToRun", v.safeToRun && proof.decision != PlanVerdict::Unchecked},
              {"quality", v.thresholds.quality},
              {"accepted", v.thresholds.accepted},
              {"planPassed", proof.decision == PlanVerdict::Passed},
              {"blocking", std::move(blockers)},
              {"coveredFraction", v.coveredFraction},
              {"thinFraction", v.thinFraction},
              {"thinMm3", v.thinMm3},
              {"unsupportedFraction", v.unsupportedFraction},
              {"halfCarriedFraction", v.halfCarriedFraction},
              {"longestUnsupportedMm", v.longestUnsupportedMm},
              {"overfillFraction", v.overfillFraction},
              {"massRatio", v.massRatio},
              {"collisions", v.collisions},
              {"limitViolations", v.limitViolations},
              {"maxDeviationMm", v.maxDeviationMm},
              {"flowErrorFraction", v.flowErrorFraction},
              {"textDeviations", proof.deviations}};
}

// Bead length by the time after which a bead covers the one below; the last class is open.
Json layerTimesJson(const project::ReplayReport& verdict) {
  return Json{{"shortestS", verdict.shortestLayerTimeS},
              {"meanS", verdict.meanLayerTimeS},
              {"longestS", verdict.longestLayerTimeS},
              {"classesS", replay::kLayerTimeClassesS},
              {"lengthMm", verdict.layerTimesMm}};
}

// Placeholder for the shares, which are inserted as one line instead of thousands.
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

std::vector<page::Picture> picturesOf(const project::Job& job, const ProofStyle& style) {
  if (!style.pictures)
    return {};
  const base::Text captions[] = {"the part"_text, "the part as printed, every bead laid"_text};
  std::vector<page::Picture> pictures;
  for (std::string& png : style.pictures(job))
    if (pictures.size() < std::size(captions))
      pictures.push_back({std::move(png), style.language->sentence(captions[pictures.size()], {})});
  return pictures;
}

void writeProof(const Proof& proof, const std::vector<page::Picture>& pictures,
                const std::filesystem::path& file, const ProofStyle& style) {
  page::Sheet sheet = proofSheet(proof, *style.language);
  sheet.language = style.languageCode;
  sheet.pictures = pictures;
  base::writeFile(file.string() + ".json", proofJson(proof));
  base::writeFile(file.string() + ".html", page::html(sheet));
  base::writeFile(file.string() + ".pdf", page::pdf(sheet));
}

} // namespace

std::string proofName(const CheckedProgram& program) {
  return writtenName(program, program.program.files.front()) + ".proof";
}

std::string proofJson(const Proof& proof) {
  Json files = Json::array(), joints = Json::array(), speeds = Json::array();
  for (const Proof::File& file : proof.files)
    files.push_back({{"name", file.name}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  for (const Proof::Joint& joint : proof.joints) {
    Json row = valueJson(joint.margin, joint.slides ? "marginMm" : "marginDeg");
    row["joint"] = joint.name;
    joints.push_back(std::move(row));
    Json speed = valueJson(joint.speed, "shareOfLimit");
    speed["joint"] = joint.name;
    speeds.push_back(std::move(speed));
  }
  Json tools = Json::array();
  for (const Proof::Tool& tool : proof.tools)
    tools.push_back({{"process", tool.process},
                     {"material", tool.material},
                     {"printedG", tool.printedG},
                     {"purgedG", tool.purgedG}});
  Json json{{"part", proof.part},
            {"format", proof.format},
            {"foreign", proof.foreign},
            {"date", proof.date},
            {"voluta", proof.version},
            {"robot", proof.robot},
            {"cell", proof.cell},
            {"process", proof.process.id},
            {"preset", {{"name", proof.choices.preset}, {"changed", proof.choices.changed}}},
            {"pauses", proof.choices.pauses},
            {"files", std::move(files)},
            {"durationS", {{"planned", proof.plannedS}, {"program", proof.programS}}},
            {"material", proof.process.material.label},
            {"materialMm3", proof.materialMm3},
            {"massG", proof.massG},
            {"replay", replayJson(proof)},
            {"armChecked", proof.armChecked},
            {"worst",
             {{"coveredFraction", placeJson(proof.gap)},
              {"thinFraction", placeJson(proof.thin)},
              {"overfillFraction", placeJson(proof.overfill)},
              {"unsupportedFraction", placeJson(proof.unsupported)},
              {"halfCarriedFraction", placeJson(proof.halfCarried)},
              {"longestUnsupportedMm", placeJson(proof.longestUnsupported)},
              {"maxDeviationMm", placeJson(proof.deviation)},
              {"flowErrorFraction", placeJson(proof.flowError)},
              {"shortestLayerTimeS", placeJson(proof.layerTime)}}},
            {"layerTimes", layerTimesJson(proof.verdict)},
            {"leastClearance", valueJson(proof.clearance, "mm")},
            {"jointLimits", std::move(joints)},
            {"jointSpeeds", std::move(speeds)},
            {"singularity", valueJson(proof.isotropy, "isotropy")},
            {"fillMap", fillJson(proof.fill)},
            {"printedMesh", proof.printed}};
  if (!proof.tools.empty()) {
    json["tools"] = std::move(tools);
    json["toolChanges"] = proof.toolChanges;
  }
  if (!proof.armChecked)
    for (const char* key : {"leastClearance", "jointLimits", "jointSpeeds", "singularity"})
      json.erase(key);
  std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace);
  const std::string mark = std::string("\"") + kFilled + "\"";
  return text.replace(text.rfind(mark), mark.size(), filledJson(proof.fill)) + "\n";
}

std::vector<std::string> proofNames(const PlanResult& result, const Programs& programs) {
  std::vector<std::string> names;
  for (const auto& checked : programs)
    if (isProved(*checked))
      for (const char* ending : {".html", ".pdf", ".json"})
        names.push_back(proofName(*checked) + ending);
  if (!names.empty())
    names.push_back(printedName(result));
  return names;
}

void writeProofs(const PlanResult& result, const Programs& programs,
                 const std::filesystem::path& folder, const base::RunContext& ctx,
                 const ProofStyle& style, const std::function<void()>& meanwhile) {
  if (proofNames(result, programs).empty() || !result.job.trajectory || !result.cell)
    return meanwhile();
  const plan::ToolPlan& plan = *result.job.toolPlan;
  const plan::Trajectory& whole = *result.job.trajectory;
  const collision::GrowingPart growing(plan, collision::growingPitch(plan, result.tooling()), ctx);
  Measured measured;
  measured.trajectory = motion::partOf(whole, result.job.resumedAt, whole.pointCount());
  measured.printed = printedName(result);
  const auto printed = project::printedOf(result.job);
  sideBySide(ctx,
             {[&] { measured.margins = motion::marginsOf(measured.trajectory, *result.cell, ctx); },
              [&] {
                measured.fill =
                    fillMap(*printed, project::firstTriangles(result.job), plan, growing, ctx);
              },
              [&] { measured.pictures = picturesOf(result.job, style); },
              [&] {
                base::writeFile(
                    folder / measured.printed,
                    geometry::writeStl(printedSolid(plan, result.tooling().first().process, ctx)));
              },
              meanwhile});
  std::vector<std::function<void()>> proofs;
  for (const auto& checked : programs)
    if (isProved(*checked))
      proofs.push_back([&] {
        writeProof(proofOf(*checked, result, measured), measured.pictures,
                   folder / proofName(*checked), style);
      });
  sideBySide(ctx, proofs);
}

} // namespace voluta::pipeline
