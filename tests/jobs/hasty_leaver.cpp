// Starts a run that neither ends nor listens, and leaves: hasty_leaver STATUS
#include "jobs/job_runner.h"

#include <QCoreApplication>
#include <QTimer>
#include <chrono>
#include <cstdlib>
#include <thread>

int main(int argc, char** argv) {
  QCoreApplication app(argc, argv);
  const int status = argc > 1 ? std::atoi(argv[1]) : 0;
  voluta::jobs::JobRunner runner;
  runner.run(
      [](const voluta::base::RunContext&) -> int {
        while (true)
          std::this_thread::sleep_for(std::chrono::seconds(60));
      },
      [](const voluta::base::Outcome<int>&) {});
  QTimer::singleShot(100, [&] {
    runner.cancel();
    QCoreApplication::exit(status);
  });
  return QCoreApplication::exec();
}
