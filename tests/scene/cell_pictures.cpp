// Not a test: pictures of every cell, to be looked at. cell_pictures FOLDER [CELL...] [--solids]
#include "base/files.h"
#include "pipeline/stage_options.h"
#include "process/process.h"
#include "project/choices.h"
#include "robot/cell.h"
#include "robot/shape/arm_look.h"
#include "scene/offscreen_target.h"
#include "scene/scene.h"

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace voluta;

constexpr int kWidth = 900, kHeight = 700;

struct Picture {
  const char* name;
  scene::StandardView look;
  scene::World world;
};

robot::Cell cellOf(const std::string& id) {
  project::Choices choices;
  choices.cell = id;
  if (id == "lathe")
    choices.item().mode = "lathe";
  choices.tool().process = id == "lathe" ? "fdm-0.35" : "fdm-1.0";
  return pipeline::fittingCell(choices, process::loadProcess(choices.tool().process));
}

void draw(const std::string& id, bool solids, const std::filesystem::path& folder) {
  const robot::Cell cell = cellOf(id);
  scene::Scene scene(scene::lightTheme());
  scene.setCell(scene::drawCell(cell, robot::lookOf(cell.robot())));
  scene::ViewState view;
  view.part = view.platform = false;
  view.cell = true;
  view.collisionSolids = solids;
  view.world = scene::World::Base;
  scene.setView(view);
  scene::OffscreenTarget target;
  for (const Picture& picture :
       {Picture{"isometric", scene::StandardView::Isometric, scene::World::Base},
        Picture{"front", scene::StandardView::Front, scene::World::Base}}) {
    const scene::Image image = target.imageOf(
        scene, kWidth, kHeight, [&] { scene.standardView(picture.look); }, 2);
    base::writeFile(folder / (id + "-" + picture.name + (solids ? "-solids" : "") + ".png"),
                    scene::pngBytes(image));
  }
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: cell_pictures FOLDER [CELL...] [--solids]\n");
    return 2;
  }
  std::filesystem::create_directories(argv[1]);
  std::vector<std::string> ids;
  bool solids = false;
  for (int i = 2; i < argc; ++i)
    if (std::string(argv[i]) == "--solids")
      solids = true;
    else
      ids.emplace_back(argv[i]);
  for (const std::string& id : ids.empty() ? robot::cellIds() : ids)
    draw(id, solids, argv[1]);
  return 0;
}
