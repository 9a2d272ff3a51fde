#include "cli/cell_advice_options.h"

#include "cli/commands.h"
#include "cli/new_file.h"
#include "cli/option_texts.h"
#include "pipeline/automatic.h"
#include "pipeline/stage_options.h"
#include "project/turn_text.h"

#include <memory>
#include <string>
#include <vector>

namespace voluta::cli {

namespace {

// The part, and the choices that decide what it needs of a cell.
void addPart(CLI::App& command, pipeline::PlanRequest& request, std::vector<std::string>& sets,
             int& threads) {
  project::Choices& choices = request.choices;
  command.add_option("PART", request.item().part, kPartHelp)->required();
  command.add_option("--mode", choices.item().mode, "way of building (see: list modes)");
  command.add_option("--process", choices.tool().process, kProcessHelp);
  command.add_option_function<std::string>(
      "--platform",
      [&choices](const std::string& platform) {
        choices.item().platform = project::Platform(platform);
        choices.item().platformStays = true;
      },
      "platform on which printing starts (see: plan)");
  command.add_option("--scale", choices.item().scale, "factor");
  command.add_option("--units", choices.item().units, "units of the mesh file: um, mm, cm, in, m");
  command.add_option_function<std::string>(
      "--turn",
      [&choices](const std::string& rotation) {
        choices.item().placement.rotation = project::parsedRotation(rotation);
      },
      "X,Y,Z: rotations in degrees about the fixed axes, in this order");
  command.add_option("--set", sets, "key=value of a parameter (see: list parameters)")
      ->allow_extra_args(false);
  command.add_option("--threads", threads, "threads to use")->check(CLI::Range(1, 256));
}

void takeChoices(pipeline::PlanRequest& request, const std::vector<std::string>& sets) {
  project::Choices& choices = request.choices;
  choices.item().automatic = false;
  pipeline::takeOwnFiles(choices);
  pipeline::setParameters(choices, sets);
  if (!choices.item().platformStays)
    choices.item().platform = pipeline::usualPlatform(choices);
}

} // namespace

void addCellAdvice(CLI::App& cell, int threads,
                   const std::function<void(std::function<ExitCode()>)>& chosen) {
  struct Place {
    PlaceCellOptions options;
    std::vector<std::string> sets;
  };
  auto placing = std::make_shared<Place>();
  placing->options.threads = threads;
  CLI::App* place = cell.add_subcommand(
      "place", "find the nozzle's bend and the plate's place for a part, and write the cell");
  addPart(*place, placing->options.request, placing->sets, placing->options.threads);
  place->add_option("--robot", placing->options.robot, "robot (see: list robots)")->required();
  place->add_flag("--fixed", placing->options.fixed,
                  "the nozzle is stationary, the arm holds the plate");
  place->add_option("--tilt", placing->options.tiltDeg, "largest tilt of the nozzle in degrees")
      ->check(CLI::Range(0.0, 150.0));
  place->add_option("-o", placing->options.file, "file of the cell: FILE.json");
  addReplaceFile(*place, placing->options.replace);
  place->callback([placing, chosen] {
    chosen([placing] {
      takeChoices(placing->options.request, placing->sets);
      return cellPlaceCommand(placing->options);
    });
  });

  struct Advise {
    AdviseOptions options;
    std::vector<std::string> sets;
  };
  auto advising = std::make_shared<Advise>();
  advising->options.threads = threads;
  CLI::App* advise =
      cell.add_subcommand("advise", "compare cells for a part: reach, load, angle to gravity");
  addPart(*advise, advising->options.request, advising->sets, advising->options.threads);
  advise->add_option("--cells", advising->options.cells, "C,...: cells (see: list cells)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->required();
  advise->add_flag("--plan", advising->options.plan,
                   "also plan the part in each cell: time and collisions");
  advise->add_flag("--json", advising->options.json, "as JSON");
  advise->callback([advising, chosen] {
    chosen([advising] {
      advising->options.request.choices.cell = advising->options.cells.front();
      takeChoices(advising->options.request, advising->sets);
      return cellAdviseCommand(advising->options);
    });
  });
}

} // namespace voluta::cli
