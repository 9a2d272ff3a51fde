#include "cli/render_command.h"

#include "base/error.h"
#include "base/files.h"
#include "project/job.h"

#include <charconv>
#include <fmt/format.h>
#include <tuple>
#include <utility>

namespace voluta::cli {

namespace {

using base::Error;
using base::ErrorCode;

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

} // namespace

ExitCode renderCommand(const RenderOptions& options) {
  pictures::PictureOptions look = options.look;
  std::tie(look.width, look.height) = sizeOf(options.size);
  look.where = options.job.string();
  pictures::checkNames(look);
  const project::Job job = project::readJob(options.job);
  base::writeFile(options.picture, scene::pngBytes(pictures::jobPicture(job, look)));
  return kDone;
}

} // namespace voluta::cli
