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

constexpr int kSliderSteps = 400;

/// Sliders are logarithmic: as far from 50 to 100 triangles as from 5000 to 10 000.
int toSlider(double value, double low, double high) {
  return static_cast<int>(std::lround(kSliderSteps * std::log(value / low) / std::log(high / low)));
}
double fromSlider(int step, double low, double high) { return low * std::pow(high / low, static_cast<double>(step) / kSliderSteps); }

constexpr double kLeastTriangles = 12, kMostTriangles = 20000, kLeastCell = 0.3, kMostCell = 60;  // mm

std::vector<Material> shippedMaterials() {
  QFile file(QStringLiteral(":/materials/tissues.json"));
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QByteArray text = file.readAll();
  auto library = parseMaterialLibrary({text.constData(), static_cast<std::size_t>(text.size())}, "tissues.json");
  return library.ok() ? std::move(library).value() : std::vector<Material>{};  // a test reads it and says why
}

QImage imageOf(const Image& image) {
  return QImage(image.rgba.data(), image.width, image.height, 4 * image.width, QImage::Format_RGBA8888).copy();
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

// ---- Widgets

QWidget* BodyPanel::makeControls() {
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(8, 8, 8, 8);
  auto* box = new QGroupBox;
  m_groups.push_back(box);
  auto* form = new QFormLayout(box);
  const auto row = [&](QWidget* widget, QWidget* beside = nullptr) {
    auto* label = new QLabel;
    label->setBuddy(widget);
    m_labels.push_back(label);
    if (!beside) return form->addRow(label, widget);
    auto* pair = new QHBoxLayout;
    pair->addWidget(widget, 3);
    pair->addWidget(beside, 2);
    form->addRow(label, pair);
  };
  const auto button = [](const char* name) {
    auto* made = new QPushButton;
    made->setObjectName(QLatin1String(name));
    return made;
  };
  const auto slider = [](const char* name) {
    auto* made = new QSlider(Qt::Horizontal);
    made->setObjectName(QLatin1String(name));
    made->setRange(0, kSliderSteps);
    made->setFocusPolicy(Qt::StrongFocus);
    return made;
  };
  m_name = new QLabel;
  m_name->setProperty("role", QStringLiteral("title"));
  form->addRow(m_name);
  m_kind = new QComboBox;
  m_kind->setObjectName(QStringLiteral("bodies.kind"));
  m_kind->addItems({{}, {}});
  row(m_kind);
  m_triangleSlider = slider("bodies.triangleSlider");
  m_triangles = new QSpinBox;
  m_triangles->setObjectName(QStringLiteral("bodies.triangles"));
  m_triangles->setRange(4, 2000000);
  row(m_triangleSlider, m_triangles);
  m_cellSlider = slider("bodies.cellSlider");
  m_cell = new QDoubleSpinBox;
  m_cell->setObjectName(QStringLiteral("bodies.cell"));
  m_cell->setRange(kLeastCell, kMostCell);
  m_cell->setDecimals(2);
  row(m_cellSlider, m_cell);
  m_ownAxes = new QCheckBox;
  m_ownAxes->setObjectName(QStringLiteral("bodies.ownAxes"));
  form->addRow(m_ownAxes);
  m_material = new QComboBox;
  m_material->setObjectName(QStringLiteral("bodies.material"));
  m_material->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  m_ownMaterial = button("bodies.ownMaterial");
  row(m_material, m_ownMaterial);
  for (QWidget* widget : std::initializer_list<QWidget*>{m_kind, m_triangles, m_cell, m_material}) widget->setFocusPolicy(Qt::StrongFocus);
  for (QAbstractSpinBox* spin : std::initializer_list<QAbstractSpinBox*>{m_triangles, m_cell}) spin->setKeyboardTracking(false);
  layout->addWidget(box);

  auto* matter = new QGroupBox;
  m_groups.push_back(matter);
  auto* matterLayout = new QVBoxLayout(matter);
  m_matter = new QLabel;
  m_matter->setWordWrap(true);
  m_matter->setProperty("role", QStringLiteral("hint"));
  matterLayout->addWidget(m_matter);
  m_factor = new QSpinBox;
  m_factor->setObjectName(QStringLiteral("bodies.factor"));
  m_factor->setRange(2, 10000);
  m_factor->setValue(30);
  m_factor->setKeyboardTracking(false);
  m_factor->setFocusPolicy(Qt::StrongFocus);
  m_markButton = button("bodies.mark");
  m_unmark = button("bodies.unmark");
  auto* matterRow = new QHBoxLayout;
  for (QWidget* each : std::initializer_list<QWidget*>{m_markButton, m_factor, m_unmark}) matterRow->addWidget(each);
  matterLayout->addLayout(matterRow);
  layout->addWidget(matter);

  layout->addStretch(1);

  connect(m_kind, &QComboBox::currentIndexChanged, this, [this] {
    if (!m_showing) ask();
  });
  connect(m_triangleSlider, &QSlider::valueChanged, this, [this](int step) {
    if (!m_showing) m_triangles->setValue(static_cast<int>(std::lround(fromSlider(step, kLeastTriangles, kMostTriangles))));
  });
  connect(m_triangles, &QSpinBox::valueChanged, this, [this](int count) {
    {
      const QScopedValueRollback guard(m_showing, true);
      m_triangleSlider->setValue(toSlider(count, kLeastTriangles, kMostTriangles));
    }
    if (!m_showing) ask();
  });
  connect(m_cellSlider, &QSlider::valueChanged, this, [this](int step) {
    if (!m_showing) m_cell->setValue(fromSlider(step, kLeastCell, kMostCell));
  });
  connect(m_cell, &QDoubleSpinBox::valueChanged, this, [this](double size) {
    {
      const QScopedValueRollback guard(m_showing, true);
      m_cellSlider->setValue(toSlider(size, kLeastCell, kMostCell));
    }
    if (!m_showing) ask();
  });
  connect(m_ownAxes, &QCheckBox::toggled, this, [this] {
    if (!m_showing) ask();
  });
  connect(m_factor, &QSpinBox::valueChanged, this, [this] {
    if (!m_important.empty()) ask();
  });
  connect(m_material, &QComboBox::activated, this, [this](int index) {
    const std::string id = m_material->itemData(index).toString().toStdString();
    for (const auto* list : {&m_document.joint().materials, static_cast<const std::vector<Material>*>(&m_library)})
      for (const Material& material : *list)
        if (material.id == id) {
          const Material chosen = material;  // the list changes under the edit
          setMaterial(m_document, m_authoring.part(), chosen);
          return;
        }
  });
  connect(m_ownMaterial, &QPushButton::clicked, this, [this] { ownMaterial(m_document, m_authoring.part()); });
  connect(m_markButton, &QPushButton::clicked, this, &BodyPanel::mark);
  connect(m_unmark, &QPushButton::clicked, this, [this] {
    m_important.clear();
    ask();
  });
  return content;
}

QWidget* BodyPanel::makePictures() {
  auto* content = new QWidget;
  auto* whole = new QVBoxLayout(content);
  whole->setContentsMargins(4, 4, 8, 8);
  auto* layout = new QHBoxLayout;
  whole->addLayout(layout, 1);
  for (const char* name : {"bodies.visual", "bodies.collision", "bodies.volume"}) {
    auto* column = new QVBoxLayout;
    auto* picture = new QLabel;
    picture->setObjectName(QLatin1String(name));
    picture->setAlignment(Qt::AlignCenter);
    picture->setMinimumSize(120, 120);
    picture->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    auto* caption = new QLabel;
    caption->setAlignment(Qt::AlignCenter);
    caption->setWordWrap(true);
    column->addWidget(picture, 1);
    column->addWidget(caption);
    layout->addLayout(column, 1);
    m_pictures.push_back(picture);
    m_captions.push_back(caption);
  }
  const auto words = [](const char* name) {
    auto* made = new QLabel;
    made->setObjectName(QLatin1String(name));
    made->setWordWrap(true);
    return made;
  };
  m_figures = words("bodies.figures");
  m_outcome = words("bodies.outcome");
  m_outcome->setProperty("role", QStringLiteral("problem"));
  m_outcome->hide();
  m_apply = new QPushButton;
  m_apply->setObjectName(QStringLiteral("bodies.apply"));
  m_revert = new QPushButton;
  m_revert->setObjectName(QStringLiteral("bodies.revert"));
  auto* last = new QHBoxLayout;
  auto* texts = new QVBoxLayout;
  texts->addWidget(m_figures);
  texts->addWidget(m_outcome);
  last->addLayout(texts, 1);
  last->addWidget(m_apply, 0, Qt::AlignBottom);
  last->addWidget(m_revert, 0, Qt::AlignBottom);
  whole->addLayout(last);
  connect(m_apply, &QPushButton::clicked, this, &BodyPanel::apply);
  connect(m_revert, &QPushButton::clicked, this, [this] {
    m_visual.reset();
    takePart();
  });
  return content;
}

// ---- What is shown

void BodyPanel::refreshPart() {
  const Part* shown = part();
  const bool same = shown && shown->id == m_taken.id && shown->kind == m_taken.kind && shown->visual == m_taken.visual &&
                    shown->collision == m_taken.collision && shown->volume == m_taken.volume && shown->cellSize == m_taken.cellSize;
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
    const auto count = shown->collision ? shown->collision->triangles.size() : std::min<std::size_t>(500, shown->visual->triangles.size());
    m_triangles->setValue(static_cast<int>(count));
    const double size = 1e3 * ::glenoid::boundsOf(*shown->visual).diagonal().norm();
    m_cell->setValue(shown->cellSize > 0 ? 1e3 * shown->cellSize : std::clamp(size / 12, kLeastCell, kMostCell));
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
  for (const Material& material : joint.materials) m_material->addItem(anatomyName(material.name), QString::fromStdString(material.id));
  m_material->insertSeparator(m_material->count());
  for (const Material& material : m_library) {
    if (findMaterial(joint, material.id) >= 0) continue;
    m_material->addItem(tr("%1 (library)").arg(anatomyName(material.name)), QString::fromStdString(material.id));
    m_material->setItemData(m_material->count() - 1, QString::fromStdString(material.source), Qt::ToolTipRole);
  }
  const bool any = shown && !shown->materials.empty();
  m_material->setCurrentIndex(any ? m_material->findData(QString::fromStdString(shown->materials[0].material)) : -1);
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
  if (m_made && m_madeWish && m_madeWish->collisionTriangles == wanted.collisionTriangles && m_madeWish->importance == wanted.importance) {
    wanted.collision = m_made->collision;
  } else if (!m_madeWish && m_made && m_important.empty() && wanted.collisionTriangles == m_made->figures.collisionTriangles) {
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
  for (QWidget* widget : std::initializer_list<QWidget*>{m_cellSlider, m_cell, m_ownAxes}) widget->setEnabled(soft);
  m_apply->setEnabled(m_madeWish && m_made && !m_bodyJob.busy());
  m_revert->setEnabled(m_madeWish || m_error || m_bodyJob.busy());
  m_markButton->setEnabled(m_visual && m_authoring.mesh() == m_visual && m_authoring.surface() == SurfaceKind::Visual &&
                           !m_authoring.selected().empty());
  m_unmark->setEnabled(!m_important.empty());
  m_matter->setText(m_important.empty()
                        ? tr("Paint on the part in the view where the collision surface shall be finer, then mark it here.")
                        : tr("%n triangle(s) matter more than the others.", nullptr, static_cast<int>(m_important.size())));
  m_outcome->setVisible(m_error.has_value());
  if (m_error) m_outcome->setText(sentenceOf(*m_error));
  const Part* shown = part();
  if (!m_made || !shown) return m_figures->clear();
  const BodyFigures& figures = m_made->figures;
  m_captions[0]->setText(tr("%n triangle(s) are seen", nullptr, figures.visualTriangles));
  m_captions[1]->setText(tr("%n triangle(s) collide", nullptr, figures.collisionTriangles));
  m_captions[2]->setText(m_made->volume ? tr("%n tetrahedron(s) deform", nullptr, figures.tetrahedra) : tr("Nothing deforms: the part is rigid"));
  if (m_bodyJob.busy()) return m_figures->setText(tr("Making the meshes…"));
  if (!m_madeWish) return m_figures->setText(tr("This is what the part has. Move a slider to try another body."));
  QStringList lines;
  lines << tr("The collision surface leaves the visual one by %1 mm at most, %2 mm on average; its volume is off by %3 %.")
               .arg(number(1e3 * figures.deviationMax, 2), number(1e3 * figures.deviationMean, 2), number(100 * std::abs(figures.volumeError), 2));
  if (m_made->volume) {
    lines << tr("%1 with %2; tissue fills %3 % of them, the emptiest %4 %.")
                 .arg(tr("%n tetrahedron(s)", nullptr, figures.tetrahedra), tr("%n node(s)", nullptr, figures.nodes),
                      number(100 * figures.meanFill, 0), number(100 * figures.leastFill, 0));
    lines << tr("The part is about %1 mm thick and will add about %2 ms to a step, without contacts.")
                 .arg(number(1e3 * figures.thinnest, 1), number(figures.stepMs, 2));
    if (figures.pieces > 1) lines << tr("The tetrahedra fall into %n piece(s): take smaller cells.", nullptr, figures.pieces);
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
    if (body.volume) images.push_back(imageOf(meshPicture(boundaryOf(*body.volume), viewport, {color, false, true, {}})));
    return [this, images] {
      for (std::size_t i = 0; i < m_pictures.size(); ++i) {
        if (i >= images.size()) {
          m_pictures[i]->setPixmap({});
          continue;
        }
        m_pictures[i]->setPixmap(QPixmap::fromImage(images[i].scaled(images[i].size() / 2, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)));
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
  if (setBody(m_document, m_authoring.part(), wanted, body)) return;
  m_outcome->setText(tr("A region on the collision surface that is in use would be lost; take more triangles there."));
  m_outcome->show();
}

// ---- Texts

void BodyPanel::retranslate() {
  const QStringList groups = {tr("Body"), tr("Where triangles matter")};
  for (std::size_t i = 0; i < m_groups.size(); ++i) m_groups[i]->setTitle(groups.value(static_cast<int>(i)));
  const QStringList labels = {tr("Kind:"), tr("Collision triangles:"), tr("Cell size:"), tr("Material:")};
  for (std::size_t i = 0; i < m_labels.size(); ++i) m_labels[i]->setText(labels.value(static_cast<int>(i)));
  m_kind->setItemText(0, tr("rigid"));
  m_kind->setItemText(1, tr("soft"));
  m_cell->setSuffix(tr(" mm"));
  m_ownAxes->setText(tr("Cells along the part's own axes"));
  m_ownAxes->setToolTip(tr("Spares a flat oblique part the stairs that the world's axes would cut"));
  m_ownMaterial->setText(tr("Own copy"));
  m_ownMaterial->setToolTip(tr("Give this part a material of its own, to be changed without changing others"));
  m_markButton->setText(tr("Mark"));
  m_markButton->setToolTip(tr("The selected triangles of the visual surface matter"));
  m_unmark->setText(tr("None"));
  m_unmark->setToolTip(tr("No triangle matters more than another"));
  m_factor->setPrefix(tr("×"));
  m_apply->setText(tr("Apply"));
  m_apply->setToolTip(tr("Give the part this body; its cage and the proof of the start go"));
  m_revert->setText(tr("Revert"));
  m_revert->setToolTip(tr("Back to what the part has"));
  for (QWidget* widget : std::initializer_list<QWidget*>{m_triangleSlider, m_triangles}) widget->setAccessibleName(tr("Collision triangles"));
  for (QWidget* widget : std::initializer_list<QWidget*>{m_cellSlider, m_cell}) widget->setAccessibleName(tr("Cell size"));
  m_kind->setAccessibleName(tr("Kind of the part"));
  m_material->setAccessibleName(tr("Material of the part"));
  m_factor->setAccessibleName(tr("How much more the marked triangles matter"));
  const QStringList pictures = {tr("Visual surface"), tr("Collision surface"), tr("Tetrahedra")};
  for (std::size_t i = 0; i < m_pictures.size(); ++i) m_pictures[i]->setAccessibleName(pictures.value(static_cast<int>(i)));
  takePart();
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
