// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QObject>
#include <QProcess>
#include <vector>

#include "editor/lab/LabServices.h"
#include "editor/ui/Actions.h"

class QDockWidget;
class QMainWindow;

namespace glenoid {

class AccuracyPanel;
class EffectsPanel;
class JobSystem;
class PlayLink;
class SceneView;
class StabilityPanel;

/// The lab's part of the window: its three panels, one behind the other beside the view, and the report of their studies. Made after
/// the window's own docks; the view may be null.
class LabDocks : public QObject {
  Q_OBJECT
 public:
  LabDocks(QMainWindow& window, Actions& actions, Document& document, PlayLink& link, JobSystem& jobs, SceneView* view, LabServices services);
  ~LabDocks() override;

  AccuracyPanel& accuracy() { return *m_accuracy; }
  StabilityPanel& stability() { return *m_stability; }
  EffectsPanel& effects() { return *m_effects; }
  const std::vector<QDockWidget*>& docks() const { return m_docks; }
  QStringList dockNames() const;
  /// Folders of the studies that are shown.
  QStringList studies() const;
  /// Writes the report of these to FILE.html or FILE.pdf, by a program of its own.
  void writeReport(const QString& file);
  /// Ends studies that run; what they found stays.
  void stopStudies();
  void retranslate();

 signals:
  void problem(const QString& sentence);
  void reportWritten(const QString& file);

 private:
  void addDock(const char* name, QWidget* content);
  void askForReport();

  QMainWindow& m_window;
  LabServices m_services;
  AccuracyPanel* m_accuracy;
  StabilityPanel* m_stability;
  EffectsPanel* m_effects;
  std::vector<QDockWidget*> m_docks;
  QProcess m_report;
};

}  // namespace glenoid
