// Pictures of a job, drawn without a window, for `voluta-cli render` and comparisons.
#pragma once

#include "project/job.h"
#include "scene/offscreen_target.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace voluta::pictures {

struct PictureOptions {
  std::string show = "paths";  // One of pictureNames()
  std::optional<int> layer;    // From 1; shows the layers up to it
  std::optional<double> timeS; // robot: at this time; none: at the end
  int width = 1280, height = 800;
  std::string colour = "layer";   // Id in scene::colourByTable()
  std::string view = "isometric"; // Front, back, left, right, top, bottom
  bool dark = false;
  bool legend = true; // And the axes
  std::string where;  // Context of errors: the job's file
};

std::vector<std::string> pictureNames(); // Returns part, voxels, pieces, layers, paths, robot.

// Throws Error{Usage} for an unknown name, layer or time; Error{UnusableInput} if the job does not
// contain the requested results. Thread-safe.
scene::Image jobPicture(const project::Job& job, const PictureOptions& options);
// Throws Error{Usage} for an unknown name.
scene::StandardView standardViewOf(const std::string& view);
// Throws Error{Usage} for unknown names, before a job is read.
void checkNames(const PictureOptions& options);

// Returns PNGs of the part and of the printed part, in the colour of its material; none if the job
// has no tool-paths. Throws Error{UnusableInput} if the machine cannot draw. Thread-safe.
std::vector<std::string> drawProofPictures(const project::Job& job);
// The same, but returns none if the machine cannot draw.
std::vector<std::string> proofPictures(const project::Job& job);

// Returns the name of the most detailed available picture: paths, else layers, voxels, pieces, the
// part.
std::string furthestPicture(const project::Job& job);

} // namespace voluta::pictures
