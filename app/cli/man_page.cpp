#include "cli/option_table.h"
#include "cli/reference_command.h"
#include "project/version.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string_view>

namespace voluta::cli {

namespace {

std::string roff(std::string_view text) {
  std::string escaped = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) {
    if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else
      escaped += c;
  }
  return escaped;
}

std::string sentence(std::string text) {
  if (!text.empty() && text.back() != '.')
    text += '.';
  return text;
}

std::string headOf(const OptionRow& option) {
  std::string head;
  for (const std::string& name : option.names)
    head += fmt::format("{}\\fB{}\\fR", head.empty() ? "" : ", ", roff(name));
  if (!option.value.empty())
    head += fmt::format("{}\\fI{}\\fR{}", head.empty() ? "" : " ", roff(option.value),
                        option.names.empty() && option.repeats ? "..." : "");
  return head;
}

std::string textOf(const OptionRow& option) {
  std::string text = sentence(option.help);
  if (!option.words.empty())
    text += fmt::format(" One of: {}.", fmt::join(option.words, ", "));
  if (!option.range.empty())
    text += fmt::format(" Range: {}.", option.range);
  if (!option.names.empty() && option.required)
    text += " Required.";
  if (!option.names.empty() && option.repeats)
    text += " May be repeated.";
  return roff(text);
}

std::string synopsisOf(const CommandRow& command) {
  std::string line = fmt::format("voluta-cli {}", fmt::join(command.path, " "));
  for (const OptionRow& option : command.options)
    if (option.names.empty())
      line += fmt::format(" {}{}", option.value, option.repeats ? "..." : "");
  for (const OptionRow& option : command.options)
    if (!option.names.empty() && option.required)
      line += fmt::format(" {} {}", option.names.front(), option.value);
  return line + (command.commands.empty() ? " [OPTIONS]" : " COMMAND");
}

constexpr std::string_view kHead = R"(.SH NAME
voluta\-cli \- plan and verify 3D prints with robot arms
.SH SYNOPSIS
.B voluta\-cli
.I COMMAND
.RI [ OPTIONS ]
.SH DESCRIPTION
)";

constexpr std::string_view kFoot = R"(.SH EXIT STATUS
.TP
.B 0
Done; with a plan: planned and verified.
.TP
.B 1
An error in the program.
.TP
.B 2
The request is invalid, or a file cannot be written.
.TP
.B 3
The part or another file cannot be used.
.TP
.B 4
Planned, but something cannot be printed, reached or verified: see
.I findings
in
.IR report.json .
.TP
.B 5
Cancelled; the folder of results is unchanged.
.SH ENVIRONMENT
.TP
.B VOLUTA_DATA
Folder of the user's own robots, cells, processes and materials, instead of
.IR ~/.local/share/voluta .
.TP
.B VOLUTA_RESOURCES
Folder of the data that come with the program, instead of
.IR ../share/voluta
beside it.
.SH EXAMPLES
.nf
voluta\-cli inspect part.stl
voluta\-cli plan part.stl \-o plan
voluta\-cli verify plan/part.script \-\-job plan/job.voluta
.fi
.SH SEE ALSO
.BR voluta (1)
)";

} // namespace

std::string manPage(const CLI::App& app, const std::string& date) {
  std::string page = fmt::format(".TH VOLUTA\\-CLI 1 \"{}\" \"Voluta {}\" \"User commands\"\n{}",
                                 date, project::kVersion, kHead);
  page += roff(app.get_description()) + "\n.SH OPTIONS\n";
  for (const CommandRow& command : commandRows(app)) {
    if (!command.path.empty())
      page += fmt::format(".SS {}\n{}\n", roff(synopsisOf(command)), roff(sentence(command.help)));
    for (const OptionRow& option : command.options)
      if (command.path.empty() || option.names.empty() || option.names.back() != "--help")
        page += fmt::format(".TP\n{}\n{}\n", headOf(option), textOf(option));
    if (command.path.empty())
      page += ".SH COMMANDS\n";
  }
  return page += kFoot;
}

} // namespace voluta::cli
