// Voxels that follow the edits: a run of the decomposition alone, in the background.
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

// Where a decomposition was planned before, an edit that changes it starts a run at once; an edit
// that follows cancels it and starts another 0.3 s after the last edit. What comes out is shown as
// a preview and kept, so that a plan of the same choices goes on from there. Never runs beside a
// plan that goes further than the first stage.
class LivePreview : public QObject {
  Q_OBJECT

public:
  // Both outlive this.
  LivePreview(Document& document, Planning& planning, QObject* parent = nullptr);
  ~LivePreview() override;

  // On, as at first. Off cancels.
  void setEnabled(bool on);
  bool enabled() const { return enabled_; }
  // Starts without waiting where there is something to show anew.
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
  std::string runKey_; // of the decomposition that the run makes
  bool enabled_ = true, due_ = false;
};

} // namespace voluta::document
