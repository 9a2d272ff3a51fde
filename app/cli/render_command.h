// voluta-cli render: a picture of a job, with or without a display.
#pragma once

#include "cli/exit_code.h"

#include <filesystem>
#include <optional>
#include <string>

namespace voluta::cli {

struct RenderOptions {
  std::filesystem::path job, picture;
  std::string show = "paths";  // part, voxels, layers, paths, robot
  std::optional<int> layer;    // from 1; the layers up to it
  std::optional<double> timeS; // robot: at this time; none: at the end
  std::string size = "1280x800";
  std::string colour = "layer"; // id in scene::colourByTable()
  std::string view = "isometric";
  bool dark = false;
};
// Throws Error{Usage, UnreadableFile, UnusableInput, CannotWrite}.
ExitCode renderCommand(const RenderOptions& options);

} // namespace voluta::cli
