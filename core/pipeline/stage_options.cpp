#include "pipeline/stage_options.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"
#include "base/inherited_text.h"
#include "base/nearest_name.h"
#include "curved/platform_polygon.h"
#include "layers/tool_assignment.h"
#include "modes/cell_choice.h"
#include "modes/mode_table.h"
#include "motion/layer_event_text.h"
#include "motion/motion_options.h"
#include "pipeline/automatic.h"
#include "pipeline/open_part.h"
#include "pipeline/path_parameters.h"
#include "pipeline/quality.h"
#include "pipeline/region_check.h"
#include "placement/orient.h"
#include "process/feature_parameters.h"
#include "process/joined_heads.h"
#include "process/library.h"
#include "program/dialect.h"
#include "program/press_words.h"
#include "program/program_options.h"
#include "project/length_unit.h"
#include "project/platform_kinds.h"
#include "regions/region_patches.h"
#include "robot/cell.h"
#include "toolpath/options.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>

namespace voluta::pipeline {

namespace {
using base::Error;
using base::ErrorCode;

constexpr double kTunedWidthMm = 1.2, kTunedHeightMm = 0.8; // of the beads that lengths suit

// `unknown` has a placeholder for the name.
void checkName(base::Text unknown, const std::string& name, const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw Error(ErrorCode::Usage, base::Message(unknown, {name}), {},
                base::didYouMean(name, known));
}

// A cell or process may be given as the text of a user's file instead of a name.
void checkData(base::Text unknown, const std::string& choice,
               const std::vector<std::string>& known) {
  if (!base::isDataText(choice))
    checkName(unknown, choice, known);
}

// Sets the defaults that depend on the process: its bead sizes, its material's layer times, and
// lengths tuned for beads of 1.2 x 0.8 mm. These lengths grow with larger beads and stay unchanged
// for finer ones.
void followProcess(std::vector<base::ParameterSpec>& specs, const process::Process& p) {
  const double higher = std::max(1.0, p.layerHeightMm / kTunedHeightMm);
  const double wider = std::max(1.0, p.beadWidthMm / kTunedWidthMm);
  const std::map<std::string_view, double> values{
      {"layerHeightMm", p.layerHeightMm},
      {"beadWidthMm", p.beadWidthMm},
      {"stepMm", p.stepMm},
      {"retractMm", p.retractMm},
      {"minLayerTimeS", p.material.minLayerTimeS.value_or(0.0)},
      {"maxLayerTimeS", p.material.maxLayerTimeS.value_or(0.0)}};
  const std::map<std::string_view, double> factors{
      {"voxelMm", higher}, {"cuspMm", higher}, {"liftMm", higher}, {"primeLengthMm", wider}};
  for (base::ParameterSpec& spec : specs) {
    double* length = std::get_if<double>(&spec.defaultValue);
    if (const auto value = values.find(spec.key); value != values.end())
      *length = value->second;
    else if (const auto factor = factors.find(spec.key); factor != factors.end())
      *length = std::min(*length * factor->second, spec.maximum);
  }
}
} // namespace

base::ParameterTable allParameters() {
  base::ParameterTable table({
      base::ofItem(base::numberParameter(
          "layerHeightMm", "mm", 0.8, 0.05, 100.0, "Layers"_text, "layer height"_text,
          "Nominal layer height; limited by the process."_text, true)),
      base::ofItem(base::numberParameter("beadWidthMm", "mm", 1.2, 0.1, 200.0, "Beads"_text,
                                         "bead width"_text,
                                         "Nominal bead width; limited by the process."_text, true)),
      base::ofItem(base::numberParameter(
          "firstLayerWidthMm", "mm", 0.0, 0.0, 200.0, "Beads"_text, "first-layer bead width"_text,
          "Nominal bead width of the first layer and the brim; limited by the "
          "process. 0: that of the process."_text)),
      base::ofItem(
          base::numberParameter("stepMm", "mm", 1.0, 0.1, 100.0, "Beads"_text, "step"_text,
                                "Maximum distance between waypoints along a tool-path; plain "
                                "G-code has fewer where beads are straight."_text)),
      base::numberParameter(
          "retractMm", "mm", 0.0, 0.0, 8.0, "Beads"_text, "retraction"_text,
          "Filament retracted for each travel, if the extruder can; 0: none."_text),
      base::ofItem(base::booleanParameter(
          "givenToolPaths", true, "Beads"_text, "tool-paths of the file"_text,
          "Prints a file along its own tool-paths (.build.3mf, .gcode). Off: "
          "plans new ones for its object."_text)),
      base::booleanParameter("output.build3mf", false, "Output"_text, "write a build file"_text,
                             "Adds NAME.build.3mf: the plan's 6-axis tool-paths for other programs"
                             " (3MF Toolpath Extension)."_text),
      base::booleanParameter("output.proof", true, "Output"_text, "write verification reports"_text,
                             "Adds a verification report to each program, NAME.proof.html and "
                             "NAME.proof.pdf: the verdict, the checks and the margins to the "
                             "limits; its figures as NAME.proof.json; and NAME.printed.stl, the "
                             "part as printed, as a solid."_text),
      base::booleanParameter("output.debug", false, "Output"_text,
                             "write intermediate results"_text,
                             "Adds voxels.vti, pieces/N.stl, pieces/cuts.json, layers.vtp, "
                             "toolpath.vtp and trajectory.csv."_text),
      base::booleanParameter("output.refused", false, "Output"_text, "write refused programs"_text,
                             "Also writes programs that the replay refused, as refused-NAME. For "
                             "inspection only: never run them."_text),
  });
  table.appendOfItems(modes::modeParameters());
  table.appendOfItems(openSurfaceParameters());
  table.appendOfItems(pathShapeParameters());
  table.appendOfItems(placement::orientParameters());
  table.append(process::featureParameters());
  table.append(toolpath::toolpathParameters());
  table.append(regions::regionParameters());
  table.appendOfItems(layers::toolParameters());
  table.append(motion::motionParameters());
  table.append(program::programParameters());
  table.append(qualityParameters());
  return table;
}

namespace {
using Texts = std::map<std::string, std::string>;

// Stores the values of "key=value" texts, with the content of a file that a value names, in the
// map that `where` returns for a parameter. Returns a note for each key that was renamed
// or no longer exists.
template <typename Where>
std::vector<base::Message> storeAll(const std::vector<std::string>& assignments,
                                    const Where& where) {
  std::vector<base::Message> notes;
  base::ParameterValues values(allParameters());
  for (const std::string& assignment : assignments) {
    const std::string key = assignment.substr(0, assignment.find('='));
    if (std::ranges::find(base::droppedKeys(), key) != base::droppedKeys().end()) {
      notes.push_back(base::droppedNote(key));
      continue;
    }
    values.setAssignment(assignment);
    if (base::currentKey(key) != key)
      notes.push_back(base::renamedNote(key));
  }
  for (const auto& [key, value] : values.changes()) {
    const base::ParameterSpec& spec = *values.table().find(key);
    Texts& texts = where(spec);
    const std::string text = base::formatParameter(value);
    texts[key] = spec.file.read ? spec.file.read(text) : text;
  }
  return notes;
}

// Throws Error{Usage} for a parameter that all items share.
void requireOfItem(const base::ParameterSpec& spec) {
  if (spec.scope == base::ParameterScope::Job)
    throw Error(ErrorCode::Usage,
                base::message("{key} is a setting of the job, not of a part"_text, spec.key), {},
                base::message("give it for the job: --set {key}=..."_text, spec.key));
}
} // namespace

std::vector<base::Message> setParameters(project::Choices& choices,
                                         const std::vector<std::string>& assignments) {
  return storeAll(assignments, [&](const base::ParameterSpec& spec) -> Texts& {
    return parametersOf(choices, spec.scope);
  });
}

std::vector<base::Message> setItemParameters(project::ItemChoices& item,
                                             const std::vector<std::string>& assignments) {
  return storeAll(assignments, [&](const base::ParameterSpec& spec) -> Texts& {
    requireOfItem(spec);
    return item.parameters;
  });
}

std::map<std::string, std::string>& parametersOf(project::Choices& choices,
                                                 base::ParameterScope scope) {
  return scope == base::ParameterScope::Job ? choices.parameters : choices.item().parameters;
}

std::map<std::string, std::string> givenParameters(const project::Choices& choices) {
  std::map<std::string, std::string> all = choices.item().parameters;
  all.insert(choices.parameters.begin(), choices.parameters.end());
  return all;
}

base::ParameterTable parametersOf(std::string_view id) {
  std::vector<base::ParameterSpec> specs = allParameters().specs();
  for (const modes::Mode& mode : modes::modeTable())
    for (const auto& [key, text] : mode.defaults)
      for (base::ParameterSpec& spec : specs)
        if (mode.id == id && spec.key == key)
          spec.defaultValue = base::parseParameter(spec, text);
  return base::ParameterTable(std::move(specs));
}

std::size_t ownTool(const project::Choices& choices) {
  const auto& parameters = choices.item().parameters;
  const auto tool = parameters.find("tool");
  return tool == parameters.end() ? 0 : layers::partTool(tool->second, choices.tools.size());
}

void removeTool(project::Choices& choices, std::size_t tool) {
  choices.tools.erase(choices.tools.begin() + static_cast<std::ptrdiff_t>(tool));
  const int number = static_cast<int>(tool) + 1;
  for (project::ItemChoices& item : choices.items) {
    layers::forgetTool(item.parameters, number);
    if (const auto events = item.parameters.find(motion::kLayerEvents);
        events != item.parameters.end())
      events->second = motion::eventsWithoutTool(events->second, number);
    for (project::Region& region : item.regions)
      layers::forgetTool(region.parameters, number);
  }
}

base::ParameterTable parametersOf(const project::Choices& choices) {
  std::vector<base::ParameterSpec> specs = parametersOf(choices.item().mode).specs();
  try {
    followProcess(specs, process::loadProcess(choices.tool(ownTool(choices)).process));
  } catch (const base::Error&) {
    // The stage that loads the process reports its error.
  }
  return base::ParameterTable(std::move(specs));
}

base::ParameterValues parameterValues(const project::Choices& choices) {
  base::ParameterValues values(parametersOf(choices));
  for (const auto& [key, text] : givenParameters(choices))
    values.set(key, text);
  return values;
}

namespace {
// Returns whether the beads of a tool need statements, which exist for some formats only.
bool needsBeadWords(const project::Choices& choices) {
  for (std::size_t i = 0; i < choices.tools.size(); ++i)
    try {
      if (!process::loadProcess(choices.tool(i).process).beadWords.empty())
        return true;
    } catch (const base::Error&) {
      // The stage that loads the process reports its error.
    }
  return false;
}
} // namespace

std::vector<std::string> chosenFormats(const project::Choices& choices, const robot::Cell& cell) {
  if (!choices.formats.empty())
    return choices.formats;
  std::vector<std::string> formats{cell.robot().controller};
  if (needsBeadWords(choices))
    return formats;
  for (const program::Dialect& dialect : program::dialects())
    if (dialect.forAnyCell && dialect.id != formats.front())
      formats.emplace_back(dialect.id);
  return formats;
}

bool canTilt(const project::Choices& choices, const robot::Cell& cell) {
  return cell.tilts() &&
         std::ranges::all_of(chosenFormats(choices, cell), [](const std::string& format) {
           return program::findDialect(format).tiltsNozzle;
         });
}

void requireOptionsApply(const project::Choices& choices,
                         const std::vector<std::string>& assignments) {
  const auto formatsWith = [](std::string_view key) {
    std::vector<std::string> formats;
    for (const program::Dialect& dialect : program::dialects()) {
      const std::vector<base::ParameterSpec> options = program::optionsOf(dialect);
      if (std::ranges::find(options, key, &base::ParameterSpec::key) != options.end())
        formats.emplace_back(dialect.id);
    }
    return formats;
  };
  for (const std::string& assignment : assignments) {
    const std::string key = assignment.substr(0, assignment.find('='));
    const std::vector<std::string> having = formatsWith(key);
    if (having.empty())
      continue;
    const std::vector<std::string> written = chosenFormats(
        choices,
        modes::cellOnAnyPlatform(choices, chosenProcess(choices, parameterValues(choices))));
    if (std::ranges::find_first_of(written, having) == written.end())
      throw Error(
          ErrorCode::Usage,
          base::message("{option} applies to {having}, but the chosen formats are {formats}"_text,
                        key, fmt::format("{}", fmt::join(having, ", ")),
                        fmt::format("{}", fmt::join(written, ", "))),
          {}, base::message("omit it, or give --format {format}"_text, having.front()));
  }
}

process::Process chosenProcess(const project::Choices& choices,
                               const base::ParameterValues& values) {
  process::Process p = process::loadProcess(choices.tool(ownTool(choices)).process);
  if (p.tape)
    throw Error(ErrorCode::Usage,
                base::message("process {process} lays tape and prints no beads"_text, p.id), {},
                "choose it for a further tool, and another one for the part"_text);
  const auto put = [&](const char* key, double& field, double minimum, double maximum) {
    if (!values.changed(key))
      return;
    field = values.number(key);
    if (field < minimum || field > maximum)
      throw Error(
          ErrorCode::Usage,
          base::message("{value} is outside the limits of process {process}"_text, base::mm(field),
                        p.id),
          std::string(key),
          base::message("give {least#} to {most}"_text, base::mm(minimum), base::mm(maximum)));
  };
  put("layerHeightMm", p.layerHeightMm, p.layerHeightMinMm, p.layerHeightMaxMm);
  put("beadWidthMm", p.beadWidthMm, p.beadWidthMinMm, p.beadWidthMaxMm);
  put("stepMm", p.stepMm, 0.1, 100.0);
  process::FeatureSettings& first = p.features.of(process::Feature::FirstLayer);
  if (values.number("firstLayerWidthMm") > 0.0)
    put("firstLayerWidthMm", first.widthMm, p.beadWidthMinMm, p.beadWidthMaxMm);
  process::setFeatureSpeeds(p.features, values);
  put("retractMm", p.retractMm, 0.0, 8.0);
  if (values.text("prime") == "none")
    p.primeS = 0.0;
  return p;
}

namespace {
// Gives all tools one head that contains theirs: collision checks hold for each of them.
void joinHeads(std::vector<process::Tool>& tools) {
  if (tools.size() == 1)
    return;
  std::vector<process::HeadShape> heads;
  double toleranceMm = std::numeric_limits<double>::infinity();
  for (const process::Tool& tool : tools) {
    heads.push_back(tool.process.head);
    // Heads for tape are pressed onto the layer; their own tolerance is below the tape's thickness.
    if (!tool.process.tape)
      toleranceMm = std::min(toleranceMm, tool.process.contactToleranceMm);
  }
  const process::HeadShape joined = process::joinedHeads(heads);
  for (process::Tool& tool : tools) {
    tool.process.head = joined;
    tool.process.contactToleranceMm = toleranceMm;
  }
}
} // namespace

process::Tooling chosenTooling(const project::Choices& choices,
                               const base::ParameterValues& values) {
  std::vector<process::Tool> tools;
  const std::size_t own = ownTool(choices);
  const process::Process process = chosenProcess(choices, values);
  for (std::size_t i = 0; i < choices.tools.size(); ++i) {
    if (i == own) {
      tools.push_back({process});
      continue;
    }
    process::Process other = process::loadProcess(choices.tool(i).process);
    // The layers are those of the part's own tool.
    other.layerHeightMm =
        std::clamp(process.layerHeightMm, other.layerHeightMinMm, other.layerHeightMaxMm);
    tools.push_back({std::move(other)});
  }
  joinHeads(tools);
  if (std::ranges::any_of(
          tools, [](const process::Tool& tool) { return !tool.process.beadWords.empty(); })) {
    const robot::Cell cell = modes::cellOnAnyPlatform(choices, tools.front().process);
    for (process::Tool& tool : tools)
      program::fillPressWords(tool.process, cell);
  }
  return process::Tooling(std::move(tools));
}

namespace {
// Returns the tools, as indices, by the layers from 0 from which they print the part.
std::map<int, int> toolsFromLayers(const base::ParameterValues& values, std::size_t tools) {
  std::map<int, int> from;
  for (const plan::LayerEvent& event : motion::eventsAsked(values)) {
    if (event.kind != plan::LayerEventKind::Tool)
      continue;
    if (event.layer < 1)
      throw Error(ErrorCode::Usage, "a tool changes before a layer, not at a height"_text,
                  std::string(motion::kLayerEvents), "give the number of the layer"_text);
    if (static_cast<std::size_t>(event.number) > tools)
      throw Error(
          ErrorCode::Usage,
          base::message("the job has no tool {number}, it has {tools}"_text, event.number, tools),
          std::string(motion::kLayerEvents), "add a tool, or give the number of one"_text);
    from[event.layer - 1] = event.number - 1;
  }
  return from;
}
} // namespace

layers::ToolAssignment chosenTools(const base::ParameterValues& values,
                                   const process::Tooling& tooling) {
  layers::ToolAssignment assignment = layers::toolAssignment(values, tooling.tools().size());
  assignment.fromLayer = toolsFromLayers(values, tooling.tools().size());
  for (const int tool : assignment.used())
    requirePrints(tooling, tool, tooling.at(assignment.part).process.layerHeightMm);
  return assignment;
}

void requirePrints(const process::Tooling& tooling, int tool, double layerHeightMm) {
  const process::Process& p = tooling.at(tool).process;
  if (layerHeightMm < p.layerHeightMinMm || layerHeightMm > p.layerHeightMaxMm)
    throw Error(ErrorCode::Usage,
                base::message("tool {number} cannot print layers of {height}"_text, tool + 1,
                              base::mm(layerHeightMm)),
                std::string("layerHeightMm"),
                base::message("give {least#} to {most}"_text, base::mm(p.layerHeightMinMm),
                              base::mm(p.layerHeightMaxMm)));
}

double unitMm(const project::LoadedPart& loaded, const project::Choices& choices) {
  constexpr const char* kWidth = "voxelMm";
  if (!loaded.cells)
    return project::lengthUnit(choices.item().units).mm;
  // The part's size must not depend on the defaults of a process or mode.
  base::ParameterValues values(allParameters());
  if (const auto own = choices.item().parameters.find(kWidth);
      own != choices.item().parameters.end())
    values.set(kWidth, own->second);
  return values.number(kWidth);
}

robot::Cell fittingCell(const project::Choices& choices, const process::Process& process) {
  robot::Cell cell = modes::cellOnAnyPlatform(choices, process);
  const bool winds = modes::findMode(choices.item().mode).aroundRod;
  if (winds == cell.rod().has_value())
    return cell;
  std::vector<std::string_view> modesThere;
  for (const modes::Mode& mode : modes::modeTable())
    if (mode.aroundRod == !winds)
      modesThere.emplace_back(mode.id);
  throw Error(ErrorCode::Usage,
              winds
                  ? base::message("mode {mode} prints around a rod, but cell {cell} has none"_text,
                                  choices.item().mode, base::dataName(choices.cell))
                  : base::message("cell {cell} has a rod, but mode {mode} prints on a plate"_text,
                                  base::dataName(choices.cell), choices.item().mode),
              {},
              winds ? base::Message("give `--cell lathe`"_text)
                    : base::message("give `--mode {modes}`, or another cell"_text,
                                    fmt::format("{}", fmt::join(modesThere, ", "))));
}

toolpath::ToolpathOptions toolpathOptionsOf(const base::ParameterValues& values,
                                            const process::Process& process) {
  toolpath::ToolpathOptions options = toolpath::toolpathOptions(values);
  options.stepMm = process.stepMm;
  options.edgeMm = std::max(options.edgeMm, 0.5 * process.beadWidthMm);
  options.cooling.minLayerTimeS = motion::layerTimes(values).minS;
  options.bridgesMaySag = thresholdsOf(qualityOf(values)).bridgesMaySag;
  return options;
}

motion::MotionOptions motionOptionsOf(const base::ParameterValues& values, int seed) {
  motion::MotionOptions options = motion::motionOptions(values);
  options.seed = static_cast<std::uint64_t>(seed);
  // As many rungs for each bead of a wide one as for one of 1.2 mm.
  const double wider = std::max(1.0, values.number("beadWidthMm") / kTunedWidthMm);
  options.rungMm *= wider;
  options.hopMm *= wider;
  const double higher = std::max(1.0, values.number("layerHeightMm") / kTunedHeightMm);
  options.hopLiftMm = std::min(options.hopLiftMm * higher, options.liftMm);
  return options;
}

project::Platform usualPlatform(const project::Choices& choices) {
  project::Choices named = choices;
  named.item().platform = project::Platform();
  const modes::Mode* mode = modes::modeNamed(choices.item().mode);
  const project::Platform plate("cell");
  if (!mode || mode->cuts || !plate.isForAnyOf(mode->platforms))
    return named.item().platform;
  return modes::cellOnAnyPlatform(named, chosenProcess(named, parameterValues(named)))
                 .plates()
                 .empty()
             ? named.item().platform
             : plate;
}

namespace {
void checkLayerTimes(const project::Choices& choices, const base::ParameterValues& values) {
  const plan::LayerTimes times = motion::layerTimes(values);
  if (times.maxS <= 0.0 || times.minS <= times.maxS)
    return;
  const bool isOwnMax = values.changed("maxLayerTimeS"), isOwnMin = values.changed("minLayerTimeS");
  if (!isOwnMax || !isOwnMin) {
    const std::string material = process::loadProcess(choices.tool().process).material.label;
    throw Error(
        ErrorCode::Usage,
        isOwnMax ? base::message("`maxLayerTimeS={greatest:.0f}` is shorter than the {least:.0f} "
                                 "that {material} has to cool"_text,
                                 base::seconds(times.maxS), base::seconds(times.minS), material)
                 : base::message("`minLayerTimeS={least:.0f}` is longer than the {greatest:.0f} "
                                 "in which {material} bonds"_text,
                                 base::seconds(times.minS), base::seconds(times.maxS), material),
        {},
        isOwnMax ? base::Message("give a longer maximum, or another material"_text)
                 : base::Message("give a shorter minimum, or another material"_text));
  }
  throw Error(ErrorCode::Usage,
              base::message("`minLayerTimeS={least:.0f}` is longer than "
                            "`maxLayerTimeS={greatest:.0f}`"_text,
                            base::seconds(times.minS), base::seconds(times.maxS)),
              {}, "give a shorter minimum, or a longer maximum"_text);
}

bool isOwnProcess(const std::string& choice) {
  const std::vector<std::string> ids = process::processIds();
  return std::find(ids.begin(), ids.end(), choice) != ids.end() &&
         !process::comesWithProgram(process::Shelf::Processes, choice);
}
} // namespace

void checkChoices(const project::Choices& given) {
  const project::Choices choices = given.item().automatic ? automaticChoices(given).front() : given;
  std::vector<std::string> modeIds, formatIds;
  for (const modes::Mode& mode : modes::modeTable())
    modeIds.emplace_back(mode.id);
  for (const program::Dialect& dialect : program::dialects())
    formatIds.emplace_back(dialect.id);
  checkName("unknown mode '{name}'"_text, choices.item().mode, modeIds);
  checkData("unknown cell '{name}'"_text, choices.cell, robot::cellIds());
  for (const project::ToolChoice& tool : choices.tools)
    checkData("unknown process '{name}'"_text, tool.process, process::processIds());
  for (const std::string& format : choices.formats)
    checkName("unknown format '{name}'"_text, format, formatIds);
  const std::vector<project::PlatformUse>& taken = modes::findMode(choices.item().mode).platforms;
  if (!choices.item().platform.isForAnyOf(taken))
    throw Error(ErrorCode::Usage,
                base::message("mode {mode} does not print on platform {platform}"_text,
                              choices.item().mode, choices.item().platform.kind().word),
                {},
                base::message("give `--platform {platforms}`"_text, project::platformForms(taken)));
  const bool laysItself = static_cast<bool>(modes::findMode(choices.item().mode).place);
  if (const auto orient = choices.item().parameters.find("orient");
      laysItself && orient != choices.item().parameters.end() && orient->second != "none")
    throw Error(ErrorCode::Usage,
                base::message("`orient={orient}` is for parts on a plate; mode {mode} places them "
                              "itself"_text,
                              orient->second, choices.item().mode),
                {}, "give `orient=none`"_text);
  static_cast<void>(project::lengthUnit(choices.item().units));
  if (project::parsedScale(choices.item().scale) == 0.0 && choices.item().platform.isBody())
    throw Error(ErrorCode::Usage, "scale fit would scale the platform's mesh with the part"_text,
                {}, "give a number"_text);
  const geometry::Placement& place = choices.item().placement;
  if (!place.rotation.coeffs().allFinite() || !(place.rotation.norm() > 0.0) ||
      !place.centreMm.allFinite() || !std::isfinite(place.liftMm))
    throw Error(ErrorCode::Usage, "the placement is not a rotation and a position in mm"_text);
  const base::ParameterValues values = parameterValues(choices);
  for (const auto& [key, text] : choices.item().parameters)
    requireOfItem(*values.table().find(base::currentKey(key)));
  checkRegions(choices.item(), values.table());
  checkLayerTimes(choices, values);
  static_cast<void>(qualityOf(values));
}

void takeOwnFiles(project::Choices& choices) {
  for (project::ToolChoice& tool : choices.tools)
    if (base::isDataFileName(tool.process)) {
      const std::string file = tool.process;
      tool.process = base::wholeText("processes", base::readFile(file), file);
      process::readProcessText(tool.process, file);
    } else if (isOwnProcess(tool.process)) {
      tool.process = process::jobChoice(process::loadItem(process::Shelf::Processes, tool.process));
    }
  if (base::isDataFileName(choices.cell)) {
    constexpr double kAnyMm = 80.0;
    const std::filesystem::path file = choices.cell;
    robot::Cell::read(file, process::loadProcess(choices.tool().process),
                      curved::platformDisc(kAnyMm));
    choices.cell = robot::selfContainedCell(file);
  }
}

} // namespace voluta::pipeline
