#include "pictures/job_renderer.h"

#include "base/error.h"
#include "curved/peeling_field.h"
#include "geometry/measures.h"
#include "modes/planar_modes.h"
#include "motion/waits.h"
#include "pictures/all_items.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "plan/arrival_times.h"
#include "robot/shape/arm_look.h"

#include <algorithm>

namespace voluta::pictures {

using base::Error;
using base::ErrorCode;

namespace {
constexpr double kGroundBeyondPartMm = 30.0;
} // namespace

Renderer::Renderer(const PictureOptions& options, const project::Job& job)
    : options_(options), job_(job),
      scene_(options.dark ? scene::darkTheme() : scene::lightTheme()) {
  view_.part = view_.paths = false;
  view_.legend = view_.axes = options_.legend;
  view_.colourBy = scene::colourByOf(options.colour);
}

template <typename T>
std::shared_ptr<const T> Renderer::need(const std::shared_ptr<const T>& result,
                                        base::Text what) const {
  if (!result)
    throw Error(ErrorCode::UnusableInput, base::message("the job contains no {result}"_text, what),
                options_.where, "plan the part further: voluta-cli plan PART -o DIR"_text);
  return result;
}

void Renderer::showPart() {
  scene_.setPart(scene::drawPart(*need(partsOf(job_), "placed part"_text)));
  view_.part = true;
  showPlatform();
}
void Renderer::showVoxels() {
  const std::size_t item = itemWithVoxels(job_).value_or(0);
  const auto voxels = need(job_.item(item).decomposition(), "voxels"_text);
  const auto drawing = scene::drawVoxels(*voxels, voxelLook(*voxels));
  showOthers(item);
  setLastLayer(scene::layerCount(*drawing));
  scene_.setVoxels(drawing);
  view_.voxels = true;
  showPlatform();
}
void Renderer::showLayers() {
  const process::Process p = process();
  const auto drawing = scene::drawLayers(*need(layersOf(job_), "layers"_text),
                                         {p.layerHeightMm, p.layerHeightMinMm, p.layerHeightMaxMm});
  setLastLayer(scene::layerCount(*drawing));
  scene_.setLayers(drawing);
  view_.layers = true;
  showPlatform();
}
void Renderer::showPieces() {
  const std::vector<planar::Piece> pieces = piecesOf(job_);
  if (pieces.empty())
    need(job_.item().pieces(), "pieces"_text);
  scene_.setPieces(scene::drawPieces(pieces, pipeline::riskRule(pipeline::resolve(job_.choices))));
  view_.pieces = true;
  showPlatform();
}
std::shared_ptr<const scene::PathsDrawing> Renderer::drawPaths(const plan::ToolPlan& plan) const {
  const plan::Trajectory* trajectory = job_.trajectory.get();
  return scene::drawPaths(plan, trajectory,
                          trajectory ? motion::layerTimesOf(plan, *trajectory)
                                     : std::vector<float>());
}
void Renderer::showPaths() {
  const auto drawing = drawPaths(*need(job_.toolPlan, "tool-paths"_text));
  setLastLayer(scene::layerCount(*drawing));
  scene_.setPaths(drawing);
  view_.paths = true;
  showPlatform();
}
void Renderer::showRobot() {
  const auto& trajectory = *need(job_.trajectory, "robot motion"_text);
  const auto& plan = *need(job_.toolPlan, "tool-paths"_text);
  const robot::Cell cell = robot::loadCell(job_.choices.cell, process(), job_.item().platform);
  scene_.setCell(scene::drawCell(cell, robot::lookOf(cell.robot())));
  const auto drawing = drawPaths(plan);
  setLastLayer(scene::layerCount(*drawing));
  scene_.setPaths(drawing);
  view_.paths = view_.cell = true;
  view_.materialColour = options_.colour == "layer";
  view_.world = scene::World::Base;
  if (trajectory.pointCount() == 0)
    throw Error(ErrorCode::UnusableInput, "the robot motion is empty"_text, options_.where,
                "plan the part again"_text);
  times_ = plan::arrivalTimes(trajectory);
  scene_.setPlatform(scene::drawPlatform(project::platformOf(job_), 0.0));
  setTime(chosenTime());
}

scene::Image Renderer::picture(scene::StandardView view) {
  return pictureFrom([&] { scene_.standardView(view); });
}
scene::Image Renderer::pictureOfThePart() {
  return pictureFrom([&] {
    scene_.standardView(scene::StandardView::Isometric);
    const Eigen::AlignedBox3d box = geometry::bounds(*partsOf(job_));
    scene_.lookAt(box.center(), 0.5 * box.diagonal().norm());
  });
}

scene::Image Renderer::pictureFrom(const std::function<void()>& placeCamera) {
  scene_.setView(view_);
  scene::OffscreenTarget target;
  return target.imageOf(scene_, options_.width, options_.height, placeCamera);
}

// Shows the parts beside the one whose voxels are shown.
void Renderer::showOthers(std::size_t item) {
  std::vector<std::shared_ptr<const scene::PartDrawing>> others(job_.items.size());
  for (std::size_t i = 0; i < others.size(); ++i)
    if (i != item && job_.item(i).part)
      others[i] = scene::drawPart(*job_.item(i).part);
  scene_.setOtherParts(std::move(others));
  view_.otherParts = true;
}

scene::VoxelLook Renderer::voxelLook(const curved::Decomposition& voxels) const {
  scene::VoxelLook look;
  look.layerHeightMm = process().layerHeightMm;
  look.colourBy = view_.colourBy;
  if (look.colourBy == scene::ColourBy::Peeling)
    look.peeling =
        std::make_shared<const std::vector<std::int32_t>>(curved::peelingField(voxels, {}));
  return look;
}

process::Process Renderer::process() const {
  return pipeline::resolve(job_.choices).process();
}

void Renderer::showPlatform() {
  double reach = 0.0;
  for (const project::JobItem& item : job_.items)
    if (item.part)
      for (const Eigen::Vector3d& v : item.part->vertices)
        reach = std::max(reach, v.head<2>().norm());
  scene_.setPlatform(scene::drawPlatform(project::platformOf(job_), reach + kGroundBeyondPartMm));
}

void Renderer::setLastLayer(int count) {
  if (!options_.layer)
    return;
  if (*options_.layer < 1 || *options_.layer > count)
    throw Error(ErrorCode::Usage, base::message("there is no layer {layer}"_text, *options_.layer),
                options_.where, base::message("layers are 1 to {count}"_text, count));
  view_.lastLayer = *options_.layer - 1;
}

double Renderer::chosenTime() const {
  const double end = durationS(), time = options_.timeS.value_or(end);
  if (!(time >= 0.0 && time <= end))
    throw Error(ErrorCode::Usage,
                base::message("there is no time {time}"_text, base::seconds(time)), options_.where,
                base::message("the program runs from 0 to {end:.1f}"_text, base::seconds(end)));
  return time;
}

void Renderer::setTime(double time) {
  const plan::Trajectory& t = *job_.trajectory;
  const auto after = std::upper_bound(times_.begin(), times_.end(), time) - times_.begin();
  const std::size_t last = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after, 1)) - 1;
  const std::size_t next = std::min(last + 1, t.pointCount() - 1);
  const double step = t.timeS[next] - t.timeS[last];
  // The arm waits first, then moves for the step's time.
  const double moved = time - (times_[next] - step);
  const double share = step > 0.0 ? std::clamp(moved / step, 0.0, 1.0) : 0.0;
  view_.joints.resize(t.dof);
  for (int j = 0; j < t.dof; ++j)
    view_.joints[j] = t.at(last)[j] + share * (t.at(next)[j] - t.at(last)[j]);
  view_.printedWaypoints = 0;
  for (std::size_t i = last + 1; i-- > 0 && view_.printedWaypoints == 0;)
    if (t.waypoint[i] != plan::kNoWaypoint)
      view_.printedWaypoints = t.waypoint[i] + 1;
  scene_.setView(view_);
}

} // namespace voluta::pictures
