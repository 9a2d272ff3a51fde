// Keeps the text of the program on the Export page in step with the time-line.
#pragma once

#include "document/document.h"
#include "jobs/job_runner.h"
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

  // Lines are looked up in the background; linesReady() follows.
  void setProgram(std::shared_ptr<const pipeline::CheckedProgram> program,
                  std::shared_ptr<const plan::Trajectory> trajectory);
  // Nothing while the lines are not there yet.
  std::optional<pipeline::TextLine> lineAt(const timeline::Clock& clock, double timeS) const;
  // The point of the motion at or after that line.
  std::optional<std::size_t> pointOf(std::uint32_t file, std::uint32_t line) const;
  // When the motion at or after that line begins.
  std::optional<double> timeOf(const timeline::Clock& clock, std::uint32_t file,
                               std::uint32_t line) const;

signals:
  void linesReady();

private:
  jobs::JobRunner runner_;
  std::shared_ptr<const pipeline::CheckedProgram> program_;
  std::shared_ptr<const std::vector<pipeline::TextLine>> lines_; // of each trajectory point
};

} // namespace voluta::window
