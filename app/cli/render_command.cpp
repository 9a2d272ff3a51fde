#include "cli/render_command.h"

#include "base/error.h"
#include "base/files.h"
#include "cli/new_file.h"
#include "cli/run_interruptibly.h"
#include "pictures/film_writer.h"
#include "pictures/job_film.h"
#include "pictures/job_picture.h"
#include "pipeline/stage_options.h"
#include "project/job.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <filesystem>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

namespace voluta::cli {

namespace {

using base::Error;
using base::ErrorCode;

struct RenderOptions {
  std::filesystem::path job, picture;
  std::string size = "1280x800";
  pictures::PictureOptions look; // Except its size
  bool replace = false;
};

std::pair<int, int> sizeOf(const std::string& text) {
  int width = 0, height = 0;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, width);
  if (first.ec == std::errc() && first.ptr != end && *first.ptr == 'x') {
    const auto second = std::from_chars(first.ptr + 1, end, height);
    if (second.ec == std::errc() && second.ptr == end)
      return {width, height};
  }
  throw Error(ErrorCode::Usage, base::message("'{text}' is not a picture size"_text, text),
              "--size"_name, "give WIDTHxHEIGHT in pixels, such as 1280x800"_text);
}

// A slip of the keys must not replace the job, or a mesh.
void requireEnding(const std::filesystem::path& file, const std::string& ending) {
  if (file.extension() != ending)
    throw Error(ErrorCode::Usage,
                base::message("the file must have the ending {ending}"_text, ending),
                file.string());
}

// Throws Error{Usage, UnreadableFile, UnusableInput, CannotWrite}.
ExitCode renderCommand(const RenderOptions& options) {
  requireEnding(options.picture, ".png");
  requireNewFile(options.picture, options.replace);
  pictures::PictureOptions look = options.look;
  std::tie(look.width, look.height) = sizeOf(options.size);
  look.where = options.job.string();
  pictures::checkNames(look);
  const auto png = endedWith(runInterruptibly(
      [look, job = options.job](const base::RunContext& ctx) {
        const project::Job read = project::readJob(job, pipeline::allParameters());
        ctx.checkpoint();
        return scene::pngBytes(pictures::jobPicture(read, look));
      },
      1, {}, [] {}));
  if (!png)
    return kCancelled;
  base::writeFile(options.picture, *png);
  return kDone;
}

struct FilmCommandOptions {
  std::filesystem::path job, film;
  std::string size = "1280x720";
  pictures::FilmOptions how;
  bool replace = false;
};

// Throws Error{Usage, UnreadableFile, UnusableInput, CannotWrite}.
ExitCode filmCommand(const FilmCommandOptions& options) {
  requireEnding(options.film, ".webm");
  requireNewFile(options.film, options.replace);
  pictures::FilmOptions film = options.how;
  std::tie(film.look.width, film.look.height) = sizeOf(options.size);
  film.look.where = options.job.string();
  pictures::checkNames(film.look);
  const auto done = endedWith(runInterruptibly(
      [film, &options](const base::RunContext& ctx) {
        const project::Job read = project::readJob(options.job, pipeline::allParameters());
        pictures::writeFilm(read, film, options.film, ctx);
        return true;
      },
      1, {}, [] {}));
  if (done)
    return kDone;
  // The thread that draws may not have ended.
  std::error_code none;
  std::filesystem::remove(pictures::stagedFilm(options.film), none);
  return kCancelled;
}

} // namespace

void addFilm(CLI::App& app, std::function<ExitCode()>& run) {
  auto options = std::make_shared<FilmCommandOptions>();
  pictures::FilmOptions& film = options->how;
  CLI::App* command = app.add_subcommand("film", "draw the robot printing a job; needs no display");
  command->add_option("JOB", options->job, "job.voluta")->required();
  command->add_option("-o", options->film, "WebM file to write")->required();
  addReplaceFile(*command, options->replace);
  command->add_option("--length", film.lengthS, "seconds of the film, in which all is printed");
  command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels");
  command->add_option("--colour", film.look.colour,
                      "layer, group, kind, height, width, speed, time or direction");
  command->add_option("--view", film.look.view,
                      "isometric, front, back, left, right, top or bottom");
  command->add_flag("--dark", film.look.dark, "dark background");
  command->callback([options, &run] { run = [options] { return filmCommand(*options); }; });
}

void addRender(CLI::App& app, std::function<ExitCode()>& run) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* render = app.add_subcommand("render", "draw a picture of a job; needs no display");
  render->add_option("JOB", options->job, "job.voluta")->required();
  render->add_option("-o", options->picture, "PNG file to write")->required();
  addReplaceFile(*render, options->replace);
  render->add_option("--show", options->look.show, "part, voxels, pieces, layers, paths or robot");
  render->add_option("--layer", options->look.layer, "show layers 1 to this one");
  render->add_option("--time", options->look.timeS, "robot: seconds from the program's start");
  render->add_option("--size", options->size, "WIDTHxHEIGHT in pixels");
  render->add_option("--colour", options->look.colour,
                     "layer, group, kind, height, width, speed, time or direction");
  render->add_option("--view", options->look.view,
                     "isometric, front, back, left, right, top or bottom");
  render->add_flag("--dark", options->look.dark, "dark background");
  render->callback([options, &run] { run = [options] { return renderCommand(*options); }; });
}

} // namespace voluta::cli
