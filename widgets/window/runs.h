// What runs in the background for the document: started, cancelled, and told of as it goes.
#pragma once

#include "document/comparing.h"
#include "document/document.h"
#include "document/live_preview.h"
#include "document/opening.h"
#include "document/planning.h"
#include "window/commands.h"

#include <QObject>
#include <QString>
#include <vector>

namespace voluta::window {

class Runs : public QObject {
  Q_OBJECT

public:
  // All outlives this.
  Runs(document::Document& document, document::Planning& planning, document::LivePreview& live,
       document::Comparing& comparing, document::Opening& opening);

  std::vector<Command> commands();
  bool busy() const;
  void cancel();    // the newest
  void cancelAll(); // also those that wait
  // What counts now in one line: figures of the preview or of the last plan; empty: no part.
  QString summary() const;

signals:
  void planAsked(voluta::project::Stage until); // by the user
  void changed();                               // something runs, or has ended
  void progressed(const voluta::jobs::Progress& progress);
  void said(const QString& text);
  void told(const QString& title, const QString& message);

private:
  void listenToPlanning();
  void listenToPreview();
  void listenToOthers();
  void layPart();
  void askForPlan(project::Stage until);

  document::Document& document_;
  document::Planning& planning_;
  document::LivePreview& live_;
  document::Comparing& comparing_;
  document::Opening& opening_;
};

} // namespace voluta::window
