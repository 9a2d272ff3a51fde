// Synchronizes the program text on the Export page with the time-line.
#pragma once

#include "document/document.h"
#include "jobs/job_runner.h"
#include "pipeline/checked_program.h"
#include "timeline/clock.h"

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

namespace voluta::window {

class ProgramPreview : public QObject {
  Q_OBJECT

public:
  explicit ProgramPreview(QObject* parent = nullptr);

  // Maps lines to points in the background, then emits linesReady().
  void setProgram(std::shared_ptr<const pipeline::CheckedProgram> program,
                  std::shared_ptr<const plan::Trajectory> trajectory);
  // Returns nullopt until the lines are available.
  std::optional<pipeline::TextLine> lineAt(const timeline::Clock& clock, double timeS) const;
  // Returns the point of the motion at or after that line.
  std::optional<std::size_t> pointOf(std::uint32_t file, std::uint32_t line) const;
  // Returns the start time of the motion at or after that line.
  std::optional<double> timeOf(const timeline::Clock& clock, std::uint32_t file,
                               std::uint32_t line) const;

signals:
  void linesReady();

private:
  jobs::JobRunner runner_;
  std::shared_ptr<const pipeline::CheckedProgram> program_;
  std::shared_ptr<const std::vector<pipeline::TextLine>> lines_; // Line per trajectory point
};

} // namespace voluta::window
