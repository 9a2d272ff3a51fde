#include "process/own_materials.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"
#include "process/process.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

namespace voluta::process {

namespace {
constexpr const char* kFolder = "materials";

bool isFileName(const std::string& id) {
  constexpr std::string_view kAllowed = "abcdefghijklmnopqrstuvwxyz0123456789-_.";
  return !id.empty() && id.front() != '.' && id.find_first_not_of(kAllowed) == std::string::npos;
}

[[noreturn]] void refuse(const std::filesystem::path& file, base::Message reason,
                         base::Message remedy) {
  throw base::Error(base::ErrorCode::UnusableInput, std::move(reason), file.string(),
                    std::move(remedy));
}
} // namespace

Material chosenMaterial(const std::string& choice) {
  return base::isDataFileName(choice) ? readMaterialText(base::readFile(choice), choice)
                                      : loadMaterial(choice);
}

std::filesystem::path importMaterial(const std::filesystem::path& file) {
  const Material material = readMaterialText(base::readFile(file), file.string());
  if (!isFileName(material.id))
    refuse(file, base::message("'{id}' cannot be a material's id"_text, material.id),
           "use small letters, digits, '-', '_' and '.'"_text);
  const std::filesystem::path name = std::filesystem::path(kFolder) / (material.id + ".json");
  std::error_code none;
  if (std::filesystem::exists(base::resourceFolder() / name, none))
    refuse(file, base::message("a material '{id}' comes with the program"_text, material.id),
           "choose another id"_text);
  const std::filesystem::path copy = base::userDataFolder() / name;
  std::filesystem::create_directories(copy.parent_path(), none); // writeFile() reports a failure
  base::writeFile(copy, materialText(material));
  return copy;
}

void exportMaterial(const std::string& id, const std::filesystem::path& file) {
  base::writeFile(file, materialText(loadMaterial(id)));
}

std::string processTextWith(const std::string& choice, const std::string& material) {
  const Material chosen = loadMaterial(material);
  loadProcess(choice); // reports what is wrong with the process
  const base::DataText data = base::dataText("processes", choice, "unknown process '{id}'"_text);
  auto json = nlohmann::ordered_json::parse(data.text);
  json["material"] = chosen.id;
  json.erase("ownMaterial");
  if (!chosen.comesWithProgram)
    json["ownMaterial"] = nlohmann::ordered_json::parse(materialText(chosen));
  json.erase("densityGPerCm3");
  json.erase("bridgeMm");
  return json.dump(2) + "\n";
}

} // namespace voluta::process
