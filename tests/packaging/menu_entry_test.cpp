// The entry in menus and file managers: desktop file, icon, MIME types and AppStream metainfo.
#include "helpers/program_output.h"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace voluta {
namespace {

using testing::IsSubsetOf;
using Names = std::set<std::string>;

const std::string kId = "org.voluta.voluta";
const fs::path kFolder = VOLUTA_DESKTOP_DIR, kMade = VOLUTA_DESKTOP_MADE;

// Types of shared-mime-info 2.2 (Debian 12), and their endings that Voluta reads.
const std::map<std::string, std::string> kKnownTypes{
    {"model/stl", ".stl"},        {"model/3mf", ".3mf"},         {"model/obj", ".obj"},
    {"model/gltf+json", ".gltf"}, {"model/gltf-binary", ".glb"}, {"image/x-3ds", ".3ds"},
    {"text/x.gcode", ".gcode"}};
// Endings of other kinds of files too: these are opened from the window, not by a double click.
const Names kSharedEndings{".txt", ".g", ".nc", ".ngc", ".tap"};

std::string textOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// Returns the first group of each match.
Names allOf(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  Names found;
  for (std::sregex_iterator i(text.begin(), text.end(), expression), end; i != end; ++i)
    found.insert((*i)[1]);
  return found;
}

Names splitAt(const std::string& text, char separator) {
  Names words;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, separator);)
    words.insert(word);
  return words;
}

std::map<std::string, std::string> desktopKeys() {
  std::istringstream in(textOf(kFolder / (kId + ".desktop")));
  std::map<std::string, std::string> keys;
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "[Desktop Entry]");
  while (std::getline(in, line)) {
    const std::size_t equals = line.find('=');
    EXPECT_NE(equals, std::string::npos) << line;
    if (equals != std::string::npos) {
      EXPECT_TRUE(keys.emplace(line.substr(0, equals), line.substr(equals + 1)).second) << line;
    }
  }
  return keys;
}

// Returns the endings by type of the package's own MIME file.
std::map<std::string, Names> ownTypes() {
  const std::string text = textOf(kFolder / "voluta.xml");
  const std::regex type("<mime-type type=\"([^\"]+)\">([\\s\\S]*?)</mime-type>");
  std::map<std::string, Names> types;
  for (std::sregex_iterator i(text.begin(), text.end(), type), end; i != end; ++i)
    types[(*i)[1]] = allOf((*i)[2], "glob pattern=\"\\*(\\.[^\"]+)\"");
  return types;
}

Names endingsOfTheProgram() {
  const test::ProgramOutput parts = test::outputOf(VOLUTA_CLI " list parts --json");
  Names endings{".voluta"};
  for (const auto& row : nlohmann::json::parse(parts.text))
    endings.insert(row.at("id").get<std::string>());
  return endings;
}

TEST(DesktopFile, HasTheKeysOfAMenuEntry) {
  auto keys = desktopKeys();
  EXPECT_EQ(keys["Type"], "Application");
  EXPECT_EQ(keys["Name"], "Voluta");
  EXPECT_EQ(keys["Exec"], "voluta %f");
  EXPECT_EQ(keys["Terminal"], "false");
  EXPECT_TRUE(splitAt(keys["Categories"], ';').contains("Graphics"));
  for (const char* key : {"Comment", "GenericName"}) {
    EXPECT_FALSE(keys[key].empty()) << key;
    EXPECT_FALSE(keys[std::string(key) + "[it]"].empty()) << key;
  }
  EXPECT_TRUE(fs::exists(kFolder / (keys["Icon"] + ".svg"))) << keys["Icon"];
  EXPECT_EQ(fs::path(VOLUTA_WINDOW).filename(), keys["StartupWMClass"]);
}

TEST(DesktopFile, OpensEveryTypeThatIsKnown) {
  Names types;
  for (const auto& [type, endings] : ownTypes())
    types.insert(type);
  for (const auto& [type, ending] : kKnownTypes)
    types.insert(type);
  EXPECT_EQ(splitAt(desktopKeys()["MimeType"], ';'), types);
}

TEST(MimeTypes, AreThoseOfTheFilesThatTheProgramReads) {
  Names endings = kSharedEndings;
  for (const auto& [type, ending] : kKnownTypes)
    endings.insert(ending);
  for (const auto& [type, own] : ownTypes()) {
    EXPECT_FALSE(own.empty()) << type;
    for (const std::string& ending : own)
      EXPECT_TRUE(endings.insert(ending).second) << ending << " of " << type << " is known";
  }
  EXPECT_EQ(endings, endingsOfTheProgram());
}

TEST(Metainfo, IsOfThisProgramAndVersion) {
  const std::string text = textOf(kMade / (kId + ".metainfo.xml"));
  EXPECT_EQ(allOf(text, "<id>(.*)</id>"), Names{kId});
  EXPECT_EQ(allOf(text, "\"desktop-id\">(.*)</launchable>"), Names{kId + ".desktop"});
  EXPECT_EQ(allOf(text, "\"stock\">(.*)</icon>"), Names{desktopKeys()["Icon"]});
  EXPECT_EQ(allOf(text, "<project_license>(.*)</project_license>"), Names{"GPL-3.0-or-later"});
  EXPECT_EQ(allOf(text, "<release version=\"([^\"]*)\""), Names{VOLUTA_VERSION});
  EXPECT_EQ(allOf(text, "<release [^>]*date=\"(\\d{4}-\\d\\d-\\d\\d)\"").size(), 1u);
  EXPECT_EQ(test::outputOf(VOLUTA_CLI " --version").text, VOLUTA_VERSION "\n");
  const Names provided = allOf(text, "<mediatype>(.*)</mediatype>");
  EXPECT_EQ(provided.size(), 2u);
  for (const std::string& type : provided)
    EXPECT_TRUE(ownTypes().contains(type)) << type;
  const Names categories = allOf(text, "<category>(.*)</category>");
  EXPECT_EQ(categories, splitAt(desktopKeys()["Categories"], ';'));
}

TEST(Metainfo, IsValidatedWhereAppstreamIsInstalled) {
  if (test::outputOf("command -v appstreamcli").code != 0)
    GTEST_SKIP() << "no appstreamcli";
  const test::ProgramOutput validation = test::outputOf(
      "appstreamcli validate --no-net '" + (kMade / (kId + ".metainfo.xml")).string() + "'");
  EXPECT_EQ(validation.code, 0) << validation.text;
}

} // namespace
} // namespace voluta
