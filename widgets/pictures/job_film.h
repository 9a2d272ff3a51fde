// A film of the robot that prints a job.
#pragma once

#include "base/run_context.h"
#include "pictures/job_picture.h"
#include "project/job.h"

#include <filesystem>

namespace voluta::pictures {

struct FilmOptions {
  PictureOptions look; // `show`, `layer` and `timeS` do not count; the size is made even
  double lengthS = 20.0;
  int framesPerS = 25;
};

inline constexpr double kFilmLengthMinS = 1.0, kFilmLengthMaxS = 600.0;

// Writes the whole program as a film (WebM): equal steps of the program's time, the finished part
// at the end. The file is written whole or not at all. Throws Error{Usage} for unknown names and a
// length out of range; Error{UnusableInput} if the job has no motion or the machine cannot draw;
// Error{CannotWrite}; Cancelled. Thread-safe.
void writeFilm(const project::Job& job, const FilmOptions& options,
               const std::filesystem::path& file, const base::RunContext& ctx);

} // namespace voluta::pictures
