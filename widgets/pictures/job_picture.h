// Pictures of a job, drawn without a window: what `voluta-cli render` and comparisons show.
#pragma once

#include "project/job.h"
#include "scene/offscreen_target.h"

#include <optional>
#include <string>
#include <vector>

namespace voluta::pictures {

struct PictureOptions {
  std::string show = "paths";  // of pictureNames()
  std::optional<int> layer;    // from 1; the layers up to it
  std::optional<double> timeS; // robot: at this time; none: at the end
  int width = 1280, height = 800;
  std::string colour = "layer";   // id in scene::colourByTable()
  std::string view = "isometric"; // front, back, left, right, top, bottom
  bool dark = false;
  bool legend = true; // and the axes
  std::string where;  // what errors name: the job's file
};

std::vector<std::string> pictureNames(); // part, voxels, pieces, layers, paths, robot

// Throws Error{Usage}: a name, layer or time that there is not; Error{UnusableInput}: the job holds
// none of what is to be shown. Good for any thread.
scene::Image jobPicture(const project::Job& job, const PictureOptions& options);
// Throws Error{Usage} for names that there are not, before a job is read.
void checkNames(const PictureOptions& options);

// PNGs of the part and of the part as printed, in the colour of its material; none where the job
// has no tool-paths. Throws Error{UnusableInput} where the machine draws none. Good for any thread.
std::vector<std::string> drawProofPictures(const project::Job& job);
// The same, none where the machine draws none.
std::vector<std::string> proofPictures(const project::Job& job);

// What shows most of how the job is built: its paths, else layers, voxels, pieces, the part.
std::string furthestPicture(const project::Job& job);

} // namespace voluta::pictures
