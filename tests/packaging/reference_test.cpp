// Man pages and completion name every command and option that the programs' own help lists.
#include "helpers/program_output.h"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace voluta {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

struct Command {
  std::string path; // "cell frame"; empty: the program
  std::vector<std::string> options;
};

// Reads the help of the command and of its sub-commands.
void readHelp(const std::string& path, std::vector<Command>& commands) {
  const test::ProgramOutput help = test::outputOf(VOLUTA_CLI " " + path + " --help");
  ASSERT_EQ(help.code, 0) << path;
  static const std::regex option("^ {2,4}(-[-\\w]+(?:,-[-\\w]+)*)"), word("^ {2}([a-z][-a-z]*) ");
  Command command{path, {}};
  std::vector<std::string> inner;
  bool inCommands = false;
  std::istringstream lines(help.text);
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    inCommands = inCommands || line == "Subcommands:";
    if (inCommands && std::regex_search(line, match, word))
      inner.push_back(match[1]);
    if (!std::regex_search(line, match, option))
      continue;
    std::istringstream names(match[1]);
    for (std::string name; std::getline(names, name, ',');)
      command.options.push_back(name);
  }
  commands.push_back(command);
  for (const std::string& name : inner)
    readHelp(path.empty() ? name : path + " " + name, commands);
}

const std::vector<Command>& commands() {
  static const std::vector<Command> read = [] {
    std::vector<Command> found;
    readHelp("", found);
    return found;
  }();
  return read;
}

std::string manPage(const std::string& name) {
  std::ifstream in(fs::path(VOLUTA_DESKTOP_MADE) / name, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return std::regex_replace(text.str(), std::regex("\\\\-"), "-");
}

// Returns the words that bash offers for the last one of the line.
std::vector<std::string> completed(const std::string& line) {
  const test::ProgramOutput output = test::outputOf(
      "bash -c 'compopt() { :; }; source \"" VOLUTA_DESKTOP_MADE
      "/voluta-cli.bash\"; read -ra COMP_WORDS <<< \"" +
      line +
      "|\"; COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); "
      "COMP_WORDS[COMP_CWORD]=${COMP_WORDS[COMP_CWORD]%|}; "
      "COMP_WORDS[0]=" VOLUTA_CLI "; _voluta_cli; printf \"%s\\n\" \"${COMPREPLY[@]}\"'");
  std::vector<std::string> words;
  std::istringstream in(output.text);
  for (std::string word; std::getline(in, word);)
    words.push_back(word);
  return words;
}

TEST(Help, IsReadWhole) {
  EXPECT_GE(commands().size(), 30u);
  std::vector<std::string> paths;
  for (const Command& command : commands())
    paths.push_back(command.path);
  EXPECT_THAT(paths, Contains("cell tool-tip"));
  for (const Command& command : commands())
    if (command.path == "resume") {
      EXPECT_THAT(command.options, Contains("--bead")); // of a group
    }
}

TEST(ManPage, NamesEveryCommandAndOption) {
  const std::string page = manPage("voluta-cli.1");
  for (const Command& command : commands()) {
    const std::string head =
        command.path.empty() ? ".SH OPTIONS\n" : ".SS voluta-cli " + command.path + " ";
    const std::size_t begin = page.find(head);
    ASSERT_NE(begin, std::string::npos) << command.path;
    const std::string section = page.substr(begin, page.find("\n.S", begin + 1) - begin);
    for (const std::string& option : command.options)
      if (command.path.empty() || (option != "--help" && option != "-h")) {
        EXPECT_THAT(section, HasSubstr("\\fB" + option + "\\fR")) << command.path;
      }
  }
}

TEST(ManPage, OfTheWindowNamesItsOptions) {
  const test::ProgramOutput help =
      test::outputOf("QT_QPA_PLATFORM=offscreen " VOLUTA_WINDOW " --help");
  ASSERT_EQ(help.code, 0);
  const std::string page = manPage("voluta.1");
  const std::regex name("(?:^|\n| )(--?[a-z][-a-z]*)");
  int options = 0;
  for (std::sregex_iterator i(help.text.begin(), help.text.end(), name), end; i != end; ++i) {
    EXPECT_THAT(page, HasSubstr((*i)[1].str()));
    ++options;
  }
  EXPECT_GE(options, 5);
  EXPECT_THAT(page, HasSubstr(VOLUTA_VERSION));
}

TEST(Completion, OffersEveryCommandAndOption) {
  for (const Command& command : commands()) {
    const std::vector<std::string> offered = completed("voluta-cli " + command.path + " -");
    for (const std::string& option : command.options)
      EXPECT_THAT(offered, Contains(option)) << command.path;
  }
  const std::vector<std::string> first = completed("voluta-cli ");
  for (const Command& command : commands())
    if (!command.path.empty() && command.path.find(' ') == std::string::npos) {
      EXPECT_THAT(first, Contains(command.path));
    }
}

TEST(Completion, OffersTheValuesOfAnOption) {
  EXPECT_THAT(completed("voluta-cli plan a.stl --order "), ElementsAre("parts", "layers"));
  EXPECT_THAT(completed("voluta-cli plan a.stl --cell ur5-f"), ElementsAre("ur5-fixed"));
  EXPECT_THAT(completed("voluta-cli plan --mode au"), ElementsAre("auto"));
  EXPECT_THAT(completed("voluta-cli plan --set layerHeight"), Contains("layerHeightMm="));
  EXPECT_THAT(completed("voluta-cli list pa"), ElementsAre("parameters", "parts"));
  EXPECT_THAT(completed("voluta-cli cell to"), ElementsAre("tool-tip"));
  EXPECT_THAT(completed("voluta-cli robot ur10"), Contains("ur10e"));
  EXPECT_THAT(completed("voluta-cli verify -"), Not(Contains("--copies")));
}

} // namespace
} // namespace voluta
