// Editor for a cell: poses of its bodies, by numbers, by handles in the view or from measured
// points; the robot and its payload. Problems of the cell are shown while it is edited; it is saved
// as a cell of the user's own.
#pragma once

#include "jobs/job_runner.h"
#include "pipeline/cell_file_check.h"
#include "process/process.h"
#include "robot/cell_draft.h"

#include <QDialog>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QUndoStack;

namespace voluta::forms {
enum class Icon;
class NumberBox;
} // namespace voluta::forms
namespace voluta::panels {
class FrameForm;
}
namespace voluta::scene {
struct CellDrawing;
}
namespace voluta::viewer {
struct GizmoChange;
class Viewport;
} // namespace voluta::viewer

namespace voluta::window {

class BodyTree;
class ObstacleImport;

class CellEditor : public QDialog {
  Q_OBJECT

public:
  // `partKg`: mass of the part to be printed, 0 without one.
  CellEditor(const robot::CellDraft& draft, const process::Process& process, double partKg,
             QWidget* parent);
  ~CellEditor() override;

  // Id of the saved cell; empty: none.
  const QString& savedId() const { return savedId_; }
  const robot::CellDraft& draft() const { return draft_; }
  // Returns whether view and messages match the draft.
  bool settled() const;

  // Asks before edits are lost.
  void reject() override;

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
  void showBody();
  void showPurgeButton();
  void look();
  void take(Looked&& looked);
  void showFaults();
  Eigen::Isometry3d base_T_body(const robot::DraftBody& body) const;
  void drag(const viewer::GizmoChange& change, bool finished);
  void preview();
  void addBox();
  void addPurgePlace();
  void addSolids(const QString& name, const std::vector<robot::Shape>& solids);
  void measure();
  void removeBody();
  void showStatus(const QString& text, std::optional<forms::Icon> icon = {});
  void rest();
  void save();
  bool mayDiscard();
  QString idOfName() const;

  robot::CellDraft draft_;
  process::Process process_;
  double partKg_;
  QString savedId_;
  pipeline::CheckedCell checked_;
  std::shared_ptr<const scene::CellDrawing> drawing_; // Of the checked cell
  bool framed_ = false;
  jobs::JobRunner runner_, previewing_;
  // While a handle is dragged: the body before the drag, and its current pose.
  std::optional<robot::DraftBody> held_;
  Eigen::Isometry3d heldAt_ = Eigen::Isometry3d::Identity();
  ObstacleImport* importing_;
  QUndoStack* undo_;
  viewer::Viewport* viewport_;
  QLineEdit* name_;
  QComboBox *robot_, *extruder_;
  forms::NumberBox* carried_;
  BodyTree* tree_;
  panels::FrameForm* frame_;
  QCheckBox* solids_;
  QLabel *frameOf_, *faultIcon_, *faults_;
  QPushButton *addPurgePlace_, *measure_, *remove_, *rest_, *save_;
};

} // namespace voluta::window
