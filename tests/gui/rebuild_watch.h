// Fails a test where rows or widgets go while they are at an input event of their own: Qt still
// uses a list's row when its signal returns, and the widget that was clicked. (A tick that ended in
// a list's clear() ended the program two times out of three.)
#pragma once

#include <QObject>
#include <QSet>

class QAbstractItemModel;
class QWidget;

namespace voluta::test {

class RebuildWatch : public QObject {
public:
  // Also watches objects created since; to be called often.
  void watchAll();

private:
  void watch(QWidget* widget);
  void watchRows(QWidget* view, QAbstractItemModel* model);

  QSet<QObject*> known_;
};

} // namespace voluta::test
