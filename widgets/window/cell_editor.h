// A cell edited: what stands where, which robot, what it carries. What the cell cannot do is said
// as it is edited; it is saved as a cell of the user's own.
#pragma once

#include "jobs/job_runner.h"
#include "pipeline/cell_check.h"
#include "process/process.h"
#include "robot/cell_draft.h"

#include <QDialog>
#include <QString>
#include <memory>
#include <optional>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QUndoStack;

namespace voluta::forms {
class NumberBox;
}
namespace voluta::panels {
class FrameForm;
}
namespace voluta::viewer {
class Viewport;
}

namespace voluta::window {

class CellEditor : public QDialog {
  Q_OBJECT

public:
  // `partKg`: of the part that is to be printed, 0 without one.
  CellEditor(const robot::CellDraft& draft, const process::Process& process, double partKg,
             QWidget* parent);
  ~CellEditor() override;

  // Of the cell that was saved; empty: none.
  const QString& savedId() const { return savedId_; }
  const robot::CellDraft& draft() const { return draft_; }
  // The picture and what is said are those of the draft.
  bool settled() const { return !runner_.running(); }

private:
  struct Looked;
  class Edit;

  void build();
  QWidget* buildSide();
  QWidget* buildBodies();
  void listen();
  void edit(const robot::CellDraft& draft, const QString& name);
  void setDraft(const robot::CellDraft& draft);
  void showDraft();
  void showBodies();
  void showBody();
  void look();
  void take(Looked&& looked);
  void showFaults();
  std::optional<robot::DraftBody> chosen() const;
  void addBox();
  void removeBody();
  void rest();
  void save();
  QString idOfName() const;

  robot::CellDraft draft_;
  process::Process process_;
  double partKg_;
  QString savedId_;
  pipeline::CheckedCell checked_;
  bool framed_ = false;
  jobs::JobRunner runner_;
  QUndoStack* undo_;
  viewer::Viewport* viewport_;
  QLineEdit* name_;
  QComboBox *robot_, *extruder_;
  forms::NumberBox* carried_;
  QTreeWidget* tree_;
  panels::FrameForm* frame_;
  QLabel *frameOf_, *faultIcon_, *faults_;
  QPushButton *remove_, *rest_, *save_;
};

} // namespace voluta::window
