// Prepare page: the placement of the part and all choices for it.
#pragma once

#include "window/pages/choices_editor.h"
#include "window/pages/page.h"
#include "window/pages/part_handles.h"

class QTabWidget;

namespace voluta::forms {
class ParameterForm;
}
namespace voluta::panels {
class MeshPanel;
class PlacementPanel;
} // namespace voluta::panels

namespace voluta::window {

class CutTool;
class MeasureTool;
class PartsView;
class PresetEditor;
class ReachView;
class RegionsTool;
class StandChooser;

class PreparePage : public Page {
  Q_OBJECT

public:
  explicit PreparePage(const Workspace& workspace);

  QWidget* side() override;
  PageLayout layout() const override { return {.aboutPart = true}; }
  std::vector<Command> commands() override;
  std::vector<ViewportInput*> inputs() override;
  std::vector<project::Stage> stages() const override { return {project::Stage::Load}; }
  PageState state() const override;
  void retranslate() override;

  void draw(scene::ViewState& view) override;
  int interest(const plan::Finding& finding) const override;

protected:
  void left() override;

private:
  void build();
  void listen();
  void editCell();
  std::shared_ptr<const geometry::TriangleMesh> placedPart() const;
  void millPart();
  void setParameter(const QString& key, const QString& text);
  void showChoices();
  void showProblems();
  void showPart();

  PartHandles handles_;
  MeasureTool* measure_;
  CutTool* cut_;
  RegionsTool* regions_;
  PartsView* parts_;
  StandChooser* stands_;
  ReachView* reach_;
  ChoicesEditor* choices_;
  PresetEditor* presets_;
  panels::PlacementPanel* placement_;
  panels::MeshPanel* mesh_;
  forms::ParameterForm* parameters_;
  QTabWidget* tabs_;
  QWidget* side_;
  bool hasPaths_ = false; // The part brings tool-paths
};

} // namespace voluta::window
