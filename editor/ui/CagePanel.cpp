// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/CagePanel.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "editor/core/AnatomyNames.h"
#include "editor/core/AuthorEdits.h"
#include "editor/core/SameScene.h"
#include "editor/core/Sentences.h"
#include "editor/ui/Numbers.h"
#include "simcore/author/MakeCage.h"
#include "simcore/author/SeparateStart.h"
#include "simcore/scene/JointFile.h"

namespace glenoid {
namespace {

QString nameOf(const Joint& joint, int part) {
  return anatomyName(joint.parts[part].name);
}

}  // namespace

CagePanel::CagePanel(Document& document, Selection& selection, Authoring& authoring, JobSystem& jobs,
                     QWidget* parent)
    : QScrollArea(parent),
      m_document(document),
      m_selection(selection),
      m_authoring(authoring),
      m_jobs(jobs) {
  setObjectName(QStringLiteral("cages"));
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setMinimumWidth(310);
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(makeCageBox());
  layout->addWidget(makeOverlapBox());
  layout->addStretch(1);
  setWidget(content);

  m_later.setSingleShot(true);
  m_later.setInterval(60);
  connect(&m_later, &QTimer::timeout, this, &CagePanel::askOverlaps);
  const auto soon = [this] {
    if (isVisible() && !m_later.isActive()) m_later.start();
  };
  connect(&document, &Document::changed, this, [this, soon](const ChangeSet& changes) {
    refreshProof();
    if (!changes.everything && changes.parts.empty()) return refresh();
    m_overlapsKnown = false;
    refresh();
    soon();
  });
  connect(&authoring, &Authoring::cageChanged, this, [this, soon] {
    refresh();
    if (m_authoring.cage().isDragging()) soon();
  });
  connect(&authoring, &Authoring::targetChanged, this, &CagePanel::refresh);
  connect(&selection, &Selection::changed, this, [this] {
    if (m_authoring.tool() == Authoring::Tool::Cage &&
        findPart(m_document.joint(), m_selection.current()) >= 0)
      m_authoring.setTarget(m_selection.current(), m_authoring.surface());
  });
  connect(&jobs, &JobSystem::changed, this, &CagePanel::showJob);
  connect(&jobs, &JobSystem::ended, this, [this](int id, JobSystem::End end, const QString& sentence) {
    if (id != m_job) return;
    m_job = 0;
    m_progress->hide();
    if (end == JobSystem::End::Cancelled)
      m_outcome->setText(tr("Stopped; nothing was changed."));
    else if (!sentence.isEmpty())
      m_outcome->setText(sentence);
    refresh();
  });
  retranslate();
}

// ---- What is shown

void CagePanel::showEvent(QShowEvent* event) {
  QScrollArea::showEvent(event);
  if (!m_overlapsKnown) m_later.start();
}

void CagePanel::refresh() {
  const QScopedValueRollback guard(m_showing, true);
  const Joint& joint = m_document.joint();
  const int part = findPart(joint, m_authoring.part());
  const bool soft = part >= 0 && joint.parts[part].kind == PartKind::Soft && joint.parts[part].volume;
  const Cage* cage = part < 0 ? nullptr : findCage(joint, joint.parts[part].id);
  const bool free = m_job == 0;
  m_part->setText(part < 0 ? tr("none") : nameOf(joint, part));
  m_make->setEnabled(soft && free);
  m_reset->setEnabled(cage && free && cage->moved_W != cage->rest_W);
  m_remove->setEnabled(cage && free);
  m_suggest->setEnabled(!m_document.isEmpty() && free);
  m_prove->setEnabled(!m_document.isEmpty() && free);
  m_stop->setEnabled(!free);
  const CageTool& tool = m_authoring.cage();
  const int count = static_cast<int>(tool.picked().size());
  m_picked->setText(!soft ? tr("A cage goes around a soft part with tetrahedra. Choose one among the parts.")
                    : !cage      ? tr("This part has no cage yet.")
                    : count == 0 ? tr("%n handle(s); pick some in the view to move them.", nullptr,
                                      static_cast<int>(cage->rest_W.size()))
                                 : tr("%n handle(s) picked. Their mean shift from rest:", nullptr, count));
  m_labels[4]->setText(lateralSign(joint.side) > 0 ? tr("Lateral:") : tr("Medial:"));  // along Z of the joint
  const Vec3 shift = count ? 1e3 * tool.meanShift() : Vec3(Vec3::Zero());
  for (int axis = 0; axis < 3; ++axis) {
    m_shift[axis]->setEnabled(count > 0);
    m_shift[axis]->setValue(shift[axis]);
  }
}

void CagePanel::refreshProof() {
  const Joint& joint = m_document.joint();
  const auto& proof = joint.startProof;
  if (!proof) {
    m_proof->setText(tr("The start has not been proved."));
  } else if (proof->of != startHash(joint)) {
    m_proof->setText(tr("The proof is of an older start; prove it again."));
  } else if (proof->cuts == 0 && proof->minVolumeRatio > kLeastVolumeRatio) {
    m_proof->setText(
        tr("Proved: no triangles cut among %1, least volume ratio %2.")
            .arg(tr("%n pair(s) of parts", nullptr, proof->pairs), number(proof->minVolumeRatio, 2)));
  } else {
    m_proof->setText(tr("The proof fails: %1, least volume ratio %2.")
                         .arg(tr("%n cut(s)", nullptr, proof->cuts), number(proof->minVolumeRatio, 2)));
  }
}

void CagePanel::showOverlaps(const std::vector<Overlap>& overlaps, const std::vector<TriMesh>& surfaces) {
  const QScopedValueRollback guard(m_showing, true);
  const Joint& joint = m_document.joint();
  std::pair<int, int> chosen{-1, -1};
  if (const int row = m_list->indexOfTopLevelItem(m_list->currentItem());
      row >= 0 && row < static_cast<int>(m_overlaps.size()))
    chosen = {m_overlaps[row].partA, m_overlaps[row].partB};
  m_overlaps = overlaps;
  m_cuts_W.clear();
  m_list->clear();
  std::vector<Vec3> shown;
  for (const Overlap& overlap : overlaps) {
    std::vector<Vec3>& cuts = m_cuts_W.emplace_back();
    for (const auto& cut : overlap.cuts) {
      const TriMesh& surface = surfaces[overlap.partA];
      const auto& t = surface.triangles[cut[0]];
      cuts.push_back((surface.vertices[t[0]] + surface.vertices[t[1]] + surface.vertices[t[2]]) / 3);
    }
    cuts.push_back(overlap.deepest_W);
    auto* item = new QTreeWidgetItem(
        m_list, {tr("%1 and %2").arg(nameOf(joint, overlap.partA), nameOf(joint, overlap.partB)),
                 tr("%1 mm").arg(number(1e3 * overlap.depth, 2)), number(overlap.cuts.size())});
    if (std::pair(overlap.partA, overlap.partB) == chosen) {
      m_list->setCurrentItem(item);
      shown = cuts;
    }
  }
  for (int column = 0; column < 3; ++column) m_list->resizeColumnToContents(column);
  m_summary->setText(overlaps.empty() ? tr("No two parts that may collide overlap at the start.")
                                      : tr("%n pair(s) of parts overlap at the start.", nullptr,
                                           static_cast<int>(overlaps.size())));
  m_authoring.showCuts(std::move(shown));
}

void CagePanel::askOverlaps() {
  if (m_document.isEmpty()) return;
  if (m_overlapJob.busy() && m_authoring.cage().isDragging()) {
    m_later.start();  // one after the other: a list that never comes is not live
    return;
  }
  m_overlapJob.ask([this, joint = m_authoring.liveJoint(), starts = m_authoring.sharedStarts()](
                       const std::atomic<bool>& stale) -> LatestJob::Answer {
    auto surfaces = starts->of(joint);
    if (stale) return {};
    if (!surfaces.ok()) {
      return [this, error = surfaces.error()] { m_summary->setText(sentenceOf(error)); };
    }
    auto overlaps = findOverlaps(joint, *surfaces);
    return [this, overlaps = std::move(overlaps), surfaces = std::move(surfaces).value(),
            parts = joint.parts.size()] {
      if (parts != m_document.joint().parts.size()) return;
      m_overlapsKnown = true;
      showOverlaps(overlaps, surfaces);
    };
  });
}

// ---- What is done

namespace {

/// What a start depends on is the same in both.
bool sameStart(const Scene& then, const Scene& now) {
  const Joint &a = then.joint, &b = now.joint;
  return a.exclusions == b.exclusions && a.cages == b.cages &&
         std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(),
                    [](const Part& p, const Part& q) {
                      return p.id == q.id && p.kind == q.kind && sameMeshes(p, q);
                    });
}

}  // namespace

void CagePanel::begin(int job, const QString& phase) {
  m_job = job;
  m_progress->setRange(0, 0);
  m_progress->show();
  m_outcome->setText(phase);
  refresh();
}

void CagePanel::showJob() {
  for (const JobSystem::Info& info : m_jobs.jobs()) {
    if (info.id != m_job) continue;
    if (!info.phase.isEmpty()) m_outcome->setText(info.phase);
    if (info.done <= 0) continue;
    m_progress->setRange(0, 1000);
    m_progress->setValue(static_cast<int>(1000 * info.done));
  }
}

void CagePanel::makeTheCage() {
  const int index = findPart(m_document.joint(), m_authoring.part());
  if (index < 0 || m_job) return;
  const Part part = m_document.joint().parts[index];
  const int handles = m_handles->value();
  begin(m_jobs.start<Cage>(
            tr("Make a cage around %1").arg(anatomyName(part.name)),
            [part, handles](JobContext&) -> Result<Cage> { return makeCage(part, handles); },
            [this, name = anatomyName(part.name)](const Cage& cage) {
              setCage(m_document, cage, tr("Make a cage around %1").arg(name));
              m_authoring.setTool(Authoring::Tool::Cage);
              m_outcome->clear();
            },
            JobSystem::partsAreTheSame({part.id})),
        tr("Making the cage…"));
}

void CagePanel::resetCage() {
  if (const Cage* cage = findCage(m_document.joint(), m_authoring.part())) {
    const std::vector<Vec3> rest = cage->rest_W;
    m_document.endGesture();
    moveHandles(m_document, m_authoring.part(), rest);
  }
}

void CagePanel::suggest() {
  if (m_job) return;
  StartWishes wishes;
  wishes.clearance = 1e-3 * m_clearance->value();
  wishes.handles = m_handles->value();
  struct Found {
    Joint joint;
    SeparationOutcome outcome;
  };
  begin(m_jobs.start<Found>(
            tr("Separate the start by cages"),
            [joint = m_document.joint(), wishes](JobContext& context) -> Result<Found> {
              Found found{joint, {}};
              auto outcome = separateStart(found.joint, wishes, [&context](double done, int overlaps) {
                context.phase(tr("Moving cages apart: %n pair(s) still overlap.", nullptr, overlaps));
                return context.progress(done);
              });
              if (!outcome) return outcome.error();
              found.outcome = std::move(*outcome);
              return found;
            },
            [this](const Found& found) {
              setStart(m_document, found.joint.cages, found.joint.startProof,
                       tr("Separate the start by cages"));
              m_outcome->setText(
                  found.outcome.check.holds()
                      ? tr("Nothing overlaps any more; the surface moved by %1 mm at most.")
                            .arg(number(1e3 * found.outcome.maxShift, 1))
                      : tr("%n pair(s) still overlap; move their cages by hand or allow more handles.",
                           nullptr, static_cast<int>(found.outcome.check.overlaps.size())));
            },
            sameStart),
        tr("Moving cages apart…"));
}

void CagePanel::prove() {
  if (m_job) return;
  begin(m_jobs.start<StartCheck>(
            tr("Prove the start"), [joint = m_document.joint()](JobContext&) { return checkStart(joint); },
            [this](const StartCheck& check) {
              setStart(m_document, m_document.joint().cages, check.proof, tr("Prove the start"));
              m_outcome->clear();
            },
            sameStart),
        tr("Counting every cut…"));
}

void CagePanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QScrollArea::changeEvent(event);
}

}  // namespace glenoid
