// voluta-cli render: a picture of a job, with or without a display.
#pragma once

#include "cli/exit_code.h"
#include "pictures/job_picture.h"

#include <filesystem>
#include <string>

namespace voluta::cli {

struct RenderOptions {
  std::filesystem::path job, picture;
  std::string size = "1280x800";
  pictures::PictureOptions look; // Except its size
};
// Throws Error{Usage, UnreadableFile, UnusableInput, CannotWrite}.
ExitCode renderCommand(const RenderOptions& options);

} // namespace voluta::cli
