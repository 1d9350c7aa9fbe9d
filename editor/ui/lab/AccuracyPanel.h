// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QWidget>

#include "editor/core/JobSystem.h"
#include "editor/core/PlayLink.h"
#include "editor/lab/AccuracyPoints.h"
#include "editor/lab/LabServices.h"
#include "editor/lab/SettingPictures.h"
#include "editor/lab/StudiedScene.h"
#include "editor/render/View.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace glenoid {

class AccuracyPlot;
class PicturePair;
class StudyBar;

/// What accuracy costs: a study of the open scene, its plot while it grows, what a setting is and costs, and a setting made the scene's
/// own, with pictures before and after. Shows and forwards; studies, settings and edits are editor/lab's.
class AccuracyPanel : public QWidget {
  Q_OBJECT
 public:
  AccuracyPanel(Document& document, PlayLink& link, JobSystem& jobs, const LabServices& services, QWidget* parent = nullptr);

  StudyBar& bar() { return *m_bar; }
  AccuracyPlot& plot() { return *m_plot; }
  SettingPictures& pictures() { return m_pictures; }
  /// From where pictures of before and after are drawn; without it from the scene's first camera.
  void setViewSource(std::function<View()> view) { m_view = std::move(view); }

  void choose(const QString& setting);
  void applyChosen();
  void drawChosen();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* makeChoice();
  QWidget* makeForm();
  void retranslate();
  void refresh();
  void showWords();
  void pick();
  void forgetStudied();
  /// Calls it with the studied scene once that is there.
  void withStudied(std::function<void(std::shared_ptr<const StudiedScene>)> use);
  void withSetting(std::function<void(const Scene& studied, const Scene& made)> use);
  AccuracyView view() const;
  const AccuracyPoint* pointOf(const std::string& id) const;

  Document& m_document;
  PlayLink& m_link;
  JobSystem& m_jobs;
  const LabServices& m_services;
  SettingPictures m_pictures;
  std::function<View()> m_view;
  std::shared_ptr<const StudiedScene> m_studied;  ///< null: not asked for yet
  long m_studies = 0;  ///< how many were begun or opened
  std::optional<Joint> m_lastMade;                ///< that a setting put in the document
  std::string m_pointed;
  StudyBar* m_bar;
  AccuracyPlot* m_plot;
  PicturePair* m_pair;
  QComboBox *m_quantity, *m_against, *m_rule;
  QDoubleSpinBox *m_limit, *m_moment;
  QLabel *m_quantityLabel, *m_againstLabel, *m_momentLabel, *m_words, *m_answer;
  QPushButton *m_pick, *m_apply, *m_compare;
};

}  // namespace glenoid
