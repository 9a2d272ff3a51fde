#include "robot/cell/cell_file_writer.h"

#include "robot/cell/json_output.h"

#include <nlohmann/json.hpp>

namespace voluta::robot {

std::string cellFileJson(const CellDescription& cell, const std::vector<JointKind>& kinds) {
  using Json = nlohmann::ordered_json;
  const bool plateMoves = cell.nozzleMount == Mount::World;
  Json obstacles = Json::array(), home = Json::array(), never = Json::array();
  for (const Body& body : cell.obstacles)
    obstacles.push_back({{"name", body.name}, {"shapes", shapesJson(body.shapes)}});
  for (Eigen::Index i = 0; i < cell.home.size(); ++i)
    home.push_back(tidy(shownValue(kinds[static_cast<std::size_t>(i)], cell.home[i])));
  for (const UncheckedPair& pair : cell.neverMeet)
    never.push_back({{"pair", {pair.first, pair.second}}, {"why", pair.why}});
  Json nozzle{{"mount", plateMoves ? "world" : "flange"}, {"pose", poseJson(cell.nozzlePose)}};
  if (!cell.holder.empty())
    nozzle["holder"] = shapesJson(cell.holder);
  Json platform{{"mount", plateMoves ? "flange" : "world"},
                {"pose", poseJson(cell.platePose)},
                {"thicknessMm", tidy(cell.plateThicknessMm)},
                {"plates", cell.plates}};
  if (!cell.stem.empty())
    platform["stem"] = shapesJson(cell.stem);
  const Json file{{"id", cell.id},          {"label", cell.label},
                  {"note", cell.note},      {"robot", cell.robot},
                  {"nozzle", nozzle},       {"platform", platform},
                  {"obstacles", obstacles}, {"homeDeg", home},
                  {"neverMeet", never},     {"externalAxes", Json::array()}};
  return file.dump(2) + "\n";
}

} // namespace voluta::robot
