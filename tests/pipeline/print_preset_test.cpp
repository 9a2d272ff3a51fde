// Presets of printing: read and written whole, inherited from parents, compared with the settings
// of a job, and refused in one line.
#include "pipeline/presets/print_preset.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"
#include "base/lower_case.h"
#include "helpers/other_text.h"
#include "helpers/temporary_folder.h"
#include "pipeline/command_line_fixture.h"
#include "pipeline/presets/chosen_preset.h"
#include "pipeline/sample_job.h"
#include "pipeline/stage_options.h"
#include "project/job.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

namespace voluta::pipeline {
namespace {

class Presets : public ::testing::Test {
protected:
  void SetUp() override {
    setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
    setenv("VOLUTA_DATA", folder_.path().c_str(), 1);
  }
  void TearDown() override { unsetenv("VOLUTA_DATA"); }

  std::filesystem::path own(const std::string& id) const {
    return folder_.path() / "presets" / (id + ".json");
  }
  void write(const std::string& id, const std::string& text) const {
    std::filesystem::create_directories(folder_.path() / "presets");
    base::writeFile(own(id), text);
  }
  // The line that an error shows; empty: none was thrown. It has the words.
  template <typename Work> static void refused(Work work, const std::vector<std::string>& words) {
    try {
      work();
      ADD_FAILURE() << "not refused: " << words.front();
    } catch (const base::Error& error) {
      const std::string line = error.what();
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
      for (const std::string& word : words)
        EXPECT_NE(line.find(word), std::string::npos) << line << " lacks " << word;
    }
  }

  test::TemporaryFolder folder_;
};

TEST_F(Presets, EachThatComesWithTheProgramIsAContract) {
  std::vector<std::string> labels;
  for (const std::string& id : presetIds()) {
    SCOPED_TRACE(id);
    const PrintPreset preset = loadPreset(id);
    EXPECT_EQ(preset.id, id);
    EXPECT_TRUE(presetComesWithProgram(id));
    EXPECT_EQ(presetChoice(preset), id);
    EXPECT_EQ(readPreset(presetText(preset), "again"), preset);
    EXPECT_EQ(loadPreset(preset.label), preset) << "found by its label too";
    // Every one descends from the usual one, and says something of its own.
    const Settings all = presetSettings(preset);
    EXPECT_EQ(preset.parent.empty(), id == "usual");
    EXPECT_EQ(preset.settings.empty(), id == "usual");
    if (!preset.parent.empty()) {
      EXPECT_NE(all, presetSettings(loadPreset(preset.parent)));
    }
    // It is read-only.
    refused([&] { saveOwnPreset(preset); }, {id, "comes with the program"});
    refused([&] { removeOwnPreset(id); }, {id, "comes with the program"});
    // A job takes it, with settings that can be parsed.
    const project::Choices choices = withPreset({}, id);
    EXPECT_EQ(choices.preset, id);
    EXPECT_NO_THROW(parameterValues(choices));
    EXPECT_TRUE(settingDifferences(all, givenParameters(choices), allParameters()).empty());
    EXPECT_EQ(std::ranges::count(labels, preset.label), 0);
    labels.push_back(preset.label);
  }
  EXPECT_GE(labels.size(), 4u);
  EXPECT_TRUE(presetSettings(loadPreset(project::Choices().preset)).empty())
      << "a project of an older version has the usual one, and its settings";
}

TEST_F(Presets, HoldTheSettingsOfPrintingAndNoOthers) {
  const base::ParameterTable& table = presetParameters();
  for (const char* key : {"layerHeightMm", "walls", "infillDensity", "supports", "seam", "quality",
                          "outerWallSpeedMmPerS", "minLayerTimeS", "retractMm", "brimWidthMm"})
    EXPECT_NE(table.find(key), nullptr) << key;
  for (const char* key : {"voxelMm", "cutPlanes", "accept", "givenToolPaths"})
    EXPECT_EQ(table.find(key), nullptr) << key;
  // The sentence of a refusal names each heading that a preset holds.
  const std::set<std::string> headings{"layers", "beads", "tool-paths", "cooling", "quality"};
  const base::ParameterTable every = allParameters();
  for (const base::ParameterSpec& spec : every.specs()) {
    const std::string heading = base::lowerCase(base::english(spec.group));
    if (table.find(spec.key)) {
      EXPECT_TRUE(headings.contains(heading)) << spec.key;
      continue;
    }
    EXPECT_TRUE(!headings.contains(heading) || spec.type == base::ParameterType::Text ||
                spec.key == "voxelMm" || spec.key == "givenToolPaths")
        << spec.key;
    refused(
        [&] {
          readPreset(R"({"id": "x", "label": "X", "settings": {")" + spec.key + R"(": 0}})",
                     "x.json");
        },
        {"x.json", "'" + spec.key + "'",
         "presets hold settings of layers, beads, tool-paths, cooling and quality"});
  }
  // A preset sets no safety aside and writes no other files.
  for (const char* key : {"bodyClearanceMm", "partClearanceMm", "collisionModel", "output.refused",
                          "output.proof", "extruder"})
    EXPECT_EQ(table.find(key), nullptr) << key;
  // Each goes to a file and back, with a value of its own.
  for (const base::ParameterSpec& spec : table.specs()) {
    const PrintPreset preset{"own", "Own", {}, {{spec.key, test::otherText(spec)}}};
    EXPECT_EQ(readPreset(presetText(preset), "own.json").settings.at(spec.key),
              base::formatParameter(base::parseParameter(spec, test::otherText(spec))))
        << spec.key;
  }
}

TEST_F(Presets, InheritFromParentsAndStateOnlyTheDifference) {
  saveOwnPreset({"base", "Base", "light", {{"walls", "3"}}});
  saveOwnPreset({"child", "Child", "base", {{"infillDensity", "0.5"}}});
  const Settings all = presetSettings(loadPreset("child"));
  EXPECT_EQ(all, (Settings{{"walls", "3"}, {"infillDensity", "0.5"}, {"sparsePattern", "gyroid"}}));
  // A change of the parent reaches the child.
  saveOwnPreset({"base", "Base", "light", {{"walls", "5"}}});
  EXPECT_EQ(presetSettings(loadPreset("child")).at("walls"), "5");
  // A project stores it without files of the user's.
  const std::string choice = presetChoice(loadPreset("child"));
  removeOwnPreset("child");
  removeOwnPreset("base");
  const PrintPreset stored = loadPreset(choice);
  EXPECT_EQ(stored.parent, "light");
  EXPECT_EQ(presetSettings(stored).at("walls"), "5");
  EXPECT_EQ(stored.settings.count("sparsePattern"), 0u) << "the program has it";
}

TEST_F(Presets, ADeletedParentHandsItsSettingsDown) {
  saveOwnPreset({"base", "Base", "light", {{"walls", "3"}, {"infillDensity", "0.3"}}});
  saveOwnPreset({"child", "Child", "base", {{"infillDensity", "0.5"}}});
  const Settings before = presetSettings(loadPreset("child"));
  removeOwnPreset("base");
  EXPECT_FALSE(std::filesystem::exists(own("base")));
  EXPECT_EQ(loadPreset("child").parent, "light");
  EXPECT_EQ(presetSettings(loadPreset("child")), before);
}

TEST_F(Presets, WithoutAParentOrInACircleAreRefusedInOneLine) {
  write("orphan", R"({"id": "orphan", "label": "Orphan", "parent": "gone", "settings": {}})");
  refused([] { presetSettings(loadPreset("orphan")); }, {"gone", "orphan", "does not exist"});
  write("a", R"({"id": "a", "label": "A", "parent": "b", "settings": {}})");
  write("b", R"({"id": "b", "label": "B", "parent": "a", "settings": {}})");
  write("self", R"({"id": "self", "label": "Self", "parent": "self", "settings": {}})");
  refused([] { presetSettings(loadPreset("a")); }, {"its own parent"});
  refused([] { presetSettings(loadPreset("self")); }, {"self", "its own parent"});
  project::Choices choices;
  choices.preset = "a";
  EXPECT_TRUE(settingsOfPreset(choices).empty());
  // Nothing of that kind is saved.
  saveOwnPreset({"one", "One", {}, {}});
  saveOwnPreset({"two", "Two", "one", {}});
  const std::string before = base::readFile(own("one"));
  refused([] { saveOwnPreset({"one", "One", "two", {}}); }, {"its own parent"});
  refused([] { saveOwnPreset({"one", "One", "nowhere", {}}); }, {"nowhere"});
  EXPECT_EQ(base::readFile(own("one")), before);
}

TEST_F(Presets, ThatCannotBeReadAreRefusedInOneLine) {
  const auto read = [](const std::string& text) { return [text] { readPreset(text, "x.json"); }; };
  refused(read("no JSON"), {"x.json", "not JSON"});
  refused(read("[]"), {"x.json", "object"});
  refused(read(R"({"label": "X", "settings": {}})"), {"x.json", "id"});
  refused(read(R"({"id": "x", "label": " ", "settings": {}})"), {"x.json", "label", "blank"});
  refused(read(R"({"id": "x", "label": "X"})"), {"x.json", "settings"});
  refused(read(R"({"id": "x", "label": "X", "settings": []})"), {"x.json", "settings", "object"});
  refused(read(R"({"id": "x", "label": "X", "settings": {}, "inherits": "usual"})"),
          {"x.json", "inherits"});
  refused(read(R"({"id": "x", "label": "X", "settings": {"wals": 3}})"),
          {"x.json", "wals", "did you mean walls"});
  refused(read(R"({"id": "x", "label": "X", "settings": {"walls": 300}})"),
          {"x.json", "walls", "300", "20"});
  refused(read(R"({"id": "x", "label": "X", "settings": {"walls": null}})"), {"x.json", "walls"});
  refused(read(R"({"id": "x", "label": "X", "settings": {"seam": "back"}})"),
          {"x.json", "seam", "back"});
  refused(read(R"({"id": "x", "label": "X", "settings": {"tool": 2}})"), {"x.json", "tool"});
  // A file under another name would never be found.
  write("other", R"({"id": "x", "label": "X", "settings": {}})");
  refused([] { loadPreset("other"); }, {"other.json", "'x'"});
  refused([] { loadPreset("strng"); }, {"strng", "did you mean strong"});
  refused([] { loadPreset("/nowhere/at-all.json"); }, {"/nowhere/at-all.json"});
  // Renamed settings keep their meaning.
  const PrintPreset old =
      readPreset(R"({"id": "x", "label": "X", "settings": {"infillTurn": 45}})", "x.json");
  EXPECT_EQ(old.settings, (Settings{{"infillRotation", "45"}}));
}

TEST_F(Presets, HaveNamesOfTheirOwn) {
  refused([] { checkPresetLabel("  ", {}); }, {"needs a name"});
  refused([] { checkPresetLabel("STRONG", {}); }, {"STRONG", "comes with the program"});
  saveOwnPreset({"mine", "Mine", "usual", {}});
  refused([] { checkPresetLabel("mine", {}); }, {"already"});
  EXPECT_NO_THROW(checkPresetLabel("Mine", "mine")) << "its own name";
  refused([] { saveOwnPreset({"../out", "Out", {}, {}}); }, {"../out"});
  refused([] { saveOwnPreset({"", "Out", {}, {}}); }, {"id"});
  EXPECT_EQ(freePresetId("My preset, 2"), "my-preset-2");
  EXPECT_EQ(freePresetId("Mine"), "mine-2");
  EXPECT_EQ(freePresetId("Strong"), "strong-2");
  EXPECT_EQ(freePresetId("\xE5\xBC\xBA"), "own");
  EXPECT_LE(freePresetId(std::string(500, 'x')).size(), 100u);
}

TEST_F(Presets, AFolderThatCannotBeWrittenChangesNothing) {
  write("mine", R"({"id": "mine", "label": "Mine", "settings": {}})");
  const std::string before = base::readFile(own("mine"));
  // A file where the folder should be: also the administrator cannot write into it.
  base::writeFile(folder_.path() / "file", "");
  setenv("VOLUTA_DATA", (folder_.path() / "file").c_str(), 1);
  refused([] { saveOwnPreset({"mine", "Mine", {}, {{"walls", "4"}}}); }, {"mine.json"});
  setenv("VOLUTA_DATA", folder_.path().c_str(), 1);
  EXPECT_EQ(base::readFile(own("mine")), before);
}

TEST_F(Presets, AreImportedWholeOrNotAtAll) {
  const std::filesystem::path file = folder_.path() / "given.json";
  base::writeFile(file, R"({"id": "given", "label": "Given", "parent": "gone", "settings": {}})");
  refused([&] { importablePreset(file); }, {"given.json", "gone", "does not exist"});
  base::writeFile(file, R"({"id": "strong", "label": "Stronger", "settings": {"walls": 9}})");
  refused([&] { importablePreset(file); }, {"strong", "comes with the program"});
  base::writeFile(file, R"({"id": "given", "label": "Given", "parent": "strong",)"
                        R"( "settings": {"walls": 9}})");
  EXPECT_EQ(presetSettings(importablePreset(file)).at("walls"), "9");
  EXPECT_EQ(presetSettings(loadPreset(file.string())).at("seam"), "spread");
  EXPECT_FALSE(std::filesystem::exists(own("given"))) << "only checked";
}

TEST_F(Presets, ChangeTheSettingsOfAJobAndNothingElse) {
  project::Choices choices;
  setParameters(choices,
                {"orient=fewestMissed", "walls=7", "retractMm=5", "liftMm=5", "accept=mass=0.1"});
  choices.items.resize(2);
  choices.item(1).parameters["layerHeightMm"] = "0.7";
  saveOwnPreset({"mine", "Mine", "strong", {{"layerHeightMm", "0.6"}}});
  const project::Choices mine = withPreset(choices, "Mine");
  for (std::size_t i = 0; i < 2; ++i) {
    const Settings given = givenParameters(project::onlyItem(mine, i));
    EXPECT_EQ(given.at("walls"), "4") << i;
    EXPECT_EQ(given.at("seam"), "spread") << i;
    EXPECT_EQ(given.at("layerHeightMm"), "0.6") << i;
    EXPECT_EQ(given.at("accept"), "mass=0.1") << i;
    EXPECT_FALSE(given.contains("retractMm")) << i;
    EXPECT_EQ(given.at("liftMm"), "5") << i << ": no setting of presets";
  }
  EXPECT_EQ(mine.item(0).parameters.at("orient"), "fewestMissed");
  EXPECT_EQ(itemSettingsOfPreset(mine),
            (Settings{{"infillDensity", "1"}, {"layerHeightMm", "0.6"}, {"walls", "4"}}))
      << "of a new part";
  // Changes that are kept, of the job and of each part.
  const project::Choices kept = withPreset(
      choices, "mine", {{{"walls", "7"}, {"retractMm", "5"}}, {{"layerHeightMm", "0.7"}}});
  EXPECT_EQ(kept.item(0).parameters.at("walls"), "7");
  EXPECT_EQ(kept.item(1).parameters.at("walls"), "4");
  EXPECT_EQ(kept.parameters.at("retractMm"), "5");
  EXPECT_EQ(kept.parameters.at("seam"), "spread");
  EXPECT_EQ(kept.item(0).parameters.at("layerHeightMm"), "0.6");
  EXPECT_EQ(kept.item(1).parameters.at("layerHeightMm"), "0.7");
}

TEST_F(Presets, AreMadeOfTheSettingsThatDiffer) {
  const base::ParameterTable defaults = parametersOf(project::Choices());
  const PrintPreset strong = loadPreset("strong");
  Settings chosen = presetSettings(strong);
  chosen["walls"] = "6";
  chosen.erase("seam"); // the default
  const PrintPreset mine = presetWith(chosen, defaults, strong, "mine", "Mine");
  EXPECT_EQ(mine, (PrintPreset{"mine", "Mine", "strong", {{"walls", "6"}, {"seam", "nearest"}}}));
  EXPECT_TRUE(settingDifferences(presetSettings(mine), chosen, defaults).empty());
  saveOwnPreset(mine);
  // Saved again, with one change taken back and another added.
  chosen["walls"] = "4";
  chosen["brimWidthMm"] = "5";
  const PrintPreset again = presetWith(chosen, defaults, mine, "mine", "Mine");
  EXPECT_EQ(again,
            (PrintPreset{"mine", "Mine", "strong", {{"brimWidthMm", "5"}, {"seam", "nearest"}}}));
  const auto differences =
      settingDifferences(presetSettings(strong), presetSettings(again), defaults);
  ASSERT_EQ(differences.size(), 2u);
  EXPECT_EQ(differences.front().spec.key, "brimWidthMm");
  EXPECT_EQ(differences.front().second, base::ParameterValue(5.0));
  EXPECT_EQ(differences.back().spec.key, "seam");
  // The form marks what differs from the preset.
  const base::ParameterTable marked = withPresetDefaults(defaults, presetSettings(strong));
  EXPECT_EQ(marked.find("walls")->defaultValue, base::ParameterValue(4LL));
  EXPECT_EQ(marked.find("brimWidthMm")->defaultValue, defaults.find("brimWidthMm")->defaultValue);
}

TEST_F(Presets, AreKeptInAProject) {
  saveOwnPreset({"mine", "Mine", "strong", {{"walls", "6"}}});
  project::Job job = test::sampleJob();
  job.choices = withPreset(job.choices, "mine");
  const std::string bytes = project::jobBytes(job);
  removeOwnPreset("mine");
  const project::Job read = project::jobOf(bytes, "job", allParameters());
  EXPECT_EQ(read.choices.preset, job.choices.preset);
  EXPECT_EQ(loadPreset(read.choices.preset).label, "Mine");
  EXPECT_EQ(givenParameters(read.choices), givenParameters(job.choices));
  EXPECT_EQ(settingsOfPreset(read.choices).at("walls"), "6");
}

class PresetCommands : public test::CommandLine {
protected:
  void SetUp() override { setenv("VOLUTA_DATA", (folder_ / "data").c_str(), 1); }
  void TearDown() override { unsetenv("VOLUTA_DATA"); }

  // Plans a box up to its layers with the words, and returns the choices of the project.
  project::Choices planned(std::vector<std::string> words) const {
    std::vector<std::string> all{"plan",     smallBox(), "-o",      (folder_ / "out").string(),
                                 "--mode",   "flat",     "--until", "layers",
                                 "--replace"};
    all.insert(all.end(), words.begin(), words.end());
    const test::Ended ended = run(all);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return project::readJob(folder_ / "out" / "job.voluta", allParameters()).choices;
  }
};

TEST_F(PresetCommands, APresetIsPlannedByIdNameAndFile) {
  for (const char* name : {"strong", "Strong"}) {
    const project::Choices choices = planned({"--preset", name, "--set", "walls=3"});
    EXPECT_EQ(choices.preset, "strong") << name;
    EXPECT_EQ(givenParameters(choices).at("seam"), "spread") << name;
    EXPECT_EQ(givenParameters(choices).at("walls"), "3") << name;
  }
  const std::string file = (folder_ / "mine.json").string();
  base::writeFile(file, R"({"id": "mine", "label": "Mine", "parent": "light",)"
                        R"( "settings": {"walls": 5}})");
  const project::Choices choices = planned({"--preset", file});
  EXPECT_EQ(loadPreset(choices.preset).label, "Mine") << "the project needs no file";
  EXPECT_EQ(givenParameters(choices).at("walls"), "5");
  EXPECT_EQ(givenParameters(choices).at("infillDensity"), "0.2");
}

TEST_F(PresetCommands, ReportsNameThePresetItsChangesAndThePauses) {
  const std::string part = smallBox();
  const auto out = folder_ / "out";
  const test::Ended ended = run({"plan", part, part, "-o", out.string(), "--mode", "flat",
                                 "--preset", "Strong", "--set", "seam=aligned", "--set",
                                 "pauseLayers=4", "--part", "2:walls=3", "--format", "urscript"});
  EXPECT_TRUE(ended.code == 0 || ended.code == 4) << ended.err;
  const auto json = [&](const char* file) {
    return nlohmann::json::parse(base::readFile(out / file));
  };
  std::string proof;
  for (const std::string& name : names(out))
    if (name.ends_with(".proof.json"))
      proof = name;
  ASSERT_FALSE(proof.empty());
  for (const nlohmann::json& report : {json("report.json"), json(proof.c_str())}) {
    EXPECT_EQ(report.at("preset").at("name"), "Strong");
    EXPECT_EQ(report.at("preset").at("changed"),
              (std::vector<std::string>{"seam=aligned", "2:walls=3"}));
    EXPECT_EQ(report.at("pauses"), (std::vector<int>{4, 14}));
  }
  const std::string page = base::readFile(out / (proof.substr(0, proof.size() - 4) + "html"));
  EXPECT_NE(page.find("Strong; changed: seam=aligned, 2:walls=3"), std::string::npos);
  EXPECT_NE(page.find("Pauses before layers"), std::string::npos);
}

TEST_F(PresetCommands, WrongOnesAreRefusedInOneLine) {
  const std::string part = smallBox(), out = (folder_ / "out").string();
  const auto refused = [&](const std::string& preset) {
    const test::Ended ended = run({"plan", part, "-o", out, "--preset", preset});
    EXPECT_NE(ended.code, 0);
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
    return ended.err;
  };
  EXPECT_NE(refused("strng").find("did you mean strong?"), std::string::npos);
  EXPECT_NE(refused("/nowhere.json").find("/nowhere.json"), std::string::npos);
  base::writeFile(folder_ / "x.json", R"({"id": "x", "label": "X", "settings": {"wals": 3}})");
  const std::string line = refused((folder_ / "x.json").string());
  EXPECT_NE(line.find("x.json"), std::string::npos) << line;
  EXPECT_NE(line.find("did you mean walls?"), std::string::npos) << line;
  EXPECT_FALSE(std::filesystem::exists(out));
  // A torn file of one's own does not keep the others from being listed.
  std::filesystem::create_directories(folder_ / "data" / "presets");
  base::writeFile(folder_ / "data" / "presets" / "torn.json", "{");
  const test::Ended listed = run({"list", "presets"});
  EXPECT_EQ(listed.code, 0);
  EXPECT_NE(listed.out.find("torn"), std::string::npos);
  EXPECT_NE(listed.out.find("Fast draft"), std::string::npos);
}

} // namespace
} // namespace voluta::pipeline
