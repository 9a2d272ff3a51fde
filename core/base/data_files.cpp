#include "base/data_files.h"

#include "base/error.h"
#include "base/files.h"
#include "base/nearest_name.h"

#include <algorithm>

namespace voluta::base {

std::vector<std::string> dataFileIds(const std::string& folder) {
  std::vector<std::string> ids;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(resourceFolder() / folder, none))
    if (entry.path().extension() == ".json")
      ids.push_back(entry.path().stem().string());
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::filesystem::path dataFile(const std::string& folder, const std::string& id, Text unknown) {
  const std::vector<std::string> ids = dataFileIds(folder);
  if (std::find(ids.begin(), ids.end(), id) == ids.end())
    throw Error(ErrorCode::Usage, Message(unknown, {id}), {}, didYouMean(id, ids));
  return resourceFolder() / folder / (id + ".json");
}

} // namespace voluta::base
