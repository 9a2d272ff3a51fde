// The Export page: writes programs with the verdict of their replay into a folder.
#pragma once

#include "document/exporting.h"
#include "panels/format_list.h"
#include "window/pages/page.h"

#include <QStringList>
#include <memory>
#include <optional>

namespace voluta::panels {
class ExportPanel;
}

namespace voluta::window {

class ProgramPreview;

class ExportPage : public Page {
  Q_OBJECT

public:
  explicit ExportPage(const Workspace& workspace);

  QWidget* side() override { return side_; }
  PageLayout layout() const override { return {false, timeline::BarMode::Time, true}; }
  std::vector<Command> commands() override;
  std::vector<project::Stage> stages() const override { return {project::Stage::Replay}; }
  void retranslate() override { show(); }

  void draw(scene::ViewState& view) override;

protected:
  void entered() override { show(); }
  void left() override { work().timeline.setSpans({}); }

private:
  // The user's request.
  struct Order {
    QString folder;
    QStringList formats;
    bool includeRefused = false;
  };
  void listenToPanel();
  void listenToRuns();
  void show();
  void showWritten();
  std::vector<panels::ExportFormat> formats() const;
  QStringList chosenFormats() const;
  QString whyNot() const;
  void showPreview();
  void showSlow();
  // For the highlighted line; nullopt: printing cannot resume there.
  std::optional<std::size_t> resumePoint() const;
  void showResume();
  void showLine();
  void goToLine(int file, qulonglong line);
  void setFormats(const QStringList& ids);
  // Returns the plan to verify a program from disk against; null if none is up to date.
  std::shared_ptr<const pipeline::PlanResult> verifiable() const;
  void verify();
  void place(const Order& order);
  void write(const Order& order);
  void open(const QString& path);
  bool mayReplace(const QString& folder, const QStringList& names);

  panels::ExportPanel* panel_;
  QWidget* side_;
  ProgramPreview* preview_;
  document::Exporting exporting_;
  // Of the last export.
  std::weak_ptr<const pipeline::PlanResult> exported_;
  QString written_;     // Summary of the last export; empty: nothing exported yet
  QString writtenTo_;   // Its folder
  QString proof_;       // File name; empty: none
  QStringList leftOut_; // Its refused formats
  // Why its reports have no pictures; set while they are written.
  std::shared_ptr<const std::optional<base::Message>> noPictures_;
  bool writing_ = false;
  QStringList takenOff_;         // The formats in the choices, if the user has unticked all of them
  std::optional<Order> pending_; // Waits for its programs to be planned
};

} // namespace voluta::window
