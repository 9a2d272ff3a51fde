#include "cli/own_data_options.h"

#include "cli/commands.h"
#include "cli/new_file.h"
#include "cli/run_interruptibly.h"

#include <CLI/CLI.hpp>
#include <memory>

namespace voluta::cli {

void addMaterial(CLI::App& app, std::function<ExitCode()>& into) {
  CLI::App* material = app.add_subcommand("material", "set up your own materials");
  material->require_subcommand(1);
  auto options = std::make_shared<MaterialOptions>();
  const auto add = [&](const char* name, const char* help, const char* what,
                       ExitCode (*run)(const MaterialOptions&)) {
    CLI::App* command = material->add_subcommand(name, help);
    command->add_option("MATERIAL", options->material, what)->required();
    command->callback([options, run, &into] { into = quick([=] { return run(*options); }); });
    return command;
  };
  const char* any = "material (see: list materials), or FILE.json";
  add("show", "print a material's file", any, materialShowCommand);
  add("check", "check a material's file", any, materialCheckCommand);
  add("import", "copy a file to your own materials", "FILE.json", materialImportCommand);
  CLI::App* written = add("export", "write a material to a file", "material (see: list materials)",
                          materialExportCommand);
  written->add_option("-o", options->file, "FILE.json to write")->required();
  addReplaceFile(*written, options->replace);
  add("compare", "print the fields in which two materials differ", any, materialCompareCommand)
      ->add_option("OTHER", options->other, any)
      ->required();
}

void addProcess(CLI::App& app, std::function<ExitCode()>& into) {
  CLI::App* process = app.add_subcommand("process", "set up your own processes");
  process->require_subcommand(1);
  auto options = std::make_shared<ProcessOptions>();
  const auto add = [&](const char* name, const char* help, const char* what,
                       ExitCode (*run)(const ProcessOptions&)) {
    CLI::App* command = process->add_subcommand(name, help);
    if (what)
      command->add_option("PROCESS", options->process, what)->required();
    command->callback([options, run, &into] { into = quick([=] { return run(*options); }); });
    return command;
  };
  const char* any = "process (see: process list), or FILE.json";
  add("list", "list all processes, marking your own", nullptr, processListCommand);
  add("show", "print a process's file", any, processShowCommand);
  add("check", "check a process's file", any, processCheckCommand);
  add("import", "copy a file to your own processes", "FILE.json", processImportCommand);
  CLI::App* sizes = add("sizes", "correct sizes from measured parts (see: sample:accuracy-plate)",
                        any, processSizesCommand);
  sizes->add_option("TABLE", options->table, "rows: length x 50 49.8; slot y 5 4.8; hole 10 9.6")
      ->required();
  sizes->add_option("-o", options->file, "FILE.json to write the process to");
  addReplaceFile(*sizes, options->replace);
  CLI::App* written = add("export", "write a process to a file", "process (see: process list)",
                          processExportCommand);
  written->add_option("-o", options->file, "FILE.json to write")->required();
  addReplaceFile(*written, options->replace);
  add("compare", "print the fields in which two processes differ", any, processCompareCommand)
      ->add_option("OTHER", options->other, any)
      ->required();
}

void addCellFiles(CLI::App& cell, std::function<ExitCode()>& into) {
  auto options = std::make_shared<CellFileOptions>();
  CLI::App* taken = cell.add_subcommand("import", "copy a file to your own cells");
  taken->add_option("CELL", options->cell, "FILE.json")->required();
  taken->callback([options, &into] { into = quick([=] { return cellImportCommand(*options); }); });
  CLI::App* written = cell.add_subcommand("export", "write a cell to a file");
  written->add_option("CELL", options->cell, "cell (see: list cells)")->required();
  written->add_option("-o", options->file, "FILE.json to write")->required();
  addReplaceFile(*written, options->replace);
  written->callback(
      [options, &into] { into = quick([=] { return cellExportCommand(*options); }); });
}

} // namespace voluta::cli
