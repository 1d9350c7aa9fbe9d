// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/lab/AccuracyPanel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>

#include "editor/core/Sentences.h"
#include "editor/lab/SettingWords.h"
#include "editor/ui/PanelParts.h"
#include "editor/ui/lab/AccuracyPlot.h"
#include "editor/ui/lab/PicturePair.h"
#include "editor/ui/lab/StudyBar.h"

namespace glenoid {
namespace {

constexpr AccuracyAgainst kAgainst[] = {AccuracyAgainst::OwnCells, AccuracyAgainst::FinerCells};
constexpr QSize kPictureSize(720, 540);
enum Rule { kWithin, kTo };

}  // namespace

AccuracyPanel::AccuracyPanel(Document& document, PlayLink& link, JobSystem& jobs, const LabServices& services, QWidget* parent)
    : QWidget(parent), m_document(document), m_link(link), m_jobs(jobs), m_services(services), m_pictures(services.program) {
  m_bar = new StudyBar(QStringLiteral("accuracy"), document, services);
  m_plot = new AccuracyPlot;
  m_words = panel::words("lab.accuracy.words2");
  m_words->setMinimumHeight(3 * fontMetrics().lineSpacing());
  m_words->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_answer = panel::words("lab.accuracy.answer", "hint");
  m_pair = new PicturePair(QStringLiteral("lab.accuracy"));
  m_pair->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(m_bar);
  layout->addWidget(makeForm());
  layout->addWidget(m_plot, 3);
  layout->addWidget(m_words);
  layout->addWidget(m_answer);
  layout->addWidget(makeChoice());
  layout->addWidget(m_pair, 2);
  connect(m_bar, &StudyBar::begun, this, [this] {
    forgetStudied();
    m_plot->setChosen({});
    m_pair->hide();
    refresh();
  });
  connect(m_bar, &StudyBar::newsCame, this, &AccuracyPanel::refresh);
  connect(m_plot, &AccuracyPlot::pointed, this, [this](const QString& id) {
    m_pointed = id.toStdString();
    showWords();
  });
  connect(m_plot, &AccuracyPlot::chosenByHand, this, &AccuracyPanel::showWords);
  connect(&m_document, &Document::changed, this, [this](const ChangeSet& changes) {
    if (changes.everything) m_lastMade.reset();
    showWords();
  });
  connect(&m_pictures, &SettingPictures::drawn, this, [this](const QImage& before, const QImage& after) {
    m_pair->show();
    m_pair->setPictures(before, after);
    showWords();
  });
  connect(&m_pictures, &SettingPictures::failed, this, [this](const QString& sentence) {
    m_bar->say(sentence);
    showWords();
  });
  retranslate();
}

QWidget* AccuracyPanel::makeForm() {
  auto* form = new QWidget;
  auto* grid = new QGridLayout(form);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(4);
  m_quantity = new QComboBox;
  m_quantity->setObjectName(QStringLiteral("lab.accuracy.quantity"));
  for (int q = 0; q < kAccuracyQuantities; ++q) m_quantity->addItem(QString());
  m_against = new QComboBox;
  m_against->setObjectName(QStringLiteral("lab.accuracy.against"));
  m_against->addItems({QString(), QString()});
  m_quantityLabel = new QLabel;
  m_quantityLabel->setBuddy(m_quantity);
  m_againstLabel = new QLabel;
  m_againstLabel->setBuddy(m_against);
  m_rule = new QComboBox;
  m_rule->setObjectName(QStringLiteral("lab.accuracy.rule"));
  m_rule->addItems({QString(), QString()});
  m_limit = panel::field(QStringLiteral("lab.accuracy.limit"), 1e-4, 1e4, 3);
  m_limit->setValue(5);
  m_pick = panel::button("lab.accuracy.pick");
  for (QComboBox* box : {m_quantity, m_against, m_rule}) box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  grid->addWidget(m_quantityLabel, 0, 0);
  grid->addWidget(m_quantity, 0, 1);
  grid->addWidget(m_againstLabel, 0, 2);
  grid->addWidget(m_against, 0, 3, 1, 2);
  grid->addWidget(m_rule, 1, 0, 1, 2);
  grid->addWidget(m_limit, 1, 2, 1, 2);
  grid->addWidget(m_pick, 1, 4);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  connect(m_quantity, &QComboBox::currentIndexChanged, this, [this] { retranslate(); });
  connect(m_against, &QComboBox::currentIndexChanged, this, &AccuracyPanel::refresh);
  connect(m_rule, &QComboBox::currentIndexChanged, this, [this](int rule) {
    m_limit->setValue(rule == kWithin ? 5 : std::isfinite(m_plot->points().floor) ? std::max(1e-3, 4 * m_plot->points().floor) : 0.1);
    retranslate();
  });
  connect(m_pick, &QPushButton::clicked, this, &AccuracyPanel::pick);
  return form;
}

QWidget* AccuracyPanel::makeChoice() {
  auto* choice = new QWidget;
  auto* row = new QHBoxLayout(choice);
  row->setContentsMargins(0, 0, 0, 0);
  m_apply = panel::button("lab.accuracy.apply");
  m_compare = panel::button("lab.accuracy.compare");
  m_moment = panel::field(QStringLiteral("lab.accuracy.moment"), 0.001, 1000, 3);
  m_moment->setValue(0.5);
  m_moment->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  m_momentLabel = new QLabel;
  m_momentLabel->setBuddy(m_moment);
  row->addWidget(m_apply);
  row->addStretch(1);
  row->addWidget(m_compare);
  row->addWidget(m_momentLabel);
  row->addWidget(m_moment);
  connect(m_apply, &QPushButton::clicked, this, &AccuracyPanel::applyChosen);
  connect(m_compare, &QPushButton::clicked, this, &AccuracyPanel::drawChosen);
  return choice;
}

AccuracyView AccuracyPanel::view() const {
  return {kAgainst[std::max(0, m_against->currentIndex())], static_cast<AccuracyQuantity>(std::max(0, m_quantity->currentIndex()))};
}

const AccuracyPoint* AccuracyPanel::pointOf(const std::string& id) const {
  for (const AccuracyPoint& point : m_plot->points().points)
    if (point.id == id && !id.empty()) return &point;
  return nullptr;
}

void AccuracyPanel::refresh() {
  m_plot->setPoints(accuracyPoints(m_bar->study(), view()));
  const AccuracyPoints& points = m_plot->points();
  QString answer;
  if (!points.missing.empty()) answer = tr("There is no reference of this kind: %1").arg(QString::fromStdString(points.missing));
  else if (m_bar->study().isWhole()) {
    const auto found = points.pickForBudget(5);
    answer = found ? tr("Within 5 ms, %1 is nearest: %2 of %3 error, %4 a step.")
                         .arg(settingWords(points.points[*found].id), errorText(points.view.quantity, points.points[*found].error), quantityName(points.view.quantity),
                              msText(points.points[*found].ms))
                   : tr("No setting stays within 5 ms.");
  }
  m_answer->setText(answer);
  m_answer->setVisible(!answer.isEmpty());
  showWords();
}

void AccuracyPanel::showWords() {
  const AccuracyPoint* chosen = pointOf(m_plot->chosen());
  const AccuracyPoint* shown = m_pointed.empty() ? chosen : pointOf(m_pointed);
  QString words = m_plot->points().points.empty() ? tr("Run a study, and each setting becomes a point: the nearer to the lower left the better.") : tr("Point at a setting to see what it is; click it to choose it.");
  if (shown) {
    QString name = settingWords(shown->id);
    name[0] = name[0].toUpper();
    words = QStringLiteral("<b>%1</b><br>").arg(name.toHtmlEscaped());
    if (!shown->failure.empty()) {
      words += tr("No error can be given: %1.").arg(failureWords(shown->failure, shown->detail).toHtmlEscaped());
    } else {
      const AccuracyQuantity quantity = m_plot->points().view.quantity;
      if (!std::isfinite(shown->error))
        words += tr("It has no error of %1 against this reference; %2 a step, %3 in 95 of 100.").arg(quantityName(quantity), msText(shown->ms), msText(shown->p95));
      else if (shown->where.empty())
        words += tr("%1 of %2 error; %3 a step, %4 in 95 of 100.").arg(errorText(quantity, shown->error), quantityName(quantity), msText(shown->ms), msText(shown->p95));
      else
        words += tr("%1 of %2 error, largest for %3; %4 a step, %5 in 95 of 100.")
                     .arg(errorText(quantity, shown->error), quantityName(quantity), QString::fromStdString(shown->where).toHtmlEscaped(), msText(shown->ms), msText(shown->p95));
      if (std::isfinite(m_plot->points().floor) && shown->error <= m_plot->points().floor) words += QLatin1Char(' ') + tr("That is less than the reference’s own error.");
      if (shown->rough) words += QLatin1Char(' ') + tr("Its time is a guess until times are taken.");
    }
    if (!shown->inScenario) words += QLatin1Char(' ') + tr("No scenario can say it, so it cannot be applied.");
  }
  m_words->setText(words);
  m_apply->setEnabled(chosen && chosen->inScenario && !m_document.isEmpty());
  m_compare->setEnabled(chosen && chosen->inScenario && !m_pictures.isBusy() && !m_services.program.isEmpty());
}

void AccuracyPanel::choose(const QString& setting) {
  m_plot->setChosen(setting.toStdString());
  m_pointed.clear();
  showWords();
}

void AccuracyPanel::pick() {
  const AccuracyPoints& points = m_plot->points();
  const double limit = m_limit->value();
  if (m_rule->currentIndex() == kTo && limit < 2 * points.floor)
    return m_bar->say(tr("%1 is less than twice the reference’s own error, %2: nothing can be told apart there.")
                          .arg(errorText(points.view.quantity, limit), errorText(points.view.quantity, 2 * points.floor)));
  const auto found = m_rule->currentIndex() == kTo ? points.pickForAccuracy(limit) : points.pickForBudget(limit);
  m_bar->say(found ? QString()
             : m_rule->currentIndex() == kTo ? tr("No setting is that accurate.")
                                             : tr("No setting stays within %1.").arg(msText(limit)));
  if (found) choose(QString::fromStdString(points.points[*found].id));
}

void AccuracyPanel::forgetStudied() {
  m_studied = nullptr;
  ++m_studies;
}

void AccuracyPanel::withStudied(std::function<void(std::shared_ptr<const StudiedScene>)> use) {
  if (m_studied) return use(m_studied);
  const auto always = [](const Scene&, const Scene&) { return true; };
  const std::shared_ptr<const Scene> scene = m_bar->scene();
  m_jobs.start<std::shared_ptr<const StudiedScene>>(
      tr("Read the studied scene"),
      [scene, loader = m_services.loader, word = m_bar->study().head()["scenario"].text()](JobContext&) -> Result<std::shared_ptr<const StudiedScene>> {
        if (scene) return StudiedScene::make(*scene);
        Result<Scene> loaded = loader(word);
        if (!loaded) return loaded.error();
        return StudiedScene::make(std::move(*loaded));
      },
      [this, use, study = m_studies](std::shared_ptr<const StudiedScene> studied) {
        if (study != m_studies) return;  // another was begun or opened meanwhile
        m_studied = studied;
        use(studied);
      },
      always);
}

void AccuracyPanel::withSetting(std::function<void(const Scene& studied, const Scene& made)> use) {
  const std::string id = m_plot->chosen();
  if (id.empty()) return;
  withStudied([this, id, use](std::shared_ptr<const StudiedScene> studied) {
    const auto always = [](const Scene&, const Scene&) { return true; };
    m_jobs.start<Scene>(
        tr("Prepare the setting"), [studied, id](JobContext&) { return studied->with(id); }, [studied, use](const Scene& made) { use(studied->scene(), made); }, always);
  });
}

void AccuracyPanel::applyChosen() {
  const QString words = settingWords(m_plot->chosen());
  withSetting([this, words](const Scene& studied, const Scene& made) {
    const SettingApplied applied = applySetting(m_document, studied, made, m_lastMade, words);
    if (!applied.refused && !applied.sentence.isEmpty()) m_lastMade = m_document.joint();
    m_bar->say(applied.refused            ? applied.sentence
               : applied.sentence.isEmpty() ? tr("The scene has this setting already.")
                                            : tr("%1 Undo brings back what was.").arg(applied.sentence));
  });
}

void AccuracyPanel::drawChosen() {
  const QString words = settingWords(m_plot->chosen());
  withSetting([this, words](const Scene& studied, const Scene& made) {
    const View view = m_view ? m_view() : studied.scenario.cameras.empty() ? View() : viewOf(studied.scenario.cameras.front());
    m_pair->setWords(tr("Before: the scene as it was studied"), tr("After: %1").arg(words));
    m_pictures.draw(studied, made, view, m_moment->value(), kPictureSize);
    showWords();
  });
}

void AccuracyPanel::retranslate() {
  for (int q = 0; q < kAccuracyQuantities; ++q) m_quantity->setItemText(q, quantityName(static_cast<AccuracyQuantity>(q)));
  for (int a = 0; a < 2; ++a) m_against->setItemText(a, againstName(kAgainst[a]));
  m_quantityLabel->setText(tr("&Error of"));
  m_againstLabel->setText(tr("a&gainst"));
  m_quantity->setAccessibleName(tr("Which error is shown"));
  m_against->setAccessibleName(tr("With what settings are compared"));
  m_rule->setItemText(kWithin, tr("Most accurate within"));
  m_rule->setItemText(kTo, tr("Fastest that reaches"));
  m_rule->setAccessibleName(tr("How a setting is chosen"));
  m_limit->setAccessibleName(tr("Budget or accuracy"));
  m_limit->setSuffix(m_rule->currentIndex() == kWithin ? tr(" ms") : isLengthQuantity(view().quantity) ? tr(" mm") : tr(" N"));
  m_pick->setText(tr("&Choose"));
  m_pick->setToolTip(tr("Choose the setting that this asks for"));
  m_apply->setText(tr("&Apply to the scene"));
  m_apply->setToolTip(tr("Let the scene run with the chosen setting; can be undone"));
  m_compare->setText(tr("&Before and after"));
  m_compare->setToolTip(tr("Draw the same moment of the run with the scene’s setting and with the chosen one, side by side"));
  m_momentLabel->setText(tr("a&t"));
  m_moment->setSuffix(tr(" s"));
  m_moment->setAccessibleName(tr("Moment of the run that is drawn"));
  m_plot->setAccessibleName(tr("Error beside computing time, a point for each setting"));
  m_plot->setAccessibleDescription(tr("The arrow keys go through the settings, Enter chooses one"));
  refresh();
}

void AccuracyPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace glenoid
