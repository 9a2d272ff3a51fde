// Live voxel preview: runs only the decomposition after edits, in the background.
#pragma once

#include "jobs/job_runner.h"
#include "pipeline/road.h"

#include <QObject>
#include <QString>
#include <memory>
#include <string>

class QTimer;

namespace voluta::document {

class Document;
class Planning;

// If a decomposition was planned before, an edit that changes it starts a run at once; a further
// edit cancels it and starts another 0.3 s after the last edit. The result is shown as a preview
// and cached, so that a plan of the same choices continues from there. Never runs in parallel with
// a plan that goes beyond the first stage.
class LivePreview : public QObject {
  Q_OBJECT

public:
  // Both have to outlive the object.
  LivePreview(Document& document, Planning& planning, QObject* parent = nullptr);
  ~LivePreview() override;

  // Initially enabled. Disabling cancels.
  void setEnabled(bool on);
  bool enabled() const { return enabled_; }
  // Starts without delay if there is something to update.
  void refresh();
  void cancel();
  bool running() const { return runner_.running(); }

signals:
  void started();
  void progressed(const voluta::jobs::Progress& progress);
  void finished();
  void cancelled();
  void failed(const QString& message);

private:
  bool wanted() const;
  void noteEdit();
  void stop();
  void start();

  Document& document_;
  Planning& planning_;
  jobs::JobRunner runner_;
  QTimer* pause_;
  std::string runKey_; // of the decomposition being computed
  bool enabled_ = true, due_ = false;
};

} // namespace voluta::document
