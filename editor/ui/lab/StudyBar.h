// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QWidget>

#include "editor/core/Document.h"
#include "editor/lab/LabServices.h"
#include "editor/lab/StudyProcess.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace glenoid {

/// Runs one kind of study of the open scene in a process of its own: how thorough, begin, stop, how far it is and for how long yet, or a
/// study of before from its folder. A scene that was edited is studied as it stands, from a copy in the study's folder. Results stay in
/// their folder.
class StudyBar : public QWidget {
  Q_OBJECT
 public:
  /// `kind`: as on the command line.
  StudyBar(QString kind, Document& document, const LabServices& services, QWidget* parent = nullptr);

  StudyProcess& process() { return m_process; }
  const StudyFolder& study() const { return m_process.study(); }
  /// What is, or was, studied; null: a study of before, whose scene is named in it.
  const std::shared_ptr<const Scene>& scene() const { return m_scene; }
  /// Arguments beside those that every study has, asked for as it begins.
  void setMoreArguments(std::function<QStringList()> more) { m_more = std::move(more); }

  void begin();
  void begin(const QString& folder);  ///< where its files shall lie
  void openFolder(const QString& folder);
  void stop() { m_process.cancel(); }
  /// Says something below the buttons; a study that begins takes it away.
  void say(const QString& sentence);

 signals:
  void begun();
  void newsCame();   ///< rows, or another study
  void endedWell();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
  void refresh();
  void askForFolder();
  Result<QString> scenarioFor(const QString& folder) const;

  QString m_kind;
  Document& m_document;
  const LabServices& m_services;
  StudyProcess m_process;
  std::shared_ptr<const Scene> m_scene;
  std::function<QStringList()> m_more;
  QComboBox* m_extent;
  QPushButton *m_run, *m_stop, *m_open;
  QProgressBar* m_bar;
  QLabel *m_words, *m_sentence;
};

}  // namespace glenoid
