#include "cli/commands.h"
#include "cli/option_table.h"
#include "cli/reference_command.h"

#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string_view>
#include <utility>

namespace voluta::cli {

namespace {

// Options and positional values whose words "voluta-cli list" prints.
constexpr std::array<std::pair<std::string_view, std::string_view>, 15> kListed{
    {{"--cell", "cells"},
     {"--cells", "cells"},
     {"--process", "processes"},
     {"--tool", "processes"},
     {"--material", "materials"},
     {"--cut", "materials"},
     {"--preset", "presets"},
     {"--format", "formats"},
     {"--mode", "modes"},
     {"--modes", "modes"},
     {"--robot", "robots"},
     {"ID", "robots"},
     {"MATERIAL", "materials"},
     {"PROCESS", "processes"},
     {"CELL", "cells"}}};

std::string_view listOf(std::string_view name) {
  for (const auto& [option, list] : kListed)
    if (option == name)
      return list;
  return {};
}

std::string pathOf(const CommandRow& command) {
  return command.path.empty() ? std::string() : fmt::format("/{}", fmt::join(command.path, "/"));
}

// The line of a case statement that completes the value of an option.
std::string valueCase(const CommandRow& command, const OptionRow& option) {
  std::string cases;
  for (const std::string& name : option.names)
    cases += fmt::format("{}\"{} {}\"", cases.empty() ? "" : " | ", pathOf(command), name);
  const std::string_view list = listOf(option.names.back());
  std::string action = "_voluta_cli_files";
  if (!option.words.empty())
    action = fmt::format("_voluta_cli_words \"{}\"", fmt::join(option.words, " "));
  else if (option.names.back() == "--set")
    action = "_voluta_cli_settings";
  else if (!list.empty())
    action = fmt::format("_voluta_cli_listed {}{}", list, list == "modes" ? " auto" : "");
  return fmt::format("    {}) {}; return ;;\n", cases, action);
}

// The line that completes a word that belongs to no option.
std::string wordCase(const CommandRow& command) {
  std::vector<std::string> words = command.commands;
  std::string_view list;
  for (const OptionRow& option : command.options) {
    if (!option.names.empty())
      continue;
    list = listOf(option.value);
    const std::vector<std::string> own = option.value == "WHAT" ? listedKinds() : option.words;
    words.insert(words.end(), own.begin(), own.end());
    break;
  }
  if (!list.empty())
    return fmt::format("    \"{}\") _voluta_cli_listed {} {} ;;\n", pathOf(command), list,
                       fmt::join(words, " "));
  return words.empty() ? std::string()
                       : fmt::format("    \"{}\") _voluta_cli_words \"{}\" ;;\n", pathOf(command),
                                     fmt::join(words, " "));
}

std::string optionsCase(const CommandRow& command) {
  std::string names;
  for (const OptionRow& option : command.options)
    for (const std::string& name : option.names)
      names += (names.empty() ? "" : " ") + name;
  return fmt::format("      \"{}\") _voluta_cli_words \"{}\" ;;\n", pathOf(command), names);
}

constexpr std::string_view kHelpers =
    R"(# Completion of bash for voluta-cli, written by: voluta-cli reference bash

_voluta_cli_words() {
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current")
}
_voluta_cli_files() {
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen -f -- "$current")
}
# Ids that the program lists, then other words; also files, which may be named instead.
_voluta_cli_listed() {
  local listed
  listed=$("${COMP_WORDS[0]}" list "$1" 2>/dev/null | cut -d ' ' -f 1)
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen -f -W "$listed ${*:2}" -- "$current")
}
_voluta_cli_settings() {
  local listed
  listed=$("${COMP_WORDS[0]}" list parameters 2>/dev/null | cut -d ' ' -f 1)
  compopt -o nospace
  mapfile -t COMPREPLY < <(compgen -S = -W "$listed" -- "$current")
}

_voluta_cli() {
  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command="" i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$command/${COMP_WORDS[i]}" in
)";

} // namespace

std::string bashCompletion(const CLI::App& app) {
  const std::vector<CommandRow> commands = commandRows(app);
  std::string paths, values, words, options;
  for (const CommandRow& command : commands) {
    if (!command.path.empty())
      paths += (paths.empty() ? "" : " | ") + pathOf(command);
    for (const OptionRow& option : command.options)
      if (!option.names.empty() && !option.value.empty())
        values += valueCase(command, option);
    words += wordCase(command);
    options += optionsCase(command);
  }
  return fmt::format(R"({}      {}) command+=/${{COMP_WORDS[i]}} ;;
    esac
  done
  case "$command $before" in
{}  esac
  if [[ $current == -* ]]; then
    case "$command" in
{}    esac
    return
  fi
  case "$command" in
{}    *) _voluta_cli_files ;;
  esac
}}
complete -F _voluta_cli voluta-cli
)",
                     kHelpers, paths, values, options, words);
}

} // namespace voluta::cli
