// The Compare page: compares print modes side by side and adopts one of them.
#pragma once

#include "window/pages/page.h"

namespace voluta::window {

class CompareView;

class ComparePage : public Page {
  Q_OBJECT

public:
  explicit ComparePage(const Workspace& workspace);

  QWidget* side() override { return side_; }
  QWidget* centre() override;
  PageState state() const override;
  void retranslate() override;

  void draw(scene::ViewState& view) override;

private:
  CompareView* view_;
  QWidget* side_;
};

} // namespace voluta::window
