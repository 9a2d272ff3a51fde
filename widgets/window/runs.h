// Starts, cancels and reports the background runs of the document.
#pragma once

#include "document/comparing.h"
#include "document/document.h"
#include "document/live_preview.h"
#include "document/opening.h"
#include "document/planning.h"
#include "window/quote/quote.h"
#include "window/window_commands.h"

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

namespace voluta::window {

class Runs : public QObject {
  Q_OBJECT

public:
  // The arguments must outlive this object.
  Runs(document::Document& document, document::Planning& planning, document::LivePreview& live,
       document::Comparing& comparing, document::Opening& opening);

  std::vector<Command> commands();
  bool busy() const;
  void cancel();    // Cancels the newest run
  void cancelAll(); // Cancels waiting runs too
  // Returns the figures of the preview or the last plan in one line; empty if there is no part.
  QString summary() const;
  // Returns time, mass, length and cost of the present plan; empty if it has no motion.
  QString headline() const;
  // Whether the programs of the present settings exist, so that there is nothing to plan.
  bool hasPlanned() const;

signals:
  void planAsked(voluta::project::Stage until); // Requested by the user
  void changed();                               // A run has started or ended
  void progressed(const voluta::jobs::Progress& progress);
  void said(const QString& text);
  void messageRaised(const QString& title, const QString& message);

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
  // The result quoted last, and its quote: measured once.
  mutable std::weak_ptr<const pipeline::PlanResult> quoted_;
  mutable std::optional<PrintQuote> quote_;
};

} // namespace voluta::window
