#include "base/error.h"
#include "project/message_json.h"
#include "project/report.h"

#include <limits>
#include <nlohmann/json.hpp>

namespace voluta::project {

namespace {
using Json = nlohmann::ordered_json;

// JSON has no NaN: it was written as null.
void get(const Json& j, const char* key, double& value) {
  const Json& found = j.at(key);
  value = found.is_null() ? std::numeric_limits<double>::quiet_NaN() : found.get<double>();
}
template <typename T> void get(const Json& j, const char* key, T& value) {
  j.at(key).get_to(value);
}

Eigen::Vector3d point(const Json& j) {
  return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}

void read(const Json& j, ModelReport& m) {
  get(j, "file", m.file);
  get(j, "scale", m.scale);
  get(j, "triangles", m.triangles);
  get(j, "watertight", m.watertight);
  get(j, "volumeMm3", m.volumeMm3);
  const Json& box = j.at("boundsMm");
  m.boundsMm = Eigen::AlignedBox3d(point(box.at(0)), point(box.at(1)));
  m.repairs = readMessages(j.at("repairs"));
}

void read(const Json& j, DecompositionReport& d) {
  get(j, "mode", d.mode);
  get(j, "growth", d.growth);
  get(j, "voxelMm", d.voxelMm);
  get(j, "voxels", d.voxels);
  get(j, "layers", d.layers);
  get(j, "missedVoxels", d.missedVoxels);
  get(j, "shadowedVoxels", d.shadowedVoxels);
  get(j, "unreachedVoxels", d.unreachedVoxels);
  get(j, "missedAfterSupports", d.missedAfterSupports);
  get(j, "supportVolumeMm3", d.supportVolumeMm3);
  get(j, "pieces", d.pieces);
  get(j, "riskyAreaMm2", d.riskyAreaMm2);
  get(j, "riskyAreaBeforeMm2", d.riskyAreaBeforeMm2);
  // Reports of before there were pieces have none.
  for (const Json& row : j.value("pieceList", Json::array())) {
    PieceReport p;
    get(row, "parent", p.parent);
    get(row, "volumeMm3", p.volumeMm3);
    get(row, "riskyAreaMm2", p.riskyAreaMm2);
    p.direction = point(row.at("direction"));
    get(row, "material", p.material);
    d.pieceList.push_back(std::move(p));
  }
}

void read(const Json& j, LayersReport& l) {
  get(j, "count", l.count);
  get(j, "areaMm2", l.areaMm2);
  get(j, "thicknessMeanMm", l.thicknessMeanMm);
  get(j, "thicknessStdMm", l.thicknessStdMm);
  get(j, "thicknessP01Mm", l.thicknessP01Mm);
  get(j, "thicknessP99Mm", l.thicknessP99Mm);
  get(j, "withinLimitsFraction", l.withinLimitsFraction);
}

void read(const Json& j, ToolpathReport& t) {
  get(j, "paths", t.paths);
  get(j, "waypoints", t.waypoints);
  get(j, "lengthMm", t.lengthMm);
  get(j, "travelMm", t.travelMm);
  get(j, "starts", t.starts);
  get(j, "simpleRegions", t.simpleRegions);
  get(j, "coveredFraction", t.coveredFraction);
  get(j, "overlapFraction", t.overlapFraction);
  get(j, "gouges", t.gouges);
  get(j, "maxTurnDeg", t.maxTurnDeg);
  get(j, "materialMm3", t.materialMm3);
}

void read(const Json& j, MotionReport& m) {
  get(j, "robot", m.robot);
  get(j, "cell", m.cell);
  get(j, "waypoints", m.waypoints);
  get(j, "unreachable", m.unreachable);
  get(j, "collisions", m.collisions);
  get(j, "splits", m.splits);
  get(j, "maxJerk", m.maxJerk);
  get(j, "sumSquaredJerk", m.sumSquaredJerk);
  get(j, "sumSquaredJerkBefore", m.sumSquaredJerkBefore);
  get(j, "minClearanceMm", m.minClearanceMm);
  get(j, "durationS", m.durationS);
}

ProgramReport program(const Json& j) {
  ProgramReport p;
  get(j, "format", p.format);
  get(j, "foreign", p.foreign);
  get(j, "files", p.files);
  get(j, "bytes", p.bytes);
  get(j, "maxDeviationMm", p.maxDeviationMm);
  get(j, "maxDeviationRad", p.maxDeviationRad);
  return p;
}

void read(const Json& j, ReplayReport& r) {
  get(j, "passed", r.passed);
  get(j, "coveredFraction", r.coveredFraction);
  get(j, "unsupportedFraction", r.unsupportedFraction);
  get(j, "overfillFraction", r.overfillFraction);
  get(j, "massRatio", r.massRatio);
  get(j, "collisions", r.collisions);
  get(j, "limitViolations", r.limitViolations);
  get(j, "maxDeviationMm", r.maxDeviationMm);
  const Json& t = j.at("thresholds");
  get(t, "covered", r.thresholds.covered);
  get(t, "unsupported", r.thresholds.unsupported);
  get(t, "overfill", r.thresholds.overfill);
  get(t, "mass", r.thresholds.mass);
  get(t, "collisions", r.thresholds.collisions);
  get(t, "limitViolations", r.thresholds.limitViolations);
  get(t, "deviationMm", r.thresholds.deviationMm);
}

void read(const Json& j, Timings& t) {
  for (const TimingName& row : kTimingNames)
    get(j, row.key, t.*row.seconds);
}
} // namespace

Report readReportJson(const std::string& text) {
  Report report;
  try {
    const Json j = Json::parse(text);
    read(j.at("model"), report.model);
    read(j.at("decomposition"), report.decomposition);
    read(j.at("layers"), report.layers);
    read(j.at("toolpath"), report.toolpath);
    read(j.at("motion"), report.motion);
    for (const Json& row : j.at("programs"))
      report.programs.push_back(program(row));
    read(j.at("replay"), report.replay);
    for (const Json& row : j.at("findings"))
      report.findings.push_back(readFinding(row));
    read(j.at("timingS"), report.timings);
    get(j, "peakRssMb", report.peakRssMb);
    get(j, "threads", report.threads);
  } catch (const Json::exception& e) {
    throw base::Error(
        base::ErrorCode::UnreadableFile,
        base::message("the report is not one of a plan: {why}"_text, std::string(e.what())));
  }
  return report;
}

} // namespace voluta::project
