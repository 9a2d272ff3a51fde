// The figures of a report, each declared once: its key, its member, its unit. Writing, reading and
// comparing report.json use these lists. Keys are added, never renamed.
#pragma once

#include "project/report.h"

#include <string_view>
#include <tuple>
#include <type_traits>

namespace voluta::project {

template <typename R, typename T> struct Field {
  const char* key;
  T R::*member;
  std::string_view unit = {}; // "%" for fractions of 1; empty: a count or a text
  bool later = false;         // true: missing in older reports
};
template <typename R, typename T> Field(const char*, T R::*) -> Field<R, T>;
template <typename R, typename T> Field(const char*, T R::*, const char*) -> Field<R, T>;
template <typename R, typename T> Field(const char*, T R::*, const char*, bool) -> Field<R, T>;

constexpr auto fieldsOf(std::type_identity<ModelReport>) {
  using R = ModelReport;
  return std::tuple{Field{"file", &R::file},
                    Field{"scale", &R::scale},
                    Field{"triangles", &R::triangles},
                    Field{"watertight", &R::watertight},
                    Field{"volumeMm3", &R::volumeMm3, "mm³"},
                    Field{"boundsMm", &R::boundsMm},
                    Field{"repairs", &R::repairs}};
}
constexpr auto fieldsOf(std::type_identity<PieceReport>) {
  using R = PieceReport;
  return std::tuple{Field{"parent", &R::parent}, Field{"volumeMm3", &R::volumeMm3, "mm³"},
                    Field{"riskyAreaMm2", &R::riskyAreaMm2, "mm²"},
                    Field{"direction", &R::direction}, Field{"material", &R::material}};
}
constexpr auto fieldsOf(std::type_identity<DecompositionReport>) {
  using R = DecompositionReport;
  return std::tuple{Field{"mode", &R::mode},
                    Field{"growth", &R::growth},
                    Field{"voxelMm", &R::voxelMm, "mm"},
                    Field{"voxels", &R::voxels},
                    Field{"layers", &R::layers},
                    Field{"missedVoxels", &R::missedVoxels},
                    Field{"shadowedVoxels", &R::shadowedVoxels},
                    Field{"unreachedVoxels", &R::unreachedVoxels},
                    Field{"missedAfterSupports", &R::missedAfterSupports},
                    Field{"supportVolumeMm3", &R::supportVolumeMm3, "mm³"},
                    Field{"pieces", &R::pieces},
                    Field{"riskyAreaMm2", &R::riskyAreaMm2, "mm²"},
                    Field{"riskyAreaBeforeMm2", &R::riskyAreaBeforeMm2, "mm²"},
                    Field{"pieceList", &R::pieceList, "", true}};
}
constexpr auto fieldsOf(std::type_identity<plan::RegionStatistics>) {
  using R = plan::RegionStatistics;
  return std::tuple{Field{"region", &R::region},
                    Field{"use", &R::use},
                    Field{"patches", &R::patches},
                    Field{"volumeMm3", &R::volumeMm3, "mm³"},
                    Field{"stepMeanMm", &R::stepMeanMm, "mm"},
                    Field{"stepMaxMm", &R::stepMaxMm, "mm"}};
}
constexpr auto fieldsOf(std::type_identity<plan::LayerStatistics>) {
  using R = plan::LayerStatistics;
  return std::tuple{Field{"count", &R::count},
                    Field{"areaMm2", &R::areaMm2, "mm²"},
                    Field{"thicknessMeanMm", &R::thicknessMeanMm, "mm"},
                    Field{"thicknessStdMm", &R::thicknessStdMm, "mm"},
                    Field{"thicknessP01Mm", &R::thicknessP01Mm, "mm"},
                    Field{"thicknessP99Mm", &R::thicknessP99Mm, "mm"},
                    Field{"withinLimitsFraction", &R::withinLimitsFraction, "%"},
                    Field{"stepMeanMm", &R::stepMeanMm, "mm", true},
                    Field{"stepMaxMm", &R::stepMaxMm, "mm", true},
                    Field{"regions", &R::regions, "", true}};
}
constexpr auto fieldsOf(std::type_identity<plan::StrengthStatistics>) {
  using R = plan::StrengthStatistics;
  return std::tuple{Field{"angleMeanDeg", &R::angleMeanDeg, "deg"},
                    Field{"alignedFraction", &R::alignedFraction, "%"},
                    Field{"interfaceMm2", &R::interfaceMm2, "mm²"},
                    Field{"interfaceFraction", &R::interfaceFraction, "%"},
                    Field{"leastSectionMm2", &R::minSectionMm2, "mm²"},
                    Field{"leastSectionAtMm", &R::minSectionAtMm, "mm"},
                    Field{"mostInterfaceFraction", &R::maxInterfaceFraction, "%"},
                    Field{"mostInterfaceAtMm", &R::maxInterfaceAtMm, "mm"}};
}
constexpr auto fieldsOf(std::type_identity<plan::LoadStatistics>) {
  using R = plan::LoadStatistics;
  return std::tuple{Field{"forceN", &R::forceN, "N"},
                    Field{"angleMeanDeg", &R::angleMeanDeg, "deg"},
                    Field{"alignedFraction", &R::alignedFraction, "%"},
                    Field{"infillAlignedFraction", &R::infillAlignedFraction, "%"},
                    Field{"stiffnessNPerMm", &R::stiffnessNPerMm, "N/mm"},
                    Field{"acrossBeadsMPa", &R::acrossBeadsMPa, "MPa"},
                    Field{"acrossLayersMPa", &R::acrossLayersMPa, "MPa"}};
}
constexpr auto fieldsOf(std::type_identity<plan::ToolpathStatistics>) {
  using R = plan::ToolpathStatistics;
  return std::tuple{Field{"paths", &R::paths},
                    Field{"waypoints", &R::waypoints},
                    Field{"lengthMm", &R::lengthMm, "mm"},
                    Field{"travelMm", &R::travelMm, "mm"},
                    Field{"starts", &R::starts},
                    Field{"simpleRegions", &R::simpleRegions},
                    Field{"coveredFraction", &R::coveredFraction, "%"},
                    Field{"overlapFraction", &R::overlapFraction, "%"},
                    Field{"gouges", &R::gouges},
                    Field{"maxTurnDeg", &R::maxRotationDeg, "deg"},
                    Field{"materialMm3", &R::materialMm3, "mm³"},
                    Field{"sparseMm3", &R::sparseMm3, "mm³", true},
                    Field{"sparseBeadMm3", &R::sparseBeadMm3, "mm³", true},
                    Field{"tapes", &R::tapes, "", true},
                    Field{"tapeMm", &R::tapeMm, "mm", true},
                    Field{"tapeG", &R::tapeG, "g", true},
                    Field{"tapeCoveredFraction", &R::tapeCoveredFraction, "%", true},
                    Field{"tapeOverlapFraction", &R::tapeOverlapFraction, "%", true},
                    Field{"tapeBareMm", &R::tapeBareMm, "mm", true},
                    Field{"shots", &R::shots, "", true},
                    Field{"shotMm3", &R::shotMm3, "mm³", true},
                    Field{"items", &R::items, "", true},
                    Field{"strength", &R::strength, "", true},
                    Field{"load", &R::load, "", true}};
}
constexpr auto fieldsOf(std::type_identity<plan::ItemToolpaths>) {
  using R = plan::ItemToolpaths;
  return std::tuple{Field{"paths", &R::paths}, Field{"lengthMm", &R::lengthMm, "mm"},
                    Field{"materialMm3", &R::materialMm3, "mm³"}};
}
constexpr auto fieldsOf(std::type_identity<plan::MotionStatistics>) {
  using R = plan::MotionStatistics;
  return std::tuple{Field{"waypoints", &R::waypoints},
                    Field{"unreachable", &R::unreachable},
                    Field{"collisions", &R::collisions},
                    Field{"splits", &R::splits},
                    Field{"maxJerk", &R::maxJerk},
                    Field{"sumSquaredJerk", &R::sumSquaredJerk},
                    Field{"sumSquaredJerkBefore", &R::sumSquaredJerkBefore},
                    Field{"maxJerkBefore", &R::maxJerkBefore, "", true},
                    Field{"maxJerkAtS", &R::maxJerkAtS, "s", true},
                    Field{"maxTravelJerk", &R::maxTravelJerk, "", true},
                    Field{"maxTravelJerkAtS", &R::maxTravelJerkAtS, "s", true},
                    Field{"jerkSlowedS", &R::jerkSlowedS, "s", true},
                    Field{"minClearanceMm", &R::minClearanceMm, "mm"},
                    Field{"minClearanceAtS", &R::minClearanceAtS, "s", true},
                    Field{"durationS", &R::durationS, "s"},
                    Field{"toolChanges", &R::toolChanges, "", true},
                    Field{"waits", &R::waits, "", true},
                    Field{"waitS", &R::waitS, "s", true}};
}
constexpr auto fieldsOf(std::type_identity<MotionReport>) {
  using R = MotionReport;
  return std::tuple_cat(std::tuple{Field{"robot", &R::robot}, Field{"cell", &R::cell}},
                        fieldsOf(std::type_identity<plan::MotionStatistics>{}));
}
constexpr auto fieldsOf(std::type_identity<ProgramReport>) {
  using R = ProgramReport;
  return std::tuple{Field{"format", &R::format},
                    Field{"foreign", &R::foreign},
                    Field{"files", &R::files},
                    Field{"bytes", &R::bytes},
                    Field{"maxDeviationMm", &R::maxDeviationMm, "mm"},
                    Field{"maxDeviationRad", &R::maxDeviationRad, "rad"},
                    Field{"durationS", &R::durationS, "s", true},
                    Field{"flowErrorFraction", &R::flowErrorFraction, "%", true},
                    Field{"massRatio", &R::massRatio, "", true},
                    Field{"state", &R::state, "", true}};
}
constexpr auto fieldsOf(std::type_identity<VerdictReport>) {
  using R = VerdictReport;
  return std::tuple{Field{"verdict", &R::verdict, "", true},
                    Field{"safeToRun", &R::safeToRun, "", true},
                    Field{"printsAsAsked", &R::printsAsAsked, "", true}};
}
constexpr auto fieldsOf(std::type_identity<ThresholdsReport>) {
  using R = ThresholdsReport;
  return std::tuple{Field{"quality", &R::quality, "", true},
                    Field{"accepted", &R::accepted, "", true},
                    Field{"covered", &R::covered},
                    Field{"unsupported", &R::unsupported},
                    Field{"overfill", &R::overfill},
                    Field{"mass", &R::mass},
                    Field{"thin", &R::thin, "", true},
                    Field{"collisions", &R::collisions},
                    Field{"limitViolations", &R::limitViolations},
                    Field{"deviationMm", &R::deviationMm, "mm"},
                    Field{"flowError", &R::flowError, "", true}};
}
constexpr auto fieldsOf(std::type_identity<ReplayReport>) {
  using R = ReplayReport;
  return std::tuple{Field{"passed", &R::passed},
                    Field{"safeToRun", &R::safeToRun, "", true},
                    Field{"coveredFraction", &R::coveredFraction, "%"},
                    Field{"thinFraction", &R::thinFraction, "%", true},
                    Field{"thinMm3", &R::thinMm3, "mm³", true},
                    Field{"unsupportedFraction", &R::unsupportedFraction, "%"},
                    Field{"halfCarriedFraction", &R::halfCarriedFraction, "%", true},
                    Field{"longestUnsupportedMm", &R::longestUnsupportedMm, "mm", true},
                    Field{"overfillFraction", &R::overfillFraction, "%"},
                    Field{"massRatio", &R::massRatio},
                    Field{"collisions", &R::collisions},
                    Field{"limitViolations", &R::limitViolations},
                    Field{"maxDeviationMm", &R::maxDeviationMm, "mm"},
                    Field{"controllerDurationS", &R::controllerDurationS, "s", true},
                    Field{"flowErrorFraction", &R::flowErrorFraction, "%", true},
                    Field{"shortestLayerTimeS", &R::shortestLayerTimeS, "s", true},
                    Field{"meanLayerTimeS", &R::meanLayerTimeS, "s", true},
                    Field{"longestLayerTimeS", &R::longestLayerTimeS, "s", true},
                    Field{"layerTimesMm", &R::layerTimesMm, "mm", true},
                    Field{"tapeMm3", &R::tapeMm3, "mm³", true},
                    Field{"thresholds", &R::thresholds},
                    Field{"items", &R::items, "", true}};
}
constexpr auto fieldsOf(std::type_identity<ItemReplayReport>) {
  using R = ItemReplayReport;
  return std::tuple{Field{"coveredFraction", &R::coveredFraction, "%"},
                    Field{"unsupportedFraction", &R::unsupportedFraction, "%"},
                    Field{"massRatio", &R::massRatio},
                    Field{"thinFraction", &R::thinFraction, "%", true}};
}
constexpr auto fieldsOf(std::type_identity<TriedReport>) {
  using R = TriedReport;
  return std::tuple{Field{"way", &R::strategy, "", true},
                    Field{"name", &R::name, "", true},
                    Field{"mode", &R::mode},
                    Field{"platform", &R::platform},
                    Field{"passed", &R::passed, "", true},
                    Field{"taken", &R::taken, "", true},
                    Field{"why", &R::reason, "", true},
                    Field{"stage", &R::stage}};
}
constexpr auto fieldsOf(std::type_identity<ChosenReport>) {
  using R = ChosenReport;
  return std::tuple{
      Field{"way", &R::strategy},      Field{"name", &R::name},
      Field{"mode", &R::mode},         Field{"platform", &R::platform},
      Field{"supports", &R::supports}, Field{"layerHeightMm", &R::layerHeightMm, "mm"}};
}
constexpr auto fieldsOf(std::type_identity<Timings>) {
  using R = Timings;
  return std::tuple{Field{"load", &R::load, "s"},           Field{"repair", &R::repair, "s"},
                    Field{"voxelise", &R::voxelise, "s"},   Field{"peel", &R::peel, "s"},
                    Field{"grow", &R::grow, "s"},           Field{"smooth", &R::smooth, "s"},
                    Field{"extract", &R::extract, "s"},     Field{"trim", &R::trim, "s"},
                    Field{"decompose", &R::decompose, "s"}, Field{"toolpath", &R::toolpath, "s"},
                    Field{"orient", &R::orient, "s"},       Field{"ik", &R::ik, "s"},
                    Field{"graph", &R::graph, "s"},         Field{"jerk", &R::jerk, "s"},
                    Field{"collision", &R::collision, "s"}, Field{"transfer", &R::transfer, "s"},
                    Field{"write", &R::write, "s"},         Field{"replay", &R::replay, "s"},
                    Field{"total", &R::total, "s"}};
}
constexpr auto fieldsOf(std::type_identity<ItemReport>) {
  using R = ItemReport;
  return std::tuple{Field{"model", &R::model}, Field{"decomposition", &R::decomposition},
                    Field{"layers", &R::layers}, Field{"chosen", &R::chosen, "", true},
                    Field{"tried", &R::tried, "", true}};
}
// report.json has the fields of the first item beside these.
constexpr auto fieldsOf(std::type_identity<Report>) {
  using R = Report;
  return std::tuple_cat(fieldsOf(std::type_identity<VerdictReport>{}),
                        std::tuple{Field{"toolpath", &R::toolpath}, Field{"motion", &R::motion},
                                   Field{"programs", &R::programs}, Field{"replay", &R::replay},
                                   Field{"findings", &R::findings}, Field{"timingS", &R::timings},
                                   Field{"peakRssMb", &R::peakRssMb, "MB"},
                                   Field{"threads", &R::threads},
                                   Field{"items", &R::items, "", true}});
}

template <typename R>
concept HasFields = requires {
  fieldsOf(std::type_identity<R>{});
};

// Calls visit(field) for each field, in the order of the report.
template <HasFields R, typename Visit> constexpr void forEachField(const Visit& visit) {
  std::apply([&](const auto&... field) { (visit(field), ...); }, fieldsOf(std::type_identity<R>{}));
}

// Returns the unit of a listed figure.
template <HasFields R, typename T> constexpr std::string_view unitOf(T R::*member) {
  std::string_view unit;
  forEachField<R>([&](const auto& field) {
    if constexpr (std::is_same_v<decltype(field.member), T R::*>)
      if (field.member == member)
        unit = field.unit;
  });
  return unit;
}

} // namespace voluta::project
