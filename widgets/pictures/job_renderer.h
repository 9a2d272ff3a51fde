// Draws the results of a job into a scene. Used on one drawing thread (scene/drawing_thread.h).
#pragma once

#include "pictures/job_picture.h"
#include "plan/trajectory.h"
#include "scene/offscreen_target.h"
#include "scene/scene.h"

#include <functional>
#include <memory>

namespace voluta::pictures {

class Renderer {
public:
  // Both outlive the object.
  Renderer(const PictureOptions& options, const project::Job& job);

  // Each throws Error{UnusableInput} if the job does not contain the results.
  void showPart();
  void showVoxels();
  void showLayers();
  void showPieces();
  void showPaths();
  // At PictureOptions::timeS.
  void showRobot();
  void inMaterialColour() { view_.materialColour = true; }

  // After showRobot(): moves the robot to another time of the program, from 0 to durationS().
  void setTime(double timeS);
  double durationS() const { return times_.empty() ? 0.0 : times_.back(); }

  scene::Image picture(scene::StandardView view);
  // Framed without the plate, whose size varies. Precondition: the job has its part.
  scene::Image pictureOfThePart();

  scene::Scene& scene() { return scene_; }

private:
  scene::Image pictureFrom(const std::function<void()>& placeCamera);
  template <typename T>
  std::shared_ptr<const T> need(const std::shared_ptr<const T>& result, base::Text what) const;
  std::shared_ptr<const scene::PathsDrawing> drawPaths(const plan::ToolPlan& plan) const;
  void showOthers(std::size_t item);
  scene::VoxelLook voxelLook(const curved::Decomposition& voxels) const;
  process::Process process() const;
  void showPlatform();
  void setLastLayer(int count);
  double chosenTime() const;

  const PictureOptions& options_;
  const project::Job& job_;
  scene::Scene scene_;
  scene::ViewState view_;
  std::vector<double> times_; // Per point of the trajectory: arrival
};

} // namespace voluta::pictures
