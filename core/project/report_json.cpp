#include "project/message_json.h"
#include "project/report.h"
#include "project/version.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace voluta::project {

namespace {
using Json = nlohmann::ordered_json;

Json pointJson(const Eigen::Vector3d& p) {
  return Json::array({p.x(), p.y(), p.z()});
}

Json boundsJson(const Eigen::AlignedBox3d& box) {
  if (box.isEmpty())
    return Json::array({pointJson(Eigen::Vector3d::Zero()), pointJson(Eigen::Vector3d::Zero())});
  return Json::array({pointJson(box.min()), pointJson(box.max())});
}

Json modelJson(const ModelReport& m) {
  return Json{{"file", m.file},
              {"scale", m.scale},
              {"triangles", m.triangles},
              {"watertight", m.watertight},
              {"volumeMm3", m.volumeMm3},
              {"boundsMm", boundsJson(m.boundsMm)},
              {"repairs", base::english(m.repairs)}};
}

Json piecesJson(const std::vector<PieceReport>& pieces) {
  Json list = Json::array();
  for (const PieceReport& p : pieces)
    list.push_back(Json{{"parent", p.parent},
                        {"volumeMm3", p.volumeMm3},
                        {"riskyAreaMm2", p.riskyAreaMm2},
                        {"direction", pointJson(p.direction)},
                        {"material", p.material}});
  return list;
}

Json decompositionJson(const DecompositionReport& d) {
  return Json{{"mode", d.mode},
              {"growth", d.growth},
              {"voxelMm", d.voxelMm},
              {"voxels", d.voxels},
              {"layers", d.layers},
              {"missedVoxels", d.missedVoxels},
              {"shadowedVoxels", d.shadowedVoxels},
              {"unreachedVoxels", d.unreachedVoxels},
              {"missedAfterSupports", d.missedAfterSupports},
              {"supportVolumeMm3", d.supportVolumeMm3},
              {"pieces", d.pieces},
              {"riskyAreaMm2", d.riskyAreaMm2},
              {"riskyAreaBeforeMm2", d.riskyAreaBeforeMm2},
              {"pieceList", piecesJson(d.pieceList)}};
}

Json layersJson(const LayersReport& l) {
  return Json{{"count", l.count},
              {"areaMm2", l.areaMm2},
              {"thicknessMeanMm", l.thicknessMeanMm},
              {"thicknessStdMm", l.thicknessStdMm},
              {"thicknessP01Mm", l.thicknessP01Mm},
              {"thicknessP99Mm", l.thicknessP99Mm},
              {"withinLimitsFraction", l.withinLimitsFraction}};
}

Json toolpathJson(const ToolpathReport& t) {
  return Json{{"paths", t.paths},
              {"waypoints", t.waypoints},
              {"lengthMm", t.lengthMm},
              {"travelMm", t.travelMm},
              {"starts", t.starts},
              {"simpleRegions", t.simpleRegions},
              {"coveredFraction", t.coveredFraction},
              {"overlapFraction", t.overlapFraction},
              {"gouges", t.gouges},
              {"maxTurnDeg", t.maxTurnDeg},
              {"materialMm3", t.materialMm3}};
}

Json motionJson(const MotionReport& m) {
  return Json{{"robot", m.robot},
              {"cell", m.cell},
              {"waypoints", m.waypoints},
              {"unreachable", m.unreachable},
              {"collisions", m.collisions},
              {"splits", m.splits},
              {"maxJerk", m.maxJerk},
              {"sumSquaredJerk", m.sumSquaredJerk},
              {"sumSquaredJerkBefore", m.sumSquaredJerkBefore},
              {"minClearanceMm", m.minClearanceMm},
              {"durationS", m.durationS}};
}

Json programsJson(const std::vector<ProgramReport>& programs) {
  Json list = Json::array();
  for (const ProgramReport& p : programs)
    list.push_back(Json{{"format", p.format},
                        {"foreign", p.foreign},
                        {"files", p.files},
                        {"bytes", p.bytes},
                        {"maxDeviationMm", p.maxDeviationMm},
                        {"maxDeviationRad", p.maxDeviationRad}});
  return list;
}

Json replayJson(const ReplayReport& r) {
  return Json{{"passed", r.passed},
              {"coveredFraction", r.coveredFraction},
              {"unsupportedFraction", r.unsupportedFraction},
              {"overfillFraction", r.overfillFraction},
              {"massRatio", r.massRatio},
              {"collisions", r.collisions},
              {"limitViolations", r.limitViolations},
              {"maxDeviationMm", r.maxDeviationMm},
              {"thresholds", Json{{"covered", r.thresholds.covered},
                                  {"unsupported", r.thresholds.unsupported},
                                  {"overfill", r.thresholds.overfill},
                                  {"mass", r.thresholds.mass},
                                  {"collisions", r.thresholds.collisions},
                                  {"limitViolations", r.thresholds.limitViolations},
                                  {"deviationMm", r.thresholds.deviationMm}}}};
}

Json timingsJson(const Timings& t) {
  Json all;
  for (const TimingName& row : kTimingNames)
    all[row.key] = t.*row.seconds;
  return all;
}
} // namespace

Timings& Timings::operator+=(const Timings& more) {
  for (const TimingName& row : kTimingNames)
    this->*row.seconds += more.*row.seconds;
  return *this;
}

std::string reportJson(const Report& report) {
  Json findings = Json::array();
  for (const plan::Finding& f : report.findings)
    findings.push_back(findingJson(f));
  const Json all{{"model", modelJson(report.model)},
                 {"decomposition", decompositionJson(report.decomposition)},
                 {"layers", layersJson(report.layers)},
                 {"toolpath", toolpathJson(report.toolpath)},
                 {"motion", motionJson(report.motion)},
                 {"programs", programsJson(report.programs)},
                 {"replay", replayJson(report.replay)},
                 {"findings", findings},
                 {"timingS", timingsJson(report.timings)},
                 {"peakRssMb", report.peakRssMb},
                 {"threads", report.threads},
                 {"version", kVersion}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace voluta::project
