// Edits a project without end and keeps a copy of it: endless_editor FOLDER LOG PAUSE_MS LATEST_MS
// Each edit sets the seed to the next number and adds a line "number milliseconds" to LOG.
#include "document/autosave.h"
#include "document/document.h"
#include "document/parts.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QTimer>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <unistd.h>

using namespace voluta;

int main(int argc, char** argv) {
  if (argc != 5)
    return 2;
  QCoreApplication app(argc, argv);
  document::Document document;
  document::AutosaveOptions options;
  options.folder = QString::fromLocal8Bit(argv[1]);
  options.pauseMs = std::atoi(argv[3]);
  options.atLatestMs = std::atoi(argv[4]);
  const document::Autosave autosave(document, options);
  const int log = ::open(argv[2], O_WRONLY | O_CREAT | O_APPEND, 0600);

  // Large enough for a copy to take a while: a kill may come in the middle of it.
  auto mesh =
      std::make_shared<geometry::TriangleMesh>(test::sphere(Eigen::Vector3d::Zero(), 20.0, 120));
  document.openPart(project::loadedFrom("ball.stl", mesh, {}, false, {}), {}, true);
  project::Choices choices = document.choices();
  choices.item().repair = false;
  document.setChoices(choices, QStringLiteral("As read"));

  int number = 1;
  QTimer editing;
  QObject::connect(&editing, &QTimer::timeout, [&] {
    test::setSeed(document, ++number);
    const std::string line =
        std::to_string(number) + " " + std::to_string(QDateTime::currentMSecsSinceEpoch()) + "\n";
    if (::write(log, line.data(), line.size()) < 0)
      std::abort();
  });
  editing.start(15);
  return QCoreApplication::exec();
}
