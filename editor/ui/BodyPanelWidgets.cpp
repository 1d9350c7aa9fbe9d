// SPDX-License-Identifier: GPL-3.0-or-later
// What the panel of bodies is made of, and its texts.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

#include "editor/core/AuthorEdits.h"
#include "editor/ui/BodyPanel.h"

namespace glenoid {
namespace {

constexpr int kSliderSteps = 400;

/// Sliders are logarithmic: as far from 50 to 100 triangles as from 5000 to 10 000.
int toSlider(double value, double low, double high) {
  return static_cast<int>(std::lround(kSliderSteps * std::log(value / low) / std::log(high / low)));
}
double fromSlider(int step, double low, double high) {
  return low * std::pow(high / low, static_cast<double>(step) / kSliderSteps);
}

constexpr double kLeastTriangles = 12, kMostTriangles = 20000, kLeastCell = 0.3, kMostCell = 60;  // mm

}  // namespace

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
  for (QWidget* widget : std::initializer_list<QWidget*>{m_kind, m_triangles, m_cell, m_material})
    widget->setFocusPolicy(Qt::StrongFocus);
  for (QAbstractSpinBox* spin : std::initializer_list<QAbstractSpinBox*>{m_triangles, m_cell})
    spin->setKeyboardTracking(false);
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
  for (QWidget* each : std::initializer_list<QWidget*>{m_markButton, m_factor, m_unmark})
    matterRow->addWidget(each);
  matterLayout->addLayout(matterRow);
  layout->addWidget(matter);

  layout->addStretch(1);

  connect(m_kind, &QComboBox::currentIndexChanged, this, [this] {
    if (!m_showing) ask();
  });
  connect(m_triangleSlider, &QSlider::valueChanged, this, [this](int step) {
    if (!m_showing)
      m_triangles->setValue(static_cast<int>(std::lround(fromSlider(step, kLeastTriangles, kMostTriangles))));
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
    for (const auto* list :
         {&m_document.joint().materials, static_cast<const std::vector<Material>*>(&m_library)})
      for (const Material& material : *list)
        if (material.id == id) {
          const Material chosen = material;  // the list changes under the edit
          setMaterial(m_document, m_authoring.part(), chosen);
          return;
        }
  });
  connect(m_ownMaterial, &QPushButton::clicked, this,
          [this] { ownMaterial(m_document, m_authoring.part()); });
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
  m_ownMaterial->setToolTip(
      tr("Give this part a material of its own, to be changed without changing others"));
  m_markButton->setText(tr("Mark"));
  m_markButton->setToolTip(tr("The selected triangles of the visual surface matter"));
  m_unmark->setText(tr("None"));
  m_unmark->setToolTip(tr("No triangle matters more than another"));
  m_factor->setPrefix(tr("×"));
  m_apply->setText(tr("Apply"));
  m_apply->setToolTip(tr("Give the part this body; its cage and the proof of the start go"));
  m_revert->setText(tr("Revert"));
  m_revert->setToolTip(tr("Back to what the part has"));
  for (QWidget* widget : std::initializer_list<QWidget*>{m_triangleSlider, m_triangles})
    widget->setAccessibleName(tr("Collision triangles"));
  for (QWidget* widget : std::initializer_list<QWidget*>{m_cellSlider, m_cell})
    widget->setAccessibleName(tr("Cell size"));
  m_kind->setAccessibleName(tr("Kind of the part"));
  m_material->setAccessibleName(tr("Material of the part"));
  m_factor->setAccessibleName(tr("How much more the marked triangles matter"));
  const QStringList pictures = {tr("Visual surface"), tr("Collision surface"), tr("Tetrahedra")};
  for (std::size_t i = 0; i < m_pictures.size(); ++i)
    m_pictures[i]->setAccessibleName(pictures.value(static_cast<int>(i)));
  takePart();
}

}  // namespace glenoid
