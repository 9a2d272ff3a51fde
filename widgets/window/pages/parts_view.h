// The list of parts on the Prepare page, and the commands on parts.
#pragma once

#include "panels/part_list.h"
#include "window/pages/page.h"

namespace voluta::window {

class PartsView : public QObject {
  Q_OBJECT

public:
  // `page`: with the list; only there the key that removes a part has an effect. All of `workspace`
  // must outlive this.
  PartsView(const Workspace& workspace, Page& page);

  // Created here, to be placed by the caller; visible from two parts on.
  panels::PartList* list() { return list_; }
  std::vector<Command> commands();
  void show();

private:
  void arrange();

  Workspace work_;
  const Page& page_;
  panels::PartList* list_;
};

} // namespace voluta::window
