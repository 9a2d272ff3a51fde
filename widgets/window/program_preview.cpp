#include "window/program_preview.h"

#include "pipeline/checked_program.h"
#include "pipeline/stages.h"

#include <algorithm>

namespace voluta::window {

ProgramPreview::ProgramPreview(QObject* parent) : QObject(parent) {}

void ProgramPreview::setProgram(std::shared_ptr<const pipeline::CheckedProgram> program,
                                std::shared_ptr<const plan::Trajectory> trajectory) {
  if (program == program_)
    return;
  program_ = program;
  lines_.reset();
  runner_.cancel();
  if (!program || !trajectory)
    return;
  using Lines = std::vector<pipeline::TextLine>;
  runner_.run(
      [program, trajectory](const base::RunContext&) {
        return std::make_shared<const Lines>(pipeline::linesOfPoints(*program, *trajectory));
      },
      [this](base::Outcome<std::shared_ptr<const Lines>> outcome) {
        if (const auto* lines = std::get_if<std::shared_ptr<const Lines>>(&outcome)) {
          lines_ = *lines;
          emit linesReady();
        }
      },
      1);
}

std::optional<pipeline::TextLine> ProgramPreview::lineAt(const timeline::Clock& clock,
                                                         double timeS) const {
  if (!lines_ || clock.empty())
    return std::nullopt;
  const std::size_t point = clock.pointAt(timeS);
  if (point >= lines_->size() || (*lines_)[point].line == 0)
    return std::nullopt;
  return (*lines_)[point];
}

std::optional<std::size_t> ProgramPreview::pointOf(std::uint32_t file, std::uint32_t line) const {
  if (!lines_)
    return std::nullopt;
  const auto wanted = std::pair(file, line);
  const auto found = std::find_if(lines_->begin(), lines_->end(), [&](const auto& l) {
    return l.line != 0 && std::pair(l.file, l.line) >= wanted;
  });
  if (found == lines_->end())
    return std::nullopt;
  return static_cast<std::size_t>(found - lines_->begin());
}

std::optional<double> ProgramPreview::timeOf(const timeline::Clock& clock, std::uint32_t file,
                                             std::uint32_t line) const {
  const auto point = clock.empty() ? std::nullopt : pointOf(file, line);
  return point ? std::optional(clock.timeOfPoint(*point)) : std::nullopt;
}

} // namespace voluta::window
