// The commands and options of the command line as rows.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

namespace voluta::cli {

struct OptionRow {
  std::vector<std::string> names; // With their dashes; empty: positional
  std::string value;              // Name of its value, empty for a flag: TEXT, INT, PART
  std::string range;              // Of a number: "1 - 256"
  std::vector<std::string> words; // Its possible values, if they are few
  std::string help;
  bool required = false, repeats = false;
};

struct CommandRow {
  std::vector<std::string> path; // "cell", "frame"
  std::string help;
  std::vector<OptionRow> options;
  std::vector<std::string> commands; // Names of its sub-commands
};

inline OptionRow optionRow(const CLI::Option& option) {
  OptionRow row;
  for (const std::string& name : option.get_snames())
    row.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames())
    row.names.push_back("--" + name);
  // TEXT, TEXT:{a,b} or INT:INT in [1 - 256]
  const std::string type = option.get_type_name();
  const auto inside = [&](char open, char close) {
    const std::size_t begin = type.find(open), end = type.rfind(close);
    return begin == std::string::npos || end == std::string::npos
               ? std::string()
               : type.substr(begin + 1, end - begin - 1);
  };
  row.words = CLI::detail::split(inside('{', '}'), ',');
  std::erase(row.words, std::string());
  row.range = inside('[', ']');
  if (option.get_items_expected_max() > 0)
    row.value = row.names.empty() ? option.get_name(true) : type.substr(0, type.find(':'));
  row.help = option.get_description();
  row.required = option.get_required();
  row.repeats = option.get_items_expected_max() > 1;
  return row;
}

// Adds those of `app` and of its groups, which are apps without a name.
inline void addOptionRows(const CLI::App& app, CommandRow& row) {
  for (const CLI::Option* option : app.get_options())
    row.options.push_back(optionRow(*option));
  for (const CLI::App* group :
       app.get_subcommands([](const CLI::App* a) { return a->get_name().empty(); }))
    addOptionRows(*group, row);
}

inline void addCommandRows(const CLI::App& app, const std::vector<std::string>& path,
                           std::vector<CommandRow>& rows) {
  CommandRow row{path, app.get_description(), {}, {}};
  addOptionRows(app, row);
  const auto named = app.get_subcommands([](const CLI::App* a) { return !a->get_name().empty(); });
  for (const CLI::App* command : named)
    row.commands.push_back(command->get_name());
  rows.push_back(std::move(row));
  for (const CLI::App* command : named) {
    std::vector<std::string> inner = path;
    inner.push_back(command->get_name());
    addCommandRows(*command, inner, rows);
  }
}

// Returns the program itself, with an empty path, and each command.
inline std::vector<CommandRow> commandRows(const CLI::App& app) {
  std::vector<CommandRow> rows;
  addCommandRows(app, {}, rows);
  return rows;
}

} // namespace voluta::cli
