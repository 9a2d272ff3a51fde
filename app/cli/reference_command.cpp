#include "cli/reference_command.h"

#include "base/files.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <memory>

namespace voluta::cli {

namespace {
struct ReferenceOptions {
  std::string form, date;
  std::filesystem::path file;
};
} // namespace

void addReference(CLI::App& app, std::function<ExitCode()>& run) {
  auto options = std::make_shared<ReferenceOptions>();
  CLI::App* reference =
      app.add_subcommand("reference", "print all commands and options as a man page, or as a "
                                      "completion of bash");
  reference->add_option("FORM", options->form, "man or bash")
      ->required()
      ->check(CLI::IsMember({"man", "bash"}));
  reference->add_option("--date", options->date, "date of the man page, such as 2026-11-30");
  reference->add_option("-o", options->file, "file to write; default: standard output");
  reference->callback([options, &app, &run] {
    run = [options, &app] {
      const std::string text =
          options->form == "man" ? manPage(app, options->date) : bashCompletion(app);
      if (options->file.empty())
        fmt::print("{}", text);
      else
        base::writeFile(options->file, text);
      return kDone;
    };
  });
}

} // namespace voluta::cli
