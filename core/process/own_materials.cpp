#include "process/own_materials.h"

#include "base/data_files.h"
#include "base/files.h"
#include "base/inherited_text.h"
#include "process/library.h"
#include "process/process.h"

#include <nlohmann/json.hpp>

namespace voluta::process {

Material chosenMaterial(const std::string& choice) {
  return base::isDataFileName(choice) ? readMaterialText(base::readFile(choice), choice)
                                      : loadMaterial(choice);
}

std::filesystem::path importMaterial(const std::filesystem::path& file) {
  return importItem(Shelf::Materials, file);
}

void exportMaterial(const std::string& id, const std::filesystem::path& file) {
  base::writeFile(file, materialText(loadMaterial(id)));
}

std::string processTextWith(const std::string& choice, const std::string& material) {
  const Material chosen = chosenMaterial(material);
  loadProcess(choice); // reports what is wrong with the process
  const base::DataText data = base::dataText("processes", choice, "unknown process '{id}'"_text);
  auto json =
      nlohmann::ordered_json::parse(base::wholeText("processes", data.text, data.file.string()));
  json["material"] = chosen.id;
  json.erase("ownMaterial");
  if (!chosen.comesWithProgram)
    json["ownMaterial"] = nlohmann::ordered_json::parse(materialText(chosen));
  json.erase("densityGPerCm3");
  json.erase("bridgeMm");
  return json.dump(2) + "\n";
}

} // namespace voluta::process
