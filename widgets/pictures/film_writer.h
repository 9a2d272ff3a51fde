// Writes a film: VP9 in WebM, by the libraries of FFmpeg.
#pragma once

#include "scene/offscreen_target.h"

#include <filesystem>
#include <memory>

namespace voluta::pictures {

// Returns the name of a film while it is written.
std::filesystem::path stagedFilm(const std::filesystem::path& film);

// The file is there once finish() has returned; until then it has another name, and is removed if
// finish() is not called.
class FilmWriter {
public:
  // Preconditions: width and height are even and positive; framesPerS >= 1. Throws
  // Error{CannotWrite}.
  FilmWriter(std::filesystem::path file, int width, int height, int framesPerS);
  ~FilmWriter();
  FilmWriter(const FilmWriter&) = delete;
  FilmWriter& operator=(const FilmWriter&) = delete;

  // Precondition: the frame has the film's size. Throws Error{CannotWrite}.
  void add(const scene::Image& frame);
  void finish();

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace voluta::pictures
