#include "pictures/job_picture.h"

#include "base/error.h"
#include "base/nearest_name.h"
#include "pictures/all_items.h"
#include "pictures/job_renderer.h"
#include "scene/drawing_thread.h"

#include <utility>

namespace voluta::pictures {

namespace {

using base::Error;
using base::ErrorCode;

template <typename T> using Row = std::pair<const char*, T>;

template <typename T, std::size_t N> std::vector<std::string> namesOf(const Row<T> (&rows)[N]) {
  std::vector<std::string> names;
  for (const auto& row : rows)
    names.emplace_back(row.first);
  return names;
}

template <typename T, std::size_t N>
T chosen(const Row<T> (&rows)[N], const std::string& name, base::Text unknown) {
  for (const auto& [known, value] : rows)
    if (name == known)
      return value;
  throw Error(ErrorCode::Usage, base::Message(unknown, {name}), {},
              base::message("did you mean '{name}'?"_text, base::nearestName(name, namesOf(rows))));
}

constexpr Row<void (Renderer::*)()> kShown[] = {
    {"part", &Renderer::showPart},     {"voxels", &Renderer::showVoxels},
    {"pieces", &Renderer::showPieces}, {"layers", &Renderer::showLayers},
    {"paths", &Renderer::showPaths},   {"robot", &Renderer::showRobot}};

constexpr Row<scene::StandardView> kViews[] = {
    {"isometric", scene::StandardView::Isometric}, {"front", scene::StandardView::Front},
    {"back", scene::StandardView::Back},           {"left", scene::StandardView::Left},
    {"right", scene::StandardView::Right},         {"top", scene::StandardView::Top},
    {"bottom", scene::StandardView::Bottom}};

} // namespace

std::vector<std::string> pictureNames() {
  return namesOf(kShown);
}

scene::StandardView standardViewOf(const std::string& view) {
  return chosen(kViews, view, "unknown view '{name}'"_text);
}

void checkNames(const PictureOptions& options) {
  chosen(kShown, options.show, "unknown picture '{name}'"_text);
  standardViewOf(options.view);
  scene::colourByOf(options.colour);
}

scene::Image jobPicture(const project::Job& job, const PictureOptions& options) {
  const auto show = chosen(kShown, options.show, "unknown picture '{name}'"_text);
  const scene::StandardView view = standardViewOf(options.view);
  return scene::inDrawingThread([&] {
    Renderer renderer(options, job);
    (renderer.*show)();
    return renderer.picture(view);
  });
}

std::vector<std::string> drawProofPictures(const project::Job& job) {
  if (!partsOf(job) || !job.toolPlan)
    return {};
  PictureOptions options;
  options.width = 1000;
  options.height = 560;
  options.legend = false;
  return scene::inDrawingThread([&]() -> std::vector<std::string> {
    Renderer part(options, job), printed(options, job);
    part.showPart();
    printed.showPaths();
    printed.inMaterialColour();
    return {scene::pngBytes(part.pictureOfThePart()), scene::pngBytes(printed.pictureOfThePart())};
  });
}

std::vector<std::string> proofPictures(const project::Job& job) {
  try {
    return drawProofPictures(job);
  } catch (const base::Error&) {
    return {}; // A report is useful without pictures
  }
}

std::string furthestPicture(const project::Job& job) {
  return job.toolPlan             ? "paths"
         : layersOf(job)          ? "layers"
         : itemWithVoxels(job)    ? "voxels"
         : !piecesOf(job).empty() ? "pieces"
                                  : "part";
}

} // namespace voluta::pictures
