// Own processes and materials: written as they are read, changed field by field, refused in one
// line.
#include "process/library.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"
#include "helpers/temporary_folder.h"
#include "process/bead_model.h"
#include "process/feature_flow.h"
#include "process/library_fields.h"
#include "process/own_materials.h"
#include "process/process_numbers.h"
#include "process/process_text.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

namespace voluta::process {
namespace {

using Json = nlohmann::json;

class Library : public ::testing::Test {
protected:
  void SetUp() override {
    setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
    setenv("VOLUTA_DATA", folder_.path().c_str(), 1);
  }
  void TearDown() override { unsetenv("VOLUTA_DATA"); }

  std::filesystem::path fileOf(Shelf shelf, const std::string& id) const {
    return folder_.path() / (shelf == Shelf::Materials ? "materials" : "processes") /
           (id + ".json");
  }

  test::TemporaryFolder folder_;
};

double share(std::mt19937_64& random) {
  return static_cast<double>(random() % 100001) / 100000.0;
}

// A factory process with every number drawn again within the rules of the reader.
Process randomProcess(std::mt19937_64& random) {
  const std::vector<std::string> ids{"fdm-0.4", "pellet-4", "concrete-50", "wire-arc-1.2"};
  Process p = loadProcess(ids[random() % ids.size()]);
  p.id = "own-" + std::to_string(random() % 1000);
  p.label = "\"head\": null, \xC3\xA8 \n " + std::to_string(random() % 1000);
  for (const ProcessNumber& row : processNumbers())
    p.*row.value = row.mayBeZero && random() % 4 == 0
                       ? 0.0
                       : std::clamp(1e-3 + row.maximum * std::pow(share(random), 5.0), row.minimum,
                                    row.maximum);
  const auto order = [](double& minimum, double& usual, double& maximum) {
    std::array<double, 3> sorted{minimum, usual, maximum};
    std::ranges::sort(sorted);
    minimum = sorted[0], usual = sorted[1], maximum = sorted[2];
  };
  order(p.layerHeightMinMm, p.layerHeightMm, p.layerHeightMaxMm);
  order(p.beadWidthMinMm, p.beadWidthMm, p.beadWidthMaxMm);
  if (p.layerHeightMm > p.beadWidthMm) {
    std::swap(p.layerHeightMm, p.beadWidthMm);
    order(p.layerHeightMinMm, p.layerHeightMm, p.layerHeightMaxMm);
    order(p.beadWidthMinMm, p.beadWidthMm, p.beadWidthMaxMm);
  }
  p.layerHeightMm = std::min(p.layerHeightMm, p.beadWidthMm);
  p.layerHeightMinMm = std::min(p.layerHeightMinMm, p.layerHeightMm);
  p.contactToleranceMm = 0.9 * share(random) * p.layerHeightMaxMm;
  p.speedMmPerS = 0.001 + 0.1 * share(random);
  p.maxFlowMm3PerS = 1e6;
  p.head.sections.clear();
  double z = 0.0;
  for (std::size_t i = 0; i < 2 + random() % 8; ++i) {
    p.head.sections.push_back({z, 50.0 * share(random)});
    z += i > 0 && random() % 3 == 0 ? 0.0 : 0.01 + 20.0 * share(random);
  }
  for (const FeatureNumber& row : featureNumbers())
    if (random() % 2 == 0)
      p.features.of(row.feature).*row.value =
          row.key == "flow" ? kMinFlow + (kMaxFlow - kMinFlow) * share(random)
          : row.key == "widthMm"
              ? p.beadWidthMm + (p.beadWidthMaxMm - p.beadWidthMm) * share(random)
              : 0.001 + 100.0 * share(random);
  if (random() % 3 == 0) {
    p.material = loadMaterial("petg");
    p.material.id = "own-petg";
    p.material.comesWithProgram = false;
    p.material.densityGPerCm3 = 0.1 + share(random);
    if (random() % 2 == 0)
      p.material.bridgeMm = p.bridgeMm + share(random);
  }
  return p;
}

TEST_F(Library, everyProcessOfTheProgramIsReadAsItWasWritten) {
  for (const std::string& id : processIds()) {
    SCOPED_TRACE(id);
    const Process p = loadProcess(id);
    const std::string text = processText(p);
    EXPECT_TRUE(sameProcess(readProcessText(text, id), p)) << text;
    EXPECT_EQ(processText(readProcessText(text, id)), text);
    EXPECT_NE(text.find("\n  \"head\": [["), std::string::npos) << "in one line";
  }
}

TEST_F(Library, randomProcessesAreReadAsTheyWereWritten) {
  std::mt19937_64 random(11);
  for (int n = 0; n < 300; ++n) {
    const Process p = randomProcess(random);
    const std::string text = processText(p);
    const Process back = readProcessText(text, "a.json");
    EXPECT_TRUE(sameProcess(back, p)) << text;
    EXPECT_EQ(back.bridgeMm, p.bridgeMm);
    EXPECT_EQ(back.material, p.material);
    EXPECT_EQ(back.head.sections.size(), p.head.sections.size());
  }
}

// One value in a random place of a JSON document is replaced or dropped.
void mutate(Json& json, std::mt19937_64& random) {
  Json* at = &json;
  while (at->is_structured() && !at->empty() && (at == &json || random() % 3 != 0)) {
    auto child = at->begin();
    std::advance(child, static_cast<long>(random() % at->size()));
    if (random() % 12 == 0) {
      at->erase(child);
      return;
    }
    at = &*child;
  }
  const std::vector<Json> values{0,    -1,     1e-9,          1e300,          -0.0, 3,   "a",  "",
                                 true, Json(), Json::array(), Json::object(), 0.5,  200, 2.5e6};
  *at = values[random() % values.size()];
}

TEST_F(Library, damagedProcessesAreReadOrRefusedInOneLine) {
  std::mt19937_64 random(12);
  int refused = 0, read = 0;
  for (int n = 0; n < 600; ++n) {
    Json json = Json::parse(processText(randomProcess(random)));
    for (std::size_t k = 0; k < 1 + random() % 2; ++k)
      mutate(json, random);
    try {
      const Process p = readProcessText(json.dump(), "own.json");
      EXPECT_TRUE(sameProcess(readProcessText(processText(p), "own.json"), p)) << json.dump();
      ++read;
    } catch (const base::Error& error) {
      const std::string line = error.what();
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
      EXPECT_TRUE(line.find("own.json") != std::string::npos ||
                  error.code() == base::ErrorCode::Usage)
          << line;
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
  EXPECT_GT(read, 20);
}

TEST_F(Library, damagedMaterialsAreReadOrRefusedInOneLine) {
  std::mt19937_64 random(15);
  int refused = 0;
  for (int n = 0; n < 600; ++n) {
    const std::vector<std::string> ids = materialIds();
    Json json = Json::parse(materialText(loadMaterial(ids[random() % ids.size()])));
    for (std::size_t k = 0; k < 1 + random() % 2; ++k)
      mutate(json, random);
    try {
      const Material m = readMaterialText(json.dump(), "own.json");
      EXPECT_EQ(readMaterialText(materialText(m), "own.json"), m) << json.dump();
    } catch (const base::Error& error) {
      const std::string line = error.what();
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
      EXPECT_NE(line.find("own.json"), std::string::npos) << line;
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
}

TEST_F(Library, damagedTextsAreReadOrRefused) {
  std::mt19937_64 random(13);
  for (int n = 0; n < 400; ++n) {
    std::string text = processText(randomProcess(random));
    for (int k = 0; k < 2; ++k) {
      const std::size_t at = random() % text.size();
      if (random() % 2 == 0)
        text[at] = static_cast<char>(random() % 256);
      else
        text.erase(at, 1 + random() % 5);
    }
    try {
      const Process p = readProcessText(text, "own.json");
      EXPECT_TRUE(sameProcess(readProcessText(processText(p), "own.json"), p)) << text;
    } catch (const base::Error&) {
    }
  }
}

double valueOf(const LibraryItem& item, const std::string& key) {
  for (const LibraryField& field : libraryFields(item))
    if (field.spec.key == key)
      return std::get<double>(field.get(item));
  ADD_FAILURE() << key;
  return 0.0;
}

LibraryItem withValue(LibraryItem item, const std::string& key, const base::ParameterValue& value) {
  for (const LibraryField& field : libraryFields(item))
    if (field.spec.key == key) {
      field.set(item, value);
      return item;
    }
  ADD_FAILURE() << key;
  return item;
}

// Expects a problem beside the field, in one line.
void expectProblem(const LibraryItem& item, const std::string& key, const std::string& named) {
  SCOPED_TRACE(key);
  const std::optional<FieldProblem> problem = problemOf(item);
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->key, key);
  const std::string line = base::english(problem->reason);
  EXPECT_NE(line.find(named), std::string::npos) << line;
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  EXPECT_THROW(saveOwn(item.named("own", item.label())), base::Error);
}

TEST_F(Library, everyNumberOfAProcessIsChecked) {
  const LibraryItem item = loadItem(Shelf::Processes, "fdm-0.4");
  ASSERT_FALSE(problemOf(item));
  int rows = 0;
  for (const ProcessNumber& row : processNumbers()) {
    const std::string key(row.key);
    expectProblem(withValue(item, key, row.minimum - 1.0), key,
                  row.minimum != 0.0 ? "is below"
                  : row.mayBeZero    ? "negative"
                                     : "greater than 0");
    EXPECT_EQ(problemOf(withValue(item, key, 0.0)).has_value(), !row.mayBeZero) << key;
    const bool isMinOrUsual = key.ends_with(".min") || key.ends_with(".default");
    if (!isMinOrUsual)
      expectProblem(withValue(item, key, 2.0 * row.maximum), key, "check the unit");
    ++rows;
  }
  EXPECT_EQ(rows, 21);
  for (const FeatureNumber& row : featureNumbers()) {
    const std::string key = "features." + std::string(row.featureKey) + "." + std::string(row.key);
    expectProblem(withValue(item, key, -1.0), key, "");
    EXPECT_EQ(problemOf(withValue(item, key, 0.0)).has_value(), row.key == "flow") << key;
  }
  for (int i = 0; i < 4; ++i) {
    const std::string key = "overhangSpeed[" + std::to_string(i) + "]";
    expectProblem(withValue(item, key, 0.0), key, "between");
  }
  expectProblem(withValue(item, "densityGPerCm3", 1240.0), "densityGPerCm3", "check the unit");
  expectProblem(withValue(item, "densityGPerCm3", 0.0), "densityGPerCm3", "greater than 0");
  expectProblem(withValue(item, "label", std::string()), "label", "empty");
}

TEST_F(Library, contradictingLimitsAreShownBesideTheirField) {
  const LibraryItem item = loadItem(Shelf::Processes, "fdm-1.0");
  expectProblem(withValue(item, "beadWidthMm.default", 9.0), "beadWidthMm.default", "'max'");
  expectProblem(withValue(item, "beadWidthMm.default", 0.5), "beadWidthMm.default", "'min'");
  expectProblem(withValue(item, "layerHeightMm.min", 0.9), "layerHeightMm.default", "'min'");
  expectProblem(withValue(item, "layerHeightMm.max", 0.7), "layerHeightMm.default", "'max'");
  expectProblem(withValue(withValue(item, "layerHeightMm.max", 2.0), "layerHeightMm.default", 1.8),
                "layerHeightMm.default", "beadWidthMm");
  expectProblem(withValue(item, "contactToleranceMm", 1.5), "contactToleranceMm", "layerHeightMm");
  expectProblem(withValue(item, "maxFlowMm3PerS", 1.0), "maxFlowMm3PerS", "speedMmPerS");
  expectProblem(withValue(item, "features.outerWall.widthMm", 0.5), "features.outerWall.widthMm",
                "between");
  LibraryItem sunken = item;
  std::get<Process>(sunken.data).head.sections = {{0.0, 1.0}, {-2.0, 3.0}};
  expectProblem(sunken, "head", "negative");
  std::get<Process>(sunken.data).head.sections = {{0.0, 1.0}, {8.0, 3.0}, {7.0, 3.0}};
  expectProblem(sunken, "head", "does not rise");
  std::get<Process>(sunken.data).head.sections = {{0.0, 1.0}};
  expectProblem(sunken, "head", "two sections");
}

TEST_F(Library, everyNumberOfAMaterialIsChecked) {
  const LibraryItem item = loadItem(Shelf::Materials, "petg");
  const std::tuple<const char*, double, const char*> rows[] = {
      {"densityGPerCm3", 0.0, "greater than 0"},
      {"densityGPerCm3", 1240.0, "check the unit"},
      {"nozzleC.min", 0.0, "greater than 0"},
      {"nozzleC.max", 0.0, "greater than 0"},
      {"nozzleC.max", 1200.0, "above 1000"},
      {"nozzleC.default", 90.0, "'min'"},
      {"nozzleC.default", 400.0, "'max'"},
      {"bedC", 300.0, "above 250"},
      {"fan", 1.5, "above 1"},
      {"bridgeFan", 1.5, "above 1"},
      {"bridgeWidths", -1.0, "negative"},
      {"pricePerKg", -1.0, "negative"}};
  expectProblem(withValue(item, "bridges", std::string("0.4, 20; 0.4, 8")), "bridges", "wider");
  expectProblem(withValue(item, "bridges", std::string("0.4; 20")), "bridges", "number");
  expectProblem(withValue(item, "bridges", std::string("0.4, -1")), "bridges", "negative");
  EXPECT_FALSE(problemOf(withValue(item, "bridges", std::string("0.4, 20; 1,8"))));
  EXPECT_FALSE(problemOf(withValue(item, "bridges", std::string())));
  for (const auto& [key, value, reason] : rows)
    expectProblem(withValue(item, key, value), key, reason);
  expectProblem(withValue(item, "colour", std::string("red")), "colour", "#RRGGBB");
  expectProblem(withValue(item, "label", std::string()), "label", "empty");
  for (const char* optional :
       {"bedC", "bridgeFan", "maxFlowMm3PerS", "bridgeMm", "nozzleC.default"}) {
    const double none = [&] {
      for (const LibraryField& field : libraryFields(item))
        if (field.spec.key == optional)
          return field.spec.minimum;
      return 0.0;
    }();
    const LibraryItem without = withValue(item, optional, none);
    EXPECT_FALSE(problemOf(without)) << optional;
    EXPECT_EQ(readItem(Shelf::Materials, itemText(without), "a").id(), "petg");
  }
}

TEST_F(Library, aFieldChangesNothingElse) {
  std::mt19937_64 random(14);
  for (int n = 0; n < 20; ++n) {
    const LibraryItem item{randomProcess(random), ""};
    for (const LibraryField& field : libraryFields(item)) {
      LibraryItem same = item;
      field.set(same, field.get(item));
      EXPECT_TRUE(same == item) << field.spec.key;
      if (!std::holds_alternative<double>(field.get(item)))
        continue;
      LibraryItem changed = item;
      field.set(changed, std::get<double>(field.get(item)) + 0.25);
      const std::vector<FieldDifference> found = differences(item, changed);
      ASSERT_EQ(found.size(), 1u) << field.spec.key;
      EXPECT_EQ(found.front().spec.key, field.spec.key);
      EXPECT_EQ(found.front().first, field.get(item));
      EXPECT_EQ(found.front().second, field.get(changed));
    }
  }
  LibraryItem one = loadItem(Shelf::Processes, "fdm-0.4"), other = one;
  EXPECT_TRUE(differences(one, other).empty());
  std::get<Process>(other.data).head.sections.back().radiusMm = 25.0;
  ASSERT_EQ(differences(one, other).size(), 1u);
  EXPECT_EQ(differences(one, other).front().spec.key, "head");
}

TEST_F(Library, anOwnProcessIsDuplicatedSavedListedAndRemoved) {
  const LibraryItem factory = loadItem(Shelf::Processes, "fdm-1.0");
  LibraryItem own = duplicateOf(factory);
  EXPECT_EQ(own.id(), "fdm-1.0-own");
  EXPECT_EQ(own.basedOn, "fdm-1.0");
  own = withValue(own, "beadWidthMm.default", 1.5);
  const std::size_t before = libraryIds(Shelf::Processes).size();
  saveOwn(own);
  EXPECT_EQ(libraryIds(Shelf::Processes).size(), before + 1);
  EXPECT_TRUE(loadItem(Shelf::Processes, "fdm-1.0-own") == own);
  EXPECT_EQ(loadProcess("fdm-1.0-own").beadWidthMm, 1.5) << "the job's reader knows it";
  EXPECT_EQ(duplicateOf(factory).id(), "fdm-1.0-own-2");
  EXPECT_FALSE(comesWithProgram(Shelf::Processes, own.id()));
  EXPECT_EQ(jobChoice(factory), "fdm-1.0");
  const std::string travels = jobChoice(own);
  removeOwn(Shelf::Processes, own.id());
  EXPECT_EQ(libraryIds(Shelf::Processes).size(), before);
  EXPECT_EQ(loadProcess(travels).beadWidthMm, 1.5) << "without its file";
  EXPECT_THROW(removeOwn(Shelf::Processes, "fdm-1.0"), base::Error);
}

// Of every item a copy is made that differs in one field; then its parent changes in all others.
TEST_F(Library, ownItemsFollowTheirParentsInAllOtherFields) {
  for (const Shelf shelf : {Shelf::Materials, Shelf::Processes})
    for (const std::string& id : libraryIds(shelf)) {
      SCOPED_TRACE(id);
      LibraryItem parent = duplicateOf(loadItem(shelf, id));
      EXPECT_TRUE(parent.inherits);
      saveOwn(parent);
      EXPECT_TRUE(loadItem(shelf, parent.id()) == parent);
      const auto stated = Json::parse(base::readFile(fileOf(shelf, parent.id())));
      EXPECT_EQ(stated.size(), 3u) << "id, label, inherits: " << stated.dump();
      EXPECT_EQ(stated.at("inherits"), id);

      LibraryItem child = duplicateOf(parent);
      const std::string own = shelf == Shelf::Materials ? "pricePerKg" : "travelSpeedMmPerS";
      child = withValue(child, own, 77.0);
      saveOwn(child);
      EXPECT_TRUE(loadItem(shelf, child.id()).inherits);
      EXPECT_TRUE(loadItem(shelf, child.id()) == child);

      const std::string other =
          shelf == Shelf::Materials ? "densityGPerCm3" : "accelerationMmPerS2";
      parent = withValue(withValue(parent, other, 9.5), own, 11.0);
      saveOwn(parent);
      child = loadItem(shelf, child.id());
      EXPECT_EQ(valueOf(child, other), 9.5);
      EXPECT_EQ(valueOf(child, own), 77.0);

      // The job and the exported file need no parent.
      const std::string whole = itemText(child);
      EXPECT_EQ(whole.find("inherits"), std::string::npos);
      // Another name of the parent reaches the child, and its end leaves the child's values.
      renameOwn(parent, "renamed");
      EXPECT_EQ(loadItem(shelf, child.id()).basedOn, "renamed");
      removeOwn(shelf, "renamed");
      const LibraryItem left = loadItem(shelf, child.id());
      EXPECT_EQ(left.basedOn, id);
      EXPECT_TRUE(left.inherits) << "from the parent's parent";
      EXPECT_EQ(valueOf(left, other), 9.5);
      EXPECT_EQ(valueOf(left, own), 77.0);
      removeOwn(shelf, child.id());
    }
}

TEST_F(Library, parentsThatAreMissingOrInACircleAreRefusedInOneLine) {
  const auto refused = [](const std::string& text, const std::vector<std::string>& words) {
    try {
      readItem(Shelf::Materials, text, "x.json");
      ADD_FAILURE() << text;
    } catch (const base::Error& error) {
      const std::string line = error.what();
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
      for (const std::string& word : words)
        EXPECT_NE(line.find(word), std::string::npos) << line << " lacks " << word;
    }
  };
  refused(R"({"id": "x", "label": "X", "inherits": "gone"})",
          {"x.json", "'x'", "'gone'", "does not exist"});
  refused(R"({"id": "x", "label": "X", "inherits": "x"})", {"x.json", "'x'", "from itself"});
  const auto write = [&](const std::string& id, const std::string& parent) {
    const auto file = fileOf(Shelf::Materials, id);
    std::filesystem::create_directories(file.parent_path());
    base::writeFile(file,
                    R"({"id": ")" + id + R"(", "label": "L", "inherits": ")" + parent + "\"}");
  };
  write("a", "b");
  write("b", "a");
  refused(R"({"id": "x", "label": "X", "inherits": "a"})", {"from itself"});
  refused(R"({"id": "x", "label": "X", "inherits": "pla", "fan": 7})", {"x.json", "fan"});
  refused(R"({"id": "x", "label": "X", "inherits": "pla", "fann": 1})", {"x.json", "fann"});
  EXPECT_NE(labelOrProblem(Shelf::Materials, "a").find("from itself"), std::string::npos);
  // null states that there is none.
  const LibraryItem unheated = readItem(
      Shelf::Materials, R"({"id": "x", "label": "X", "inherits": "pla", "bedC": null})", "x.json");
  EXPECT_FALSE(std::get<Material>(unheated.data).bedC);
  EXPECT_EQ(std::get<Material>(unheated.data).densityGPerCm3, loadMaterial("pla").densityGPerCm3);
}

TEST_F(Library, aProcessFileThatInheritsIsImportedAndPlansWithoutItsParent) {
  const auto file = folder_ / "mine.json";
  base::writeFile(file,
                  R"({"id": "mine", "label": "Mine", "inherits": "fdm-0.4", "speedMmPerS": 22,)"
                  R"( "layerHeightMm": {"max": 0.3}})");
  importItem(Shelf::Processes, file);
  const LibraryItem mine = loadItem(Shelf::Processes, "mine");
  EXPECT_TRUE(mine.inherits);
  EXPECT_EQ(mine.process()->speedMmPerS, 22.0);
  EXPECT_EQ(mine.process()->layerHeightMm, 0.2);
  EXPECT_EQ(mine.process()->layerHeightMaxMm, 0.3);
  const std::string travels = jobChoice(mine);
  removeOwn(Shelf::Processes, "mine");
  EXPECT_TRUE(sameProcess(loadProcess(travels), *mine.process()));
}

TEST_F(Library, idsAreFileNamesAndBeadsFitTheirNozzle) {
  const auto check = [](LibraryItem item) {
    try {
      checkItem(item, "own.json");
    } catch (const base::Error& error) {
      EXPECT_EQ(std::string(error.what()).find("own.json: "), 0u);
      return std::string(error.what());
    }
    return std::string();
  };
  for (const Shelf shelf : {Shelf::Processes, Shelf::Materials})
    for (const std::string& id : libraryIds(shelf)) {
      const LibraryItem item = loadItem(shelf, id);
      EXPECT_EQ(check(item), "") << id;
      for (const char* wrong : {"", "../../x", "a b", ".x"})
        EXPECT_NE(check(item.named(wrong, "own")).find("cannot be a"), std::string::npos) << wrong;
    }
  Process process = loadProcess("fdm-1.0");
  for (const auto& [nozzle, fits] : {std::pair(0.05, false), std::pair(0.5, true),
                                     std::pair(3.0, true), std::pair(50.0, false)}) {
    process.nozzleDiameterMm = nozzle;
    EXPECT_EQ(check({process, {}}).empty(), fits) << nozzle;
  }
}

TEST_F(Library, filesAreImportedAndThoseOfTheProgramKept) {
  const std::string text =
      base::readFile(std::string(VOLUTA_SOURCE_DIR) + "/resources/processes/fdm-1.0.json");
  base::writeFile(folder_ / "a.json", text);
  EXPECT_THROW(importItem(Shelf::Processes, folder_ / "a.json"), base::Error);
  for (const char* id : {"", "../a", "A b", ".hidden", "fdm-0.4"})
    EXPECT_THROW(saveOwn(loadItem(Shelf::Processes, "fdm-1.0").named(id, "Own")), base::Error)
        << id;
  base::writeFile(folder_ / "b.json",
                  itemText(loadItem(Shelf::Processes, "fdm-1.0").named("mine", "Mine")));
  importItem(Shelf::Processes, folder_ / "b.json");
  EXPECT_EQ(loadProcess("mine").label, "Mine");
}

// An own material is stored within the process: the library may be on another machine.
TEST_F(Library, anOwnMaterialTravelsWithItsProcess) {
  LibraryItem material = duplicateOf(loadItem(Shelf::Materials, "petg"));
  material = withValue(material, "densityGPerCm3", 1.31);
  saveOwn(material);
  LibraryItem own = withValue(duplicateOf(loadItem(Shelf::Processes, "fdm-1.0")), "material",
                              std::string("petg-own"));
  saveOwn(own);
  const std::string travels = jobChoice(own);
  removeOwn(Shelf::Materials, "petg-own");
  EXPECT_EQ(loadProcess(travels).material.densityGPerCm3, 1.31);
  EXPECT_EQ(loadProcess("fdm-1.0-own").material.densityGPerCm3, 1.31);
}

} // namespace
} // namespace voluta::process
