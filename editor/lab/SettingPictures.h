// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QImage>
#include <QObject>
#include <QProcess>
#include <QSize>
#include <QTemporaryDir>
#include <memory>

#include "editor/core/Document.h"
#include "editor/render/View.h"

namespace glenoid {

/// Draws two scenes at the same moment of their runs from the same place, each by a program of its own (glenoid render), so that neither
/// the view nor its run waits. Only the latest wish counts. GUI thread only.
class SettingPictures : public QObject {
  Q_OBJECT
 public:
  explicit SettingPictures(QString program, QObject* parent = nullptr);
  ~SettingPictures() override;

  /// `seconds`: of the run, from its start on.
  void draw(const Scene& before, const Scene& after, const View& view, double seconds, QSize size);
  void stop();
  bool isBusy() const { return m_busy; }

 signals:
  void drawn(const QImage& before, const QImage& after);
  void failed(const QString& sentence);

 private:
  void next();

  QString m_program;
  QProcess m_process;
  std::unique_ptr<QTemporaryDir> m_folder;
  QStringList m_scenarios;
  std::vector<QImage> m_images;
  double m_seconds = 0;
  QSize m_size;
  bool m_busy = false;
};

}  // namespace glenoid
