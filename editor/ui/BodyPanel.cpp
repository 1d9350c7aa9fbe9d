// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/BodyPanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFile>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

#include "editor/core/AnatomyNames.h"
#include "editor/core/AuthorEdits.h"
#include "editor/core/Sentences.h"
#include "editor/core/tools/MeshPicture.h"
#include "editor/ui/Numbers.h"
#include "simcore/mesh/TetTools.h"
#include "simcore/scene/MaterialLibrary.h"

namespace glenoid {
namespace {

constexpr double kLeastCell = 0.3, kMostCell = 60;  // mm

std::vector<Material> shippedMaterials() {
  QFile file(QStringLiteral(":/materials/tissues.json"));
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QByteArray text = file.readAll();
  auto library =
      parseMaterialLibrary({text.constData(), static_cast<std::size_t>(text.size())}, "tissues.json");
  return library.ok() ? std::move(library).value() : std::vector<Material>{};  // a test reads it and says why
}

QImage imageOf(const Image& image) {
  return QImage(image.rgba.data(), image.width, image.height, 4 * image.width, QImage::Format_RGBA8888)
      .copy();
}

}  // namespace

BodyPanel::BodyPanel(Document& document, Authoring& authoring, QWidget* parent)
    : QWidget(parent), m_document(document), m_authoring(authoring), m_library(shippedMaterials()) {
  setObjectName(QStringLiteral("bodies"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* scroll = new QScrollArea;
  scroll->setObjectName(QStringLiteral("bodies.controls"));
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(340);
  scroll->setMaximumWidth(420);
  scroll->setWidget(makeControls());
  layout->addWidget(scroll);
  layout->addWidget(makePictures(), 1);
  connect(&document, &Document::changed, this, [this](const ChangeSet& changes) {
    if (changes.everything || !changes.parts.empty() || !changes.materials.empty()) refreshPart();
  });
  connect(&authoring, &Authoring::targetChanged, this, &BodyPanel::takePart);
  connect(&authoring, &Authoring::selectionChanged, this, &BodyPanel::showFigures);
  retranslate();
}

const Part* BodyPanel::part() const {
  const int index = findPart(m_document.joint(), m_authoring.part());
  return index < 0 ? nullptr : &m_document.joint().parts[index];
}

// ---- What is shown

void BodyPanel::refreshPart() {
  const Part* shown = part();
  const bool same = shown && shown->id == m_taken.id && shown->kind == m_taken.kind &&
                    shown->visual == m_taken.visual && shown->collision == m_taken.collision &&
                    shown->volume == m_taken.volume && shown->cellSize == m_taken.cellSize;
  if (!same) return takePart();
  refreshMaterials();  // what was tried and not yet applied stays
  showFigures();
}

void BodyPanel::takePart() {
  const Part* shown = part();
  m_taken = shown ? *shown : Part{};
  m_name->setText(shown ? anatomyName(shown->name) : tr("No part is chosen."));
  refreshMaterials();
  setEnabled(shown && shown->visual);
  if (!shown || !shown->visual) {
    m_bodyJob.drop();
    m_made.reset();
    m_visual.reset();
    return showFigures();
  }
  if (shown->visual != m_visual) m_important.clear();
  m_visual = shown->visual;
  {
    const QScopedValueRollback guard(m_showing, true);
    m_kind->setCurrentIndex(shown->kind == PartKind::Soft ? 1 : 0);
    const auto count = shown->collision ? shown->collision->triangles.size()
                                        : std::min<std::size_t>(500, shown->visual->triangles.size());
    m_triangles->setValue(static_cast<int>(count));
    const double size = 1e3 * ::glenoid::boundsOf(*shown->visual).diagonal().norm();
    m_cell->setValue(shown->cellSize > 0 ? 1e3 * shown->cellSize
                                         : std::clamp(size / 12, kLeastCell, kMostCell));
    m_ownAxes->setChecked(false);
  }
  m_error.reset();
  m_madeWish.reset();
  // What the part has needs no making: the pictures show it as it is.
  Body body;
  body.collision = shown->collision ? shown->collision : shown->visual;
  body.volume = shown->volume;
  body.figures.visualTriangles = static_cast<int>(shown->visual->triangles.size());
  body.figures.collisionTriangles = static_cast<int>(body.collision->triangles.size());
  if (shown->volume) {
    body.figures.tetrahedra = static_cast<int>(shown->volume->tets.size());
    body.figures.nodes = static_cast<int>(shown->volume->nodes.size());
  }
  m_bodyJob.drop();
  m_made = body;
  showFigures();
  askPictures();
}

void BodyPanel::refreshMaterials() {
  const QSignalBlocker quiet(m_material);
  m_material->clear();
  const Part* shown = part();
  const Joint& joint = m_document.joint();
  for (const Material& material : joint.materials)
    m_material->addItem(anatomyName(material.name), QString::fromStdString(material.id));
  m_material->insertSeparator(m_material->count());
  for (const Material& material : m_library) {
    if (findMaterial(joint, material.id) >= 0) continue;
    m_material->addItem(tr("%1 (library)").arg(anatomyName(material.name)),
                        QString::fromStdString(material.id));
    m_material->setItemData(m_material->count() - 1, QString::fromStdString(material.source),
                            Qt::ToolTipRole);
  }
  const bool any = shown && !shown->materials.empty();
  m_material->setCurrentIndex(any ? m_material->findData(QString::fromStdString(shown->materials[0].material))
                                  : -1);
  m_ownMaterial->setEnabled(any);
}

BodyWish BodyPanel::wish() const {
  BodyWish wish;
  wish.kind = m_kind->currentIndex() == 1 ? PartKind::Soft : PartKind::Rigid;
  wish.collisionTriangles = m_triangles->value();
  wish.cellSize = 1e-3 * m_cell->value();
  wish.axes = m_ownAxes->isChecked() ? GridAxes::Principal : GridAxes::World;
  if (m_visual && !m_important.empty()) {
    wish.importance.assign(m_visual->vertices.size(), 1);
    for (const int t : m_important)
      for (const int v : m_visual->triangles[t]) wish.importance[v] = m_factor->value();
  }
  return wish;
}

void BodyPanel::ask() {
  const Part* shown = part();
  if (!shown || !shown->visual) return;
  BodyWish wanted = wish();
  // Another cell size does not change the surface, which takes longer to make.
  if (m_made && m_madeWish && m_madeWish->collisionTriangles == wanted.collisionTriangles &&
      m_madeWish->importance == wanted.importance) {
    wanted.collision = m_made->collision;
  } else if (!m_madeWish && m_made && m_important.empty() &&
             wanted.collisionTriangles == m_made->figures.collisionTriangles) {
    wanted.collision = m_made->collision;
  }
  m_error.reset();
  m_bodyJob.ask([this, copy = *shown, wanted](const std::atomic<bool>& stale) -> LatestJob::Answer {
    auto body = makeBody(copy, wanted, [&stale] { return stale.load(); });
    return [this, wanted, visual = copy.visual, body = std::move(body)] {
      if (visual != m_visual) return;
      if (body.ok()) {
        m_made = *body;
        m_madeWish = wanted;
        m_error.reset();
      } else {
        m_madeWish.reset();
        m_error = body.error();
      }
      showFigures();
      askPictures();
    };
  });
  showFigures();
}

void BodyPanel::showFigures() {
  const bool soft = m_kind->currentIndex() == 1;
  for (QWidget* widget : std::initializer_list<QWidget*>{m_cellSlider, m_cell, m_ownAxes})
    widget->setEnabled(soft);
  m_apply->setEnabled(m_madeWish && m_made && !m_bodyJob.busy());
  m_revert->setEnabled(m_madeWish || m_error || m_bodyJob.busy());
  m_markButton->setEnabled(m_visual && m_authoring.mesh() == m_visual &&
                           m_authoring.surface() == SurfaceKind::Visual && !m_authoring.selected().empty());
  m_unmark->setEnabled(!m_important.empty());
  m_matter->setText(
      m_important.empty()
          ? tr("Paint on the part in the view where the collision surface shall be finer, then mark it here.")
          : tr("%n triangle(s) matter more than the others.", nullptr, static_cast<int>(m_important.size())));
  m_outcome->setVisible(m_error.has_value());
  if (m_error) m_outcome->setText(sentenceOf(*m_error));
  const Part* shown = part();
  if (!m_made || !shown) return m_figures->clear();
  const BodyFigures& figures = m_made->figures;
  m_captions[0]->setText(tr("%n triangle(s) are seen", nullptr, figures.visualTriangles));
  m_captions[1]->setText(tr("%n triangle(s) collide", nullptr, figures.collisionTriangles));
  m_captions[2]->setText(m_made->volume ? tr("%n tetrahedron(s) deform", nullptr, figures.tetrahedra)
                                        : tr("Nothing deforms: the part is rigid"));
  if (m_bodyJob.busy()) return m_figures->setText(tr("Making the meshes…"));
  if (!m_madeWish)
    return m_figures->setText(tr("This is what the part has. Move a slider to try another body."));
  QStringList lines;
  lines << tr("The collision surface leaves the visual one by %1 mm at most, %2 mm on average; its volume is "
              "off by %3 %.")
               .arg(number(1e3 * figures.deviationMax, 2), number(1e3 * figures.deviationMean, 2),
                    number(100 * std::abs(figures.volumeError), 2));
  if (m_made->volume) {
    lines << tr("%1 with %2; tissue fills %3 % of them, the emptiest %4 %.")
                 .arg(tr("%n tetrahedron(s)", nullptr, figures.tetrahedra),
                      tr("%n node(s)", nullptr, figures.nodes), number(100 * figures.meanFill, 0),
                      number(100 * figures.leastFill, 0));
    lines << tr("The part is about %1 mm thick and will add about %2 ms to a step, without contacts.")
                 .arg(number(1e3 * figures.thinnest, 1), number(figures.stepMs, 2));
    if (figures.pieces > 1)
      lines << tr("The tetrahedra fall into %n piece(s): take smaller cells.", nullptr, figures.pieces);
  }
  m_figures->setText(lines.join(QLatin1Char('\n')));
}

void BodyPanel::askPictures() {
  if (!m_made || !m_visual || !isVisible()) return;
  const Part* shown = part();
  const QSize size = m_pictures[0]->size() * 2;  // drawn twice as large and made smaller, for soft edges
  if (!shown || size.width() < 20 || size.height() < 20) return;
  View view = m_viewSource ? m_viewSource() : View{};
  m_picturedView = view;
  view = framed(view, ::glenoid::boundsOf(*m_visual), static_cast<double>(size.width()) / size.height());
  const Viewport viewport{view, size.width(), size.height()};
  m_pictureJob.ask([this, viewport, color = shown->color, visual = m_visual, body = *m_made,
                    important = m_important](const std::atomic<bool>& stale) -> LatestJob::Answer {
    std::vector<QImage> images;
    images.push_back(imageOf(meshPicture(*visual, viewport, {color, true, false, important})));
    if (stale) return {};
    images.push_back(imageOf(meshPicture(*body.collision, viewport, {color, false, true, {}})));
    if (stale) return {};
    if (body.volume)
      images.push_back(imageOf(meshPicture(boundaryOf(*body.volume), viewport, {color, false, true, {}})));
    return [this, images] {
      for (std::size_t i = 0; i < m_pictures.size(); ++i) {
        if (i >= images.size()) {
          m_pictures[i]->setPixmap({});
          continue;
        }
        m_pictures[i]->setPixmap(QPixmap::fromImage(
            images[i].scaled(images[i].size() / 2, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)));
      }
    };
  });
}

void BodyPanel::viewMoved() {
  if (!isVisible() || !m_viewSource) return;
  const View view = m_viewSource();
  const ViewAxes now = axesOf(view), before = axesOf(m_picturedView);
  if ((now.back_W - before.back_W).norm() + (now.up_W - before.up_W).norm() > 1e-6) askPictures();
}

// ---- What is done

void BodyPanel::mark() {
  m_important = m_authoring.selected();
  ask();
}

void BodyPanel::apply() {
  if (!m_madeWish || !m_made || m_bodyJob.busy()) return;
  const BodyWish wanted = *m_madeWish;
  const Body body = *m_made;
  QString said;
  const bool done = setBody(m_document, m_authoring.part(), wanted, body, &said);
  if (!done && said.isEmpty()) said = tr("A region on the collision surface that is in use would be lost; take more triangles there.");
  m_outcome->setText(said);
  m_outcome->setVisible(!said.isEmpty());
}

void BodyPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void BodyPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  askPictures();
}

void BodyPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  askPictures();
}

}  // namespace glenoid
