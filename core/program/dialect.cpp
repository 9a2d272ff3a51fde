#include "program/dialect.h"

#include "base/error.h"
#include "base/nearest_name.h"
#include "program/bead_words.h"
#include "program/common/language_words.h"
#include "program/common/motion_targets.h"
#include "program/common/program_text.h"
#include "program/common/text_files.h"
#include "program/extruder.h"
#include "program/full_flow.h"
#include "program/gcode/extruder_axis.h"
#include "program/gcode/gcode_bc.h"
#include "program/gcode/gcode_extended.h"
#include "program/gcode/gcode_plain.h"
#include "program/krl/krl.h"
#include "program/krl/krl_eki.h"
#include "program/melfa/melfa.h"
#include "program/melfa/melfa_datalink.h"
#include "program/melfa/melfa_stream.h"
#include "program/melfa/mxt_packets.h"
#include "program/own_lines.h"
#include "program/rapid/rapid.h"
#include "program/rapid/rapid_motions.h"
#include "program/rapid/rapid_tokens.h"
#include "program/spel/spelplus.h"
#include "program/stream/extruder_stream.h"
#include "program/stream/joint_rows.h"
#include "program/stream/joint_table.h"
#include "program/stream/urscript_stream.h"
#include "program/tmscript/tmscript.h"
#include "program/urscript/urscript.h"

#include <algorithm>
#include <iterator>

namespace voluta::program {

namespace {
constexpr double kSameJointRad = 1e-5; // the precision with which joints are written
// For MELFA's controllers, whatever the source of their motions; three cycles of a CR750.
constexpr plan::TimeModel kMelfaTime = {
    .accelerationMmPerS2 = kMelfaMmPerS2, .jointAccelerationRadPerS2 = 20.0, .cycleS = 0.00711};
// Usual machine data of KUKA have 10 m/s2. The controller knows as many motions ahead as $ADVANCE,
// at most 5. Two cycles of its interpolation.
constexpr plan::TimeModel kKrlTime = {.accelerationMmPerS2 = kKrlMaxMmPerS2,
                                      .jointAccelerationRadPerS2 = 10.0,
                                      .jointsInPercent = true,
                                      .lookAhead = 5};
constexpr MergeLimits kKrlMerge = {.minS = 0.024, .minMm = 0.5, .jointRad = kSameJointRad};
constexpr MergeLimits kMelfaMerge = {.minS = 0.0213, .jointRad = kSameJointRad};

// Of languages that can select a tool, let material flow out at rest, wait for the operator, set
// outputs and contain the user's own lines; and those for which they have outputs.
std::vector<plan::EventKind> eventsOfTools(std::initializer_list<plan::EventKind> outputs) {
  using enum plan::EventKind;
  std::vector<plan::EventKind> events = {Pause, Wait, ToolChange, Purge, Shot, Output, Statement};
  events.insert(events.end(), outputs);
  return events;
}
constexpr plan::EventKind kCut = plan::EventKind::Cut, kRelease = plan::EventKind::Release,
                          kLock = plan::EventKind::Lock, kMark = plan::EventKind::Mark;

using enum plan::FactKind;
std::vector<plan::FactKind> gcodeStates() {
  return {OperatorStop, NozzleHeat,  NozzleHeatWait,    BedHeat,      BedHeatWait,
          Home,         Millimetres, AbsolutePositions, FilamentCount};
}

std::vector<std::string> unitsOfRapid(const robot::Cell& cell) {
  std::vector<std::string> units = {std::string(kRapidExtruderUnit)};
  if (cell.axesUnderRobot() > 0)
    units.push_back(rapidName(cell.robotUnit()));
  if (cell.axesMovePlatform())
    units.push_back(rapidName(cell.externalUnit()));
  for (std::string& unit : units)
    unit = inSmallLetters(unit);
  return units;
}
std::vector<std::string> unitsOfKrl(const robot::Cell& cell) {
  return cell.axesMovePlatform() ? std::vector<std::string>{"machine_def[2]"}
                                 : std::vector<std::string>();
}
} // namespace

const std::vector<Dialect>& dialects() {
  static const std::vector<Dialect> table = {
      {.id = "urscript",
       .label = "URScript (Universal Robots)"_text,
       .extension = "script",
       .controller = "urscript",
       .needsJoints = false,
       .straight = Straight::InBase,
       .hasArcs = true,
       .supportsExternalAxes = false,
       .showsTexts = true,
       .events = eventsOfTools({kCut, kRelease, kLock, kMark}),
       // Every motion states its acceleration. Cycle of a CB3. Rotation limit: 4 rad/s per m/s.
       .time = {.cycleS = 0.008, .rotationMmPerRad = 250.0},
       .merge = {.motionS = 0.008, .jointRad = kSameJointRad},
       .extruders = {kOutputsExtruder, kCastelliExtruder, kStreamExtruder},
       .options = urscriptOptions,
       .states = {OperatorStop, Payload},
       .fullFlowAt = "1",
       .write = writeUrscript,
       .read = readUrscript,
       .looksLike = looksLikeUrscript,
       .continuationFiles = filesOfUrscript,
       .isWord = isUrscriptWord,
       .remark = "#",
       .mayBeMissing = mayBeMissingInUrscript},
      {.id = "urscript-stream",
       .label = "Joint stream (Universal Robots, with receiver and sender)"_text,
       .extension = "joints",
       .controller = "urscript",
       .needsJoints = true,
       .beadsByJoints = true,
       .straight = Straight::Pieces,
       .supportsExternalAxes = false,
       .events = {plan::EventKind::Wait},
       // Every row states its time.
       .time = {},
       // Every row states its flow. An extruder stream counts motions, but a row may be only a
       // piece of one.
       .extruders = {},
       .fullFlowAt = "1",
       .write = writeUrscriptStream,
       .read = readUrscriptStream,
       .looksLike = looksLikeUrscriptStream,
       .continuationFiles = filesOfUrscriptStream,
       .remark = "#",
       .mayBeMissing = isWaitingRow},
      {.id = "gcode-extended",
       .label = "Extended G-code (nozzle direction as nX nY nZ)"_text,
       .extension = "gcode",
       .controller = "gcode-extended",
       .needsJoints = false,
       .saysJointMotions = false,
       .showsTexts = true,
       .events = eventsOfTools({kCut}),
       // Marlin's own figures.
       .time = {.accelerationMmPerS2 = 3000.0, .junctionMm = 0.013},
       .forAnyCell = true,
       .options = extendedGcodeOptions,
       .states = gcodeStates(),
       .write = writeExtendedGcode,
       .read = readExtendedGcode,
       .looksLike = looksLikeExtendedGcode,
       .continuationFiles = filesOfExtendedGcode,
       .remark = ";",
       .mayBeMissing = mayBeMissingInExtendedGcode},
      {.id = "gcode-bc",
       .label = "G-code with B and C (a table that tilts and turns)"_text,
       .extension = "ngc",
       .controller = "gcode-bc",
       .needsJoints = false,
       .straight = Straight::Pieces,
       .saysJointMotions = false,
       .supportsExternalAxes = false,
       .supportsAxesOf = movesTable,
       .events = {plan::EventKind::Purge},
       // Every motion states its time.
       .time = {},
       .options = tableGcodeOptions,
       .states = gcodeStates(),
       .write = writeTableGcode,
       .read = readTableGcode,
       .looksLike = looksLikeTableGcode,
       .remark = ";",
       .mayBeMissing = mayBeMissingInExtendedGcode},
      {.id = "gcode",
       .label = "Plain G-code (three axes, flat jobs)"_text,
       .extension = "gco",
       .controller = "gcode",
       .needsJoints = false,
       .hasArcs = true,
       .saysJointMotions = false,
       .supportsExternalAxes = false,
       .tiltsNozzle = false,
       .showsTexts = true,
       .events = eventsOfTools({kCut}),
       // Same as extended G-code.
       .time = {.accelerationMmPerS2 = 3000.0, .junctionMm = 0.013},
       .states = gcodeStates(),
       .write = writePlainGcode,
       .read = readPlainGcode,
       .looksLike = looksLikePlainGcode,
       .remark = ";",
       .mayBeMissing = mayBeMissingInExtendedGcode},
      {.id = "rapid",
       .label = "RAPID (ABB)"_text,
       .extension = "mod",
       .controller = "rapid",
       .needsJoints = false,
       .hasArcs = true,
       .showsTexts = true,
       .events = eventsOfTools({kCut, kRelease, kLock, kMark}),
       // IRB 1200: 0 to 1 m/s in 0.06 s.
       .time = {.accelerationMmPerS2 = 16000.0, .jointAccelerationRadPerS2 = 20.0},
       // Controllers report events 50024 and 50078 below about 20 to 30 ms or 0.5 to 1 mm.
       .merge = {.minS = 0.024, .minMm = 0.5, .motionS = kRapidMotionS, .jointRad = kSameJointRad},
       .extruders = {kOutputsExtruder, kStreamExtruder, kAxisExtruder},
       .options = rapidOptions,
       .states = {OperatorStop, Payload},
       .fullFlowAt = "1",
       .units = unitsOfRapid,
       .longestText = 80, // of a string
       .write = writeRapid,
       .read = readRapid,
       .looksLike = looksLikeRapid,
       .continuationFiles = filesOfRapid,
       .isWord = isRapidWord,
       .remark = "!",
       .mayBeMissing = mayBeMissingInRapid},
      {.id = "krl",
       .label = "KRL (KUKA)"_text,
       .extension = "src",
       .controller = "krl",
       .needsJoints = false,
       .hasArcs = true,
       .showsTexts = true,
       .events = eventsOfTools({kCut, kRelease, kLock, kMark}),
       .time = kKrlTime,
       .merge = kKrlMerge,
       .extruders = {kOutputsExtruder, kStreamExtruder, kAxisExtruder},
       .options = krlOptions,
       .states = {OperatorStop, Payload},
       .fullFlowAt = "1",
       .units = unitsOfKrl,
       .write = writeKrl,
       .read = readKrl,
       .looksLike = looksLikeKrl,
       .continuationFiles = filesOfKrl,
       .isWord = isKrlWord,
       .remark = ";",
       .mayBeMissing = mayBeMissingInKrl},
      {.id = "krl-eki",
       .label = "Lines by EthernetKRL (KUKA, with receiver and sender)"_text,
       .extension = "eki",
       .controller = "krl",
       .supportsExternalAxes = false,
       .events = {plan::EventKind::Wait},
       .time = kKrlTime,
       .merge = kKrlMerge,
       // Every line states its flow.
       .extruders = {},
       .fullFlowAt = "1",
       .write = writeKrlEki,
       .read = readKrlEki,
       .looksLike = looksLikeKrlEki,
       .continuationFiles = filesOfKrlEki,
       .remark = "#",
       .mayBeMissing = mayBeMissingInKrlEki},
      {.id = "spel",
       .label = "SPEL+ (Epson)"_text,
       .extension = "prg",
       .controller = "spel",
       .needsJoints = false,
       .supportsExternalAxes = false,
       .showsTexts = true,
       .events = eventsOfTools({kRelease, kLock, kMark}),
       // A value that all of its arms accept.
       .time = {.accelerationMmPerS2 = kSpelplusMmPerS2,
                .jointAccelerationRadPerS2 = 10.0,
                .jointsInPercent = true},
       .extruders = {kOutputsExtruder, kCastelliExtruder, kStreamExtruder},
       .options = spelplusOptions,
       .states = {OperatorStop, Payload},
       .fullFlowAt = "10 V",
       .longestLine = 512,
       .write = writeSpelplus,
       .read = readSpelplus,
       .looksLike = looksLikeSpelplus,
       .continuationFiles = filesOfSpelplus,
       .isWord = isSpelplusWord,
       .remark = "'",
       .mayBeMissing = mayBeMissingInSpelplus},
      {.id = "melfa",
       .label = "MELFA-BASIC V (Mitsubishi)"_text,
       .extension = "prg",
       .controller = "melfa",
       .straight = Straight::InBase,
       .supportsExternalAxes = false,
       .showsTexts = true,
       .events = eventsOfTools({kRelease, kLock, kMark}),
       .time = kMelfaTime,
       .merge = kMelfaMerge,
       .extruders = {kOutputsExtruder, kStreamExtruder},
       .options = melfaOptions,
       .states = {OperatorStop, TargetFrame},
       .fullFlowAt = "10000",
       .posture = melfaPosture,
       .longestLine = 127,
       .write = writeMelfa,
       .read = readMelfa,
       .looksLike = looksLikeMelfa,
       .continuationFiles = filesOfMelfa,
       .remark = "'",
       .mayBeMissing = mayBeMissingInMelfa},
      {.id = "melfa-stream",
       .label = "Joint stream (MELFA Mxt, with packets and sender)"_text,
       .extension = "rows",
       .controller = "melfa",
       .needsJoints = true,
       .beadsByJoints = true,
       .straight = Straight::Pieces,
       .supportsExternalAxes = false,
       .events = {plan::EventKind::Wait},
       // Every row states its time.
       .time = {},
       // Every row states its flow. An extruder stream counts motions, but a row may be only a
       // piece of one.
       .extruders = {},
       .options = melfaStreamOptions,
       .fullFlowAt = "10000",
       .write = writeMelfaStream,
       .read = readMelfaStream,
       .looksLike = looksLikeMelfaStream,
       .continuationFiles = filesOfMelfaStream,
       .isBinary = isMxtPackets,
       .remark = "#",
       .mayBeMissing = isWaitingRow},
      {.id = "melfa-datalink",
       .label = "Lines by data link (MELFA-BASIC V, with receiver and sender)"_text,
       .extension = "lines",
       .controller = "melfa",
       .straight = Straight::InBase,
       .supportsExternalAxes = false,
       .events = {plan::EventKind::Wait},
       .time = kMelfaTime,
       .merge = kMelfaMerge,
       // Every line states its flow.
       .extruders = {},
       .fullFlowAt = "10000",
       .write = writeMelfaDatalink,
       .read = readMelfaDatalink,
       .looksLike = looksLikeMelfaDatalink,
       .continuationFiles = filesOfMelfaDatalink,
       .remark = "#",
       .mayBeMissing = mayBeMissingInMelfaDatalink},
      {.id = "tmscript",
       .label = "TMscript (Techman)"_text,
       .extension = "tmscript",
       .controller = "tmscript",
       // A bead's path is a spline through its points.
       .straight = Straight::Pieces,
       .supportsExternalAxes = false,
       .showsTexts = true,
       .sendsTexts = true,
       .waitsByMotion = true,
       .events = eventsOfTools({kRelease, kLock, kMark}),
       // Points state their times; Line and PTP their ramps. The pace of the motion queue is
       // undocumented.
       .merge = {.minS = 0.02, .jointRad = kSameJointRad},
       .extruders = {kOutputsExtruder, kStreamExtruder},
       .states = {OperatorStop, TargetFrame, Payload},
       .fullFlowAt = "10 V",
       .write = writeTmscript,
       .read = readTmscript,
       .looksLike = looksLikeTmscript,
       .remark = "//",
       .mayBeMissing = primes},
      {.id = "csv",
       .label = "Joint table (CSV)"_text,
       .extension = "csv",
       .controller = "",
       .needsJoints = true,
       .write = writeJointTable,
       .read = readJointTable,
       .looksLike = looksLikeJointTable,
       .remark = "#"},
  };
  return table;
}

const Dialect& findDialect(std::string_view id) {
  std::vector<std::string> ids;
  for (const Dialect& d : dialects()) {
    if (d.id == id)
      return d;
    ids.emplace_back(d.id);
  }
  throw base::Error(base::ErrorCode::Usage, base::message("unknown format '{id}'"_text, id), {},
                    base::message("did you mean '{name}'?"_text, base::nearestName(id, ids)));
}

const Dialect* detectDialect(std::string_view fileName, std::string_view text) {
  const auto named = [&](const Dialect& d) {
    const std::size_t dot = fileName.rfind('.');
    return dot != std::string_view::npos && fileName.substr(dot + 1) == d.extension;
  };
  const Dialect* byText = nullptr;
  const Dialect* byName = nullptr;
  for (const Dialect& d : dialects()) {
    const bool fits = d.looksLike(text);
    if (fits && named(d))
      return &d;
    if (fits && !byText)
      byText = &d;
    if (named(d))
      byName = &d;
  }
  return byText ? byText : byName;
}

std::vector<base::ParameterSpec> optionsOf(const Dialect& dialect) {
  std::vector<base::ParameterSpec> options =
      dialect.options ? dialect.options() : std::vector<base::ParameterSpec>();
  if (dialect.straight != Straight::Pieces)
    options.push_back(programResolution());
  if (dialect.hasArcs)
    options.push_back(arcFitting());
  if (dialect.extruders.size() > 1)
    options.push_back(extruderOption(dialect.extruders));
  if (std::ranges::find(dialect.extruders, kAxisExtruder) != dialect.extruders.end())
    options.push_back(extruderAxisMm());
  return options;
}

namespace {
// Of a shared option, each dialect offers the choices it supports.
void addChoices(const base::ParameterSpec& from, base::ParameterSpec& to) {
  for (const base::Choice& choice : from.choices)
    if (std::ranges::find(to.choices, choice.id, &base::Choice::id) == to.choices.end())
      to.choices.push_back(choice);
}
} // namespace

base::ParameterTable programParameters() {
  std::vector<base::ParameterSpec> all;
  for (const Dialect& dialect : dialects())
    for (base::ParameterSpec& option : optionsOf(dialect)) {
      const auto known = std::ranges::find(all, option.key, &base::ParameterSpec::key);
      if (known == all.end())
        all.push_back(std::move(option));
      else
        addChoices(option, *known);
    }
  return base::ParameterTable(std::move(all));
}

ProgramOptions programOptions(const base::ParameterValues& values) {
  return optionsOf(programParameters().specs(), values);
}

bool isForeign(const Dialect& dialect, const robot::Cell& cell) {
  return !dialect.controller.empty() && dialect.controller != cell.robot().controller;
}

bool decidesOnPlan(std::string_view id, const std::vector<std::string>& formats,
                   const robot::Cell& cell) {
  return !isForeign(findDialect(id), cell) ||
         std::all_of(formats.begin(), formats.end(), [&](const std::string& format) {
           return isForeign(findDialect(format), cell);
         });
}

namespace {
// The user's own tolerances. The section may then change as the flow does within its band.
void addOptions(const Dialect& dialect, const ProgramOptions& options, MergeLimits& limits) {
  // Blends of the corners between lines take as much again, those at the ends of arcs little.
  constexpr double kArcMm = 0.02, kLineShare = 0.5, kArcShare = 0.9, kSectionShare = 0.05;
  const ProgramOptions own = optionsAmong(optionsOf(dialect), options);
  const double resolution =
      dialect.straight == Straight::Pieces ? 0.0 : numberOf(programResolution(), own);
  limits.inBase = dialect.straight == Straight::InBase;
  if (dialect.hasArcs && isOn(arcFitting(), own))
    limits.arcMm = kArcShare * (resolution > 0.0 ? resolution : kArcMm);
  limits.levelArcs = !dialect.tiltsNozzle;
  if (resolution > 0.0) {
    limits.all = true;
    limits.toleranceMm = kLineShare * resolution;
  }
  if (limits.all || limits.arcMm > 0.0)
    limits.sectionShare = kSectionShare;
}
} // namespace

MergedPoints pointsFor(std::string_view id, const ProgramInput& input,
                       const base::RunContext& ctx) {
  const Dialect& dialect = findDialect(id);
  MergeLimits limits = dialect.merge;
  // Around a rod, merged motions would cost 1 % of the coverage (measured on two tubes).
  const bool turnsRod = !input.cell.externalAxes().empty();
  if (turnsRod)
    limits.minS = limits.minMm = 0.0;
  // Where poses are written, the pieces of a joint motion determine its path.
  if (turnsRod || isForeign(dialect, input.cell))
    limits.jointRad = 0.0;
  if (!turnsRod)
    addOptions(dialect, input.options, limits);
  MergedPoints points = mergedPoints(input, limits, ctx);
  points.trajectory = withOwnStatements(id, std::move(points.trajectory));
  return points;
}

plan::Program writeProgram(std::string_view id, const ProgramInput& input,
                           const base::RunContext& ctx) {
  const Dialect& dialect = findDialect(id);
  requireOwnRobot(dialect, input.cell);
  requireRodTurns(dialect, input.cell);
  requireBeadWords(dialect.id, input.tooling);
  requireEvents(dialect, input.trajectory);
  requireExtruder(dialect.id, dialect.extruders, input.cell, input.options);
  ProgramInput own = input;
  own.foreign = isForeign(dialect, input.cell);
  own.options = optionsAmong(optionsOf(dialect), input.options);
  if (dialect.extruders.empty())
    own.options.own[std::string(kExtruderOption)] = std::string(kOutputsExtruder);
  if (!dialect.tiltsNozzle) {
    std::vector<Eigen::Vector3d> directions;
    const std::vector<MotionTarget> targets = motionTargets(input, ctx);
    for (std::size_t i = 0; i < targets.size(); ++i)
      if (input.trajectory.move[i] != plan::MoveKind::Joint)
        directions.push_back(targets[i].direction);
    requireUpright(dialect, directions);
  }
  requireEventsSaid(own);
  plan::Program program = dialect.write(own, ctx);
  uncoverBeadWords(program.files, dialect.remark);
  uncoverOwnLines(program.files, dialect.id, dialect.remark, input.trajectory.events);
  if (!dialect.extruders.empty() && extruderOf(own).streams)
    program.files.push_back(streamFile(own, ctx));
  return program;
}

namespace {
// Reads all files but an extruder stream by the dialect's reader; the stream then sets the flow.
plan::ReadProgram readWithStream(const Dialect& dialect,
                                 const std::vector<plan::ProgramFile>& files,
                                 const process::Tooling& tooling, const base::RunContext& ctx) {
  std::vector<plan::ProgramFile> own;
  std::vector<std::size_t> places; // indices of the files in `own`
  std::size_t stream = files.size();
  for (std::size_t f = 0; f < files.size(); ++f)
    if (stream == files.size() && looksLikeStream(files[f].text)) {
      stream = f;
    } else {
      own.push_back(files[f]);
      places.push_back(f);
    }
  if (stream == files.size())
    return dialect.read(files, tooling, ctx);
  plan::ReadProgram program = dialect.read(own, tooling, ctx);
  const auto place = [&](auto& what) {
    if (what.file < places.size())
      what.file = places[what.file];
  };
  std::ranges::for_each(program.motions, place);
  std::ranges::for_each(program.pauses, place);
  std::ranges::for_each(program.defects, place);
  std::ranges::for_each(program.facts, place);
  if (program.load)
    place(*program.load);
  place(program.nozzleAt);
  applyStream(files[stream].text, stream, program);
  return program;
}
} // namespace

std::vector<std::string> continuationFiles(const Dialect& dialect, std::string_view text) {
  // A routine that the user calls before a layer is no file of the program.
  const ReadOwnLines own = takeOwnLines({{"", std::string(text)}}, dialect.id, dialect.remark);
  const std::string_view seen = own.files.empty() ? text : std::string_view(own.files.front().text);
  std::vector<std::string> files =
      dialect.continuationFiles ? dialect.continuationFiles(seen) : std::vector<std::string>();
  if (std::string stream = streamOf(text); !stream.empty())
    files.push_back(std::move(stream));
  return files;
}

plan::ReadProgram readProgram(std::string_view id, const std::vector<plan::ProgramFile>& files,
                              const process::Tooling& tooling, const base::RunContext& ctx) {
  const Dialect& dialect = findDialect(id);
  plan::ReadProgram program;
  program.format = dialect.id;
  if (!reportNoTexts(files, program.defects, dialect.isBinary)) {
    ReadOwnLines own = takeOwnLines(files, id, dialect.remark);
    const std::vector<plan::ProgramFile>& others = own.files.empty() ? files : own.files;
    ReadBeadWords words = takeBeadWords(others, id, dialect.remark, tooling);
    program = readWithStream(dialect, words.files.empty() ? others : words.files, tooling, ctx);
    addBeadWords(std::move(words.facts), program);
    addBeadWords(std::move(own.facts), program);
    std::ranges::move(own.defects, std::back_inserter(program.defects));
    if (program.defects.empty())
      reportMixedLineEnds(files, program.defects, dialect.isBinary);
    if (program.defects.empty())
      reportLongLines(files, {dialect.longestLine, dialect.longestText, dialect.remark},
                      program.defects);
  }
  std::ranges::move(statedFullFlow(files), std::back_inserter(program.facts));
  program.neededFacts.insert(program.neededFacts.end(), dialect.states.begin(),
                             dialect.states.end());
  program.time = dialect.time;
  program.tellsDirections = dialect.tiltsNozzle;
  program.beadsByJoints = dialect.beadsByJoints;
  return program;
}

} // namespace voluta::program
