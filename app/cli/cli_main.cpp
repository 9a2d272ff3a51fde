// voluta-cli: all functions of the window on the command line (docs/design.md, Command line).
#include "base/data_files.h"
#include "base/error.h"
#include "base/run_context.h"
#include "cli/batch_options.h"
#include "cli/cell_advice_options.h"
#include "cli/commands.h"
#include "cli/compare_run_options.h"
#include "cli/cut_command.h"
#include "cli/joined_values.h"
#include "cli/mill_command.h"
#include "cli/option_texts.h"
#include "cli/own_data_options.h"
#include "cli/pith_command.h"
#include "cli/reference_command.h"
#include "cli/render_command.h"
#include "cli/run_interruptibly.h"
#include "cli/together_options.h"
#include "curved/growth_scheme.h"
#include "layers/print_order.h"
#include "pipeline/presets/chosen_preset.h"
#include "pipeline/stage_options.h"
#include "process/own_materials.h"
#include "project/choices.h"
#include "project/platform.h"
#include "project/platform_kinds.h"
#include "project/turn_text.h"
#include "project/version.h"
#include "regions/region_text.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <thread>

namespace {
using namespace voluta;
using namespace voluta::cli;

const std::map<std::string, ProgressStyle> kProgressStyles{
    {"bar", ProgressStyle::Bar}, {"json", ProgressStyle::Json}, {"none", ProgressStyle::None}};

void addThreads(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "threads to use")->check(CLI::Range(1, 256));
}

void addRunOptions(CLI::App& command, int& threads, std::string& progress) {
  addThreads(command, threads);
  command.add_option("--progress", progress, "how progress is shown")
      ->check(CLI::IsMember({"bar", "json", "none"}));
}

std::string growthIds() {
  std::string ids;
  for (const curved::GrowthScheme& scheme : curved::growthSchemes())
    ids += (ids.empty() ? "" : ", ") + scheme.id();
  return ids;
}

std::string platformForms() {
  using enum project::PlatformUse;
  return project::platformForms({Plate, Rod, Body});
}

// Constructs T from the text. Its exceptions are reported unchanged.
template <typename T>
void addChoice(CLI::App& command, const std::string& name, T& into, const std::string& help) {
  command.add_option_function<std::string>(
      name, [&into](const std::string& text) { into = T(text); }, help);
}
template <typename T>
void addChoices(CLI::App& command, const std::string& name, std::vector<T>& into,
                const std::string& help) {
  command
      .add_option_function<std::vector<std::string>>(
          name,
          [&into](const std::vector<std::string>& texts) {
            for (const std::string& text : texts)
              into.emplace_back(text);
          },
          help)
      ->delimiter(',')
      ->allow_extra_args(false);
}

struct Parsed {
  std::function<ExitCode()> run;
};

// Options common to plan and compare.
struct PlanValues {
  std::string until = "replay", progress = "bar";
  std::string material; // empty: the process's
  std::string preset;   // empty: none
  std::vector<std::string> sets, tools, accepted;
};

// The cell, the process and the part's placement.
void addPlacingOptions(CLI::App& command, pipeline::PlanRequest& request) {
  project::Choices& choices = request.choices;
  command.add_option("--cell", choices.cell, kCellHelp);
  command.add_option("--process", choices.tool().process, kProcessHelp);
  command.add_option("--scale", choices.item().scale,
                     "factor, or fit: the largest up to 1 that is in reach");
  command.add_option("--units", choices.item().units, kUnitsHelp);
  command.add_option_function<std::string>(
      "--turn",
      [&choices](const std::string& rotation) {
        choices.item().placement.rotation = project::parsedRotation(rotation);
      },
      "X,Y,Z: rotations in degrees about the fixed axes, in this order "
      "(see: orient)");
}

void addPartOption(CLI::App& command, pipeline::PlanRequest& request) {
  command.add_option("PART", request.item().part, kPartHelp)->required();
}

void addPlateOptions(CLI::App& command, project::Choices& choices, PlateOptions& options) {
  command.add_option("PART", options.parts, kPartHelp)->required();
  command.add_option("--copies", options.copies, "number of each part")->check(CLI::Range(1, 255));
  command.add_flag("--no-file-regions", options.noFileRegions,
                   "leave out the regions and events of layers that files give their parts");
  command.add_flag("--as-one", options.asOne,
                   "a file of several objects (3MF) or solids (STEP, IGES) is one part; default: a "
                   "part for each, in its place in the file");
  command.add_option(
      "--facets", options.facets,
      "MM or MM,DEGREES: largest distance of facets from the surfaces of a STEP or "
      "IGES file, and largest angle between them; default: 2 % of the bead width, 5");
  command
      .add_option("--place", options.places,
                  "NUMBER:X,Y,TURN,Z: place of a part in mm, its rotation about z in degrees, and "
                  "the height of its lowest point; parts are numbered from 1; default: arranged "
                  "side by side")
      ->allow_extra_args(false);
  command
      .add_option("--part", options.own, "NUMBER:KEY=VALUE: mode, scale or a parameter of one part")
      ->allow_extra_args(false);
  command.add_option("--region", options.regions, std::string("[NUMBER:]") + kRegionHelp)
      ->allow_extra_args(false);
  command
      .add_option_function<std::string>(
          "--order",
          [&choices](const std::string& order) {
            choices.printOrder = order == "layers" ? layers::PrintOrder::ByLayer
                                                   : layers::PrintOrder::OneAfterAnother;
          },
          "several parts: one after another (parts) or layer by layer (layers)")
      ->check(CLI::IsMember({"parts", "layers"}));
}

void addPlanOptions(CLI::App& command, pipeline::PlanRequest& request, PlanValues& values) {
  addPlacingOptions(command, request);
  command.add_option("--material", values.material,
                     "material instead of the process's (see: list materials), or FILE.json");
  command
      .add_option(
          "--tool", values.tools,
          "PROCESS or PROCESS:MATERIAL of a further tool; tools are numbered from 1, which is "
          "--process (see parameters tool, supportTool, infillTool, pieceTools)")
      ->allow_extra_args(false);
  command.add_option("--preset", values.preset,
                     "preset of settings (see: list presets), or FILE.json; --set changes single "
                     "ones");
  command.add_option("--set", values.sets, "key=value of a parameter (see: list parameters)")
      ->allow_extra_args(false);
  command
      .add_option("--accept", values.accepted,
                  "FIGURE=SHARE: a difference of the printed part that is accepted in this job: "
                  "uncovered, unsupported, overfill or mass, such as uncovered=0.05")
      ->allow_extra_args(false);
  command.add_option("--until", values.until, "stop after this stage");
  command.add_option("--format", request.choices.formats, "program format")
      ->allow_extra_args(false);
  command.add_option("--seed", request.choices.seed, "seed of the random samplers");
}

// PROCESS or PROCESS:MATERIAL; a file's name may contain a colon.
project::ToolChoice toolChoice(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || base::isDataFileName(text))
    return {text};
  return {process::processTextWith(text.substr(0, colon), text.substr(colon + 1))};
}

void takePlanOptions(pipeline::PlanRequest& request, const PlanValues& values) {
  request.until = project::stageOf(values.until);
  project::Choices& choices = request.choices;
  for (const std::string& tool : values.tools)
    choices.tools.push_back(toolChoice(tool));
  pipeline::takeOwnFiles(choices);
  if (!values.material.empty())
    choices.tool().process = process::processTextWith(choices.tool().process, values.material);
  if (!values.preset.empty())
    choices = pipeline::withPreset(std::move(choices), values.preset);
  for (const base::Message& note :
       pipeline::setParameters(choices, withAccepted(values.sets, values.accepted)))
    fmt::print(stderr, "note: {}\n", base::english(note));
  if (!choices.item().automatic && !choices.item().platformStays)
    choices.item().platform = pipeline::usualPlatform(choices);
}

void addPlan(CLI::App& app, Parsed& parsed, int threads) {
  struct Values : PlanValues {
    PlanOptions options;
  };
  auto values = std::make_shared<Values>();
  values->options.threads = threads;
  CLI::App* plan = app.add_subcommand("plan", "plan a part and write verified robot programs");
  auto& request = values->options.request;
  addPlateOptions(*plan, request.choices, values->options.plate);
  addPlanOptions(*plan, request, *values);
  plan->add_option("-o", values->options.folder, "folder for job, report and programs")->required();
  plan->add_flag("--replace", values->options.replace, kReplaceHelp);
  request.choices.item().automatic = true;
  plan->add_option_function<std::string>(
      "--mode",
      [&request](const std::string& mode) {
        request.choices.item().automatic = mode == "auto";
        if (!request.choices.item().automatic)
          request.choices.item().mode = mode;
      },
      "way of building; default auto: the first without blocking findings");
  addChoice(*plan, "--growth", request.choices.item().growth,
            "growth scheme of curved mode: " + growthIds());
  plan->add_option_function<std::string>(
      "--platform",
      [&request](const std::string& platform) {
        request.choices.item().platform = project::Platform(platform);
        request.choices.item().platformStays = true;
      },
      "platform on which printing starts: " + platformForms());
  addRunOptions(*plan, values->options.threads, values->progress);
  plan->callback([values, &parsed] {
    parsed.run = [values] {
      values->options.progress = kProgressStyles.at(values->progress);
      takePlanOptions(values->options.request, *values);
      pipeline::requireOptionsApply(values->options.request.choices, values->sets);
      return planCommand(values->options);
    };
  });
}

// Throws CLI::ParseError if these words after "plan" cannot be parsed.
void requirePlanWords(std::vector<std::string> words) {
  CLI::App app;
  Parsed parsed;
  addPlan(app, parsed, 1);
  words.insert(words.begin(), "plan");
  std::reverse(words.begin(), words.end());
  app.parse(words);
  requireFiniteNumbers(app);
}

// Returns the options of plan that take a value, without dashes: cell, mode, ...
std::vector<std::string> planOptionNames() {
  CLI::App app;
  Parsed parsed;
  addPlan(app, parsed, 1);
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_subcommand("plan")->get_options())
    if (!option->get_lnames().empty() && option->get_items_expected_max() > 0)
      names.push_back(option->get_lnames().front());
  return names;
}

void addCompare(CLI::App& app, Parsed& parsed, int threads) {
  struct Values : PlanValues {
    CompareCommandOptions options;
    std::vector<std::string> weights;
    bool noPictures = false;
    std::vector<std::string> regions;
  };
  auto values = std::make_shared<Values>();
  values->options.threads = threads;
  CLI::App* compare = app.add_subcommand("compare", "compare ways of building a part");
  auto& compared = values->options.compared;
  addPartOption(*compare, compared.plan);
  addPlanOptions(*compare, compared.plan, *values);
  compare
      ->add_option("-o", values->options.folder,
                   "folder for compare.json and, for each row, report, programs and pictures")
      ->required();
  compare->add_flag("--replace", values->options.replace, kReplaceHelp);
  compare->add_option("--modes", compared.modes, "M,...: ways of building; default all")
      ->delimiter(',')
      ->allow_extra_args(false);
  compare->add_option("--cells", compared.cells, "C,...: cells; default the one of --cell")
      ->delimiter(',')
      ->allow_extra_args(false);
  addChoices(*compare, "--growths", compared.growths,
             "G,...: growth schemes of curved mode, from " + growthIds() + "; " +
                 curved::GrowthScheme().id() + " by default");
  addChoices(*compare, "--platforms", compared.platforms,
             "P,...: platforms, from " + platformForms() + "; " +
                 "default the cell's plate (planar: fit)");
  compare
      ->add_option("--weight", values->weights,
                   "FIGURE=NUMBER: weight in the ranking. Rule: " +
                       pipeline::ruleText(pipeline::defaultWeights()))
      ->allow_extra_args(false);
  compare->add_option("--region", values->regions, kRegionHelp)->allow_extra_args(false);
  compare->add_flag("--no-pictures", values->noPictures, "figures only");
  addRunOptions(*compare, values->options.threads, values->progress);
  compare->callback([values, &parsed] {
    parsed.run = [values] {
      CompareCommandOptions& options = values->options;
      options.progress = kProgressStyles.at(values->progress);
      options.pictures = !values->noPictures;
      options.weights = pipeline::defaultWeights();
      for (const std::string& weight : values->weights)
        pipeline::setWeight(options.weights, weight);
      for (const std::string& text : values->regions)
        options.compared.plan.choices.item().regions.push_back(
            regions::parsedRegion(text, base::RunContext()));
      if (!options.compared.modes.empty())
        options.compared.plan.choices.item().mode = options.compared.modes.front();
      takePlanOptions(options.compared.plan, *values);
      return compareCommand(options);
    };
  });
}

void addVerify(CLI::App& app, Parsed& parsed, int threads) {
  struct Values {
    VerifyOptions options;
    std::string progress = "bar";
  };
  auto values = std::make_shared<Values>();
  values->options.threads = threads;
  CLI::App* verify = app.add_subcommand("verify", "replay a program from disk");
  verify->add_option("PROGRAM", values->options.program, "program file")->required();
  verify
      ->add_option("--job", values->options.job,
                   "job.voluta, or mill.json of a milled part, from which it was made")
      ->required();
  addRunOptions(*verify, values->options.threads, values->progress);
  verify->callback([values, &parsed] {
    parsed.run = [values] {
      values->options.progress = kProgressStyles.at(values->progress);
      return verifyCommand(values->options);
    };
  });
}

void addResume(CLI::App& app, Parsed& parsed, int threads) {
  struct Values {
    ResumeOptions options;
    std::size_t bead = 0, line = 0;
    std::string progress = "bar";
  };
  auto values = std::make_shared<Values>();
  values->options.threads = threads;
  pipeline::ResumeRequest& request = values->options.request;
  CLI::App* resume = app.add_subcommand("resume", "plan the rest of a stopped print");
  resume->add_option("JOB", request.job, "job.voluta of the stopped print")->required();
  CLI::Option_group* where = resume->add_option_group("where");
  CLI::Option* bead =
      where->add_option("--bead", values->bead, "start with this bead, numbered from 1");
  CLI::Option* line =
      where->add_option("--at", values->line, "start with the motion on this program line");
  where->require_option(1);
  resume->add_option("--program", request.program,
                     "file to which --at refers (default: the job's first program, if it "
                     "is a single file)");
  resume->add_option("-o", values->options.folder, "folder for job, report and programs")
      ->required();
  resume->add_flag("--replace", values->options.replace, kReplaceHelp);
  resume->add_option("--format", request.formats, "format (default: that of --program or the job)")
      ->allow_extra_args(false);
  addRunOptions(*resume, values->options.threads, values->progress);
  resume->callback([values, bead, line, &parsed] {
    if (bead->count() > 0)
      values->options.request.bead = values->bead;
    if (line->count() > 0)
      values->options.request.line = values->line;
    parsed.run = [values] {
      values->options.progress = kProgressStyles.at(values->progress);
      return resumeCommand(values->options);
    };
  });
}

void addInspect(CLI::App& app, Parsed& parsed, int threads) {
  auto options = std::make_shared<InspectOptions>();
  options->threads = threads;
  CLI::App* inspect = app.add_subcommand("inspect", "diagnose a mesh");
  inspect->add_option("PART", options->part, "file of a part (see: list parts)")->required();
  inspect->add_flag("--json", options->json, "as JSON");
  addThreads(*inspect, options->threads);
  inspect->callback([options, &parsed] {
    parsed.run = [options] {
      return answered([&](const base::RunContext& ctx) { return inspectCommand(*options, ctx); },
                      options->threads);
    };
  });
}

void addOrient(CLI::App& app, Parsed& parsed, int threads) {
  auto options = std::make_shared<OrientOptions>();
  options->threads = threads;
  CLI::App* orient = app.add_subcommand("orient", "list suggested orientations of a part");
  addPartOption(*orient, options->request);
  addPlacingOptions(*orient, options->request);
  orient->add_flag("--json", options->json, "as JSON");
  addThreads(*orient, options->threads);
  orient->callback([options, &parsed] {
    parsed.run = [options] {
      pipeline::takeOwnFiles(options->request.choices);
      return orientCommand(*options);
    };
  });
}

CLI::App* addImportRobot(CLI::App& robot, Parsed& parsed, int threads) {
  auto options = std::make_shared<ImportRobotOptions>();
  options->threads = threads;
  CLI::App* command = robot.add_subcommand("import", "make a robot and a cell from a URDF");
  command->add_option("FILE", options->urdf, "URDF, xacro expanded")->required();
  command->add_option("--tip", options->options.tip, "link whose frame is the flange");
  command->add_option("--base", options->options.base, "link whose frame is the base of poses");
  command->add_option("--id", options->options.id, "id of the robot");
  command->add_option("--controller", options->options.controller,
                      "program format of its controller (see: list formats); default csv");
  command->add_option("-o", options->folder,
                      "folder for robots/ and cells/; default the user's data folder");
  command->add_flag("--replace", options->replace, "replace the files of an earlier import");
  command
      ->add_option("--cell", options->cell,
                   "moving (nozzle on the arm, plate on a table) or fixed (stationary "
                   "nozzle, plate on the arm)")
      ->check(CLI::IsMember({"moving", "fixed"}));
  addThreads(*command, options->threads);
  command->callback(
      [options, &parsed] { parsed.run = [options] { return importRobotCommand(*options); }; });
  return command;
}

void addRobot(CLI::App& app, Parsed& parsed, int threads) {
  auto options = std::make_shared<RobotOptions>();
  CLI::App* robot = app.add_subcommand("robot", "forward and inverse kinematics, degrees and mm");
  CLI::Option* id = robot->add_option("ID", options->id, "robot (see: list robots)");
  CLI::Option* forward = robot->add_option("--fk", options->forward, "q1,q2,...: flange pose");
  CLI::Option* inverse =
      robot->add_option("--ik", options->inverse, "x,y,z,qw,qx,qy,qz: all branches");
  forward->excludes(inverse);
  const CLI::App* import = addImportRobot(*robot, parsed, threads);
  robot->callback([=, &parsed] {
    if (import->parsed())
      return;
    if (id->count() == 0)
      throw CLI::RequiredError("ID");
    if (forward->count() + inverse->count() == 0)
      throw CLI::RequiredError("--fk or --ik");
    parsed.run = quick([options] { return robotCommand(*options); });
  });
}

void addReach(CLI::App& cell, Parsed& parsed, int threads) {
  auto options = std::make_shared<ReachOptions>();
  options->threads = threads;
  const auto addOptions = [&](CLI::App& command) {
    command.add_option("--cell", options->choices.cell, kCellHelp);
    command.add_option("--process", options->choices.tool().process, kProcessHelp);
    command.add_flag("--json", options->json, "as JSON");
  };
  CLI::App* reach = cell.add_subcommand("reach", "map where the head reaches over the plate");
  addOptions(*reach);
  addChoice(*reach, "--platform", options->choices.item().platform,
            "plate to map; default the cell's largest");
  reach->add_option("--height", options->heightMm, "maximum height above the plate in mm")
      ->check(CLI::Range(1.0, 5000.0));
  addThreads(*reach, options->threads);
  reach->callback([options, &parsed] {
    parsed.run = [options] {
      pipeline::takeOwnFiles(options->choices);
      return cellReachCommand(*options);
    };
  });
  CLI::App* nozzle = cell.add_subcommand("nozzle", "find the best position of a stationary nozzle");
  addOptions(*nozzle);
  nozzle->callback([options, &parsed] {
    parsed.run = [options] {
      pipeline::takeOwnFiles(options->choices);
      return answered(
          [&](const base::RunContext& ctx) { return cellNozzleCommand(*options, ctx); });
    };
  });
}

void addCell(CLI::App& app, Parsed& parsed, int threads) {
  CLI::App* cell = app.add_subcommand("cell", "set up your own cell");
  cell->require_subcommand(1);
  auto measured = std::make_shared<MeasuredOptions>();
  CLI::App* frame = cell->add_subcommand("frame", "compute a frame from touched points, as JSON");
  frame
      ->add_option("TABLE", measured->table,
                   "three rows x,y,z: origin, a point on X, a point in the XY plane; or "
                   "at least three rows of six: nominal point, touched point")
      ->required();
  frame->callback([measured, &parsed] {
    parsed.run = quick([measured] { return cellFrameCommand(*measured); });
  });
  CLI::App* tip = cell->add_subcommand(
      "tool-tip", "compute the tool tip from poses that touch one point, as JSON");
  tip->add_option("TABLE", measured->table,
                  "at least four rows x,y,z,qw,qx,qy,qz of the flange, or of the "
                  "robot's joints")
      ->required();
  tip->add_option("--robot", measured->robot, "robot whose joints the rows contain");
  tip->callback([measured, &parsed] {
    parsed.run = quick([measured] { return cellTipCommand(*measured); });
  });
  auto checked = std::make_shared<CheckCellOptions>();
  CLI::App* check = cell->add_subcommand("check", "list the limitations of a cell, one per line");
  check->add_option("CELL", checked->cell, "cell (see: list cells), or FILE.json")->required();
  check->add_option("--process", checked->process, kProcessHelp);
  check->add_option("--part-kg", checked->partKg, "mass of the part in kg")
      ->check(CLI::Range(0.0, 1000.0));
  check->callback([checked, &parsed] {
    parsed.run = [checked] {
      return answered([&](const base::RunContext& ctx) { return cellCheckCommand(*checked, ctx); });
    };
  });
  addCellFiles(*cell, parsed.run);
  addReach(*cell, parsed, threads);
  addCellAdvice(*cell, threads,
                [&parsed](std::function<ExitCode()> run) { parsed.run = std::move(run); });
}

void addList(CLI::App& app, Parsed& parsed) {
  auto options = std::make_shared<ListOptions>();
  CLI::App* list = app.add_subcommand("list", "list the available choices");
  list->add_option("WHAT", options->what,
                   "modes, cells, robots, formats, processes, materials, parameters or parts")
      ->required();
  list->add_flag("--json", options->json, "as JSON");
  list->callback(
      [options, &parsed] { parsed.run = quick([options] { return listCommand(*options); }); });
}

int run(int argc, char** argv) {
  CLI::App app{"Voluta plans 3D printing with robot arms and verifies its programs."};
  app.name("voluta-cli");
  app.set_version_flag("--version", project::kVersion);
  app.require_subcommand(1);
  Parsed parsed;
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  addPlan(app, parsed, threads);
  addCompare(app, parsed, threads);
  std::vector<std::string> words = joinedNegativeValues(argc, argv);
  addBatch(app, parsed.run, threads, {takenPlanWords(words), requirePlanWords, planOptionNames});
  addVerify(app, parsed, threads);
  addCompareRun(app, threads, [&parsed](std::function<ExitCode()> run) { parsed.run = run; });
  addResume(app, parsed, threads);
  addTogether(app, parsed.run, threads);
  addRender(app, parsed.run);
  addFilm(app, parsed.run);
  addInspect(app, parsed, threads);
  addOrient(app, parsed, threads);
  addRobot(app, parsed, threads);
  addCell(app, parsed, threads);
  addMaterial(app, parsed.run);
  addProcess(app, parsed.run);
  addList(app, parsed);
  addMill(app, parsed.run, threads);
  addPith(app, parsed.run, threads);
  addCut(app, parsed.run, threads);
  addSplit(app, parsed.run, threads);
  addReference(app, parsed.run);
  std::reverse(words.begin(), words.end());
  try {
    app.parse(words);
    requireFiniteNumbers(app);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0)
      return app.exit(e);
    std::string line = e.what();
    std::replace(line.begin(), line.end(), '\n', ' ');
    fmt::print(stderr, "voluta-cli: {} (see: voluta-cli --help)\n", line);
    return kUsage;
  }
  return parsed.run();
}
} // namespace

int main(int argc, char** argv) {
  blockInterrupts();
  const auto outcome = base::outcomeOf([&] { return run(argc, argv); });
  if (const auto* code = std::get_if<int>(&outcome))
    return *code;
  if (const auto* error = std::get_if<base::Error>(&outcome)) {
    fmt::print(stderr, "voluta-cli: {}\n", error->what());
    return exitCodeOf(error->code());
  }
  return kCancelled;
}
