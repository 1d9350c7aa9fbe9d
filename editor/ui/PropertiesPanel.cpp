// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/PropertiesPanel.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPixmap>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QSpinBox>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/core/AnatomyNames.h"
#include "editor/core/EffectSentences.h"
#include "editor/core/JointEdits.h"
#include "editor/core/PartEdits.h"
#include "editor/core/PartMovement.h"
#include "editor/core/Sentences.h"
#include "editor/ui/LoadFields.h"
#include "editor/ui/Numbers.h"
#include "editor/ui/PlaceFields.h"
#include "simcore/live/RestWatch.h"

namespace glenoid {
namespace {

QString text(const std::string& s) { return QString::fromStdString(s); }

QLabel* label(const QString& words, const char* role = nullptr) {
  auto* made = new QLabel(words);
  made->setWordWrap(true);
  made->setTextInteractionFlags(Qt::TextSelectableByMouse);
  if (role) made->setProperty("role", QLatin1String(role));
  return made;
}

QFormLayout* group(QVBoxLayout& layout, const QString& title) {
  auto* box = new QGroupBox(title);
  auto* form = new QFormLayout(box);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setLabelAlignment(Qt::AlignLeft);
  layout.addWidget(box);
  return form;
}

/// Takes a value when the person is done with it, not at each digit.
QDoubleSpinBox* field(double value, double low, double high, int decimals, const QString& suffix) {
  auto* box = new QDoubleSpinBox;
  box->setDecimals(decimals);
  box->setRange(low, high);
  box->setValue(value);
  box->setSuffix(QLatin1Char(' ') + suffix);
  box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  box->setMinimumWidth(110);  // its own wish has room for the largest number it would take
  box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  box->setKeyboardTracking(false);
  box->setFocusPolicy(Qt::StrongFocus);  // the wheel scrolls the panel, not the values it passes over
  return box;
}

}  // namespace

PropertiesPanel::PropertiesPanel(Document& document, Selection& selection, PlayLink& link, QWidget* parent)
    : QScrollArea(parent), m_document(document), m_selection(selection), m_link(link) {
  setObjectName(QStringLiteral("properties"));
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setMinimumWidth(310);
  connect(&document, &Document::changed, this, [this] {
    if (!m_editing) rebuild();
  });
  connect(&selection, &Selection::changed, this, &PropertiesPanel::rebuild);
  // The model's own figures (springs, effects) come with the first snapshot that holds it.
  connect(&link, &PlayLink::snapshotChanged, this, [this, shown = std::weak_ptr<const Model>()]() mutable {
    const auto& model = m_link.snapshot().model;
    if (shown.lock() == model) return;
    shown = model;
    if (!m_editing && !(widget() && widget()->isAncestorOf(focusWidget()))) rebuild();
  });
  rebuild();
}

void PropertiesPanel::rebuild() {
  const int scrolled = verticalScrollBar()->value();
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(8, 8, 8, 8);
  const std::string& id = m_selection.current();
  const int part = findPart(m_document.joint(), id), tool = findTool(m_document.scenario(), id);
  if (!id.empty() && part >= 0) {
    showPart(*layout, m_document.joint().parts[part]);
  } else if (!id.empty() && tool >= 0) {
    showTool(*layout, m_document.scenario().tools[tool]);
  } else {
    showScene(*layout);
  }
  layout->addStretch(1);
  // A field of the old content may be the one that called; it goes when its event is over.
  if (QWidget* old = takeWidget()) old->deleteLater();
  setWidget(content);
  verticalScrollBar()->setValue(scrolled);
}

void PropertiesPanel::showScene(QVBoxLayout& layout) {
  const Joint& joint = m_document.joint();
  const Scenario& scenario = m_document.scenario();
  if (m_document.isEmpty()) {
    layout.addWidget(label(tr("No scene is open. Choose File ▸ Open… to begin, or File ▸ Import surfaces… to make a joint of your own."), "hint"));
    return;
  }
  layout.addWidget(label(scenario.name.empty() ? anatomyName(joint.name) : text(scenario.name), "title"));
  if (!scenario.description.empty()) layout.addWidget(label(text(scenario.description), "hint"));
  std::size_t tets = 0, triangles = 0;
  for (const Part& part : joint.parts) {
    if (part.volume) tets += part.volume->tets.size();
    if (part.visual) triangles += part.visual->triangles.size();
  }
  showJoint(layout);
  QFormLayout* scene = group(layout, tr("Scene"));
  scene->addRow(tr("Parts:"), label(number(joint.parts.size())));
  scene->addRow(tr("Visual triangles:"), label(number(triangles)));
  scene->addRow(tr("Tetrahedra:"), label(number(tets)));
  scene->addRow(tr("Couplings:"), label(number(joint.couplings.size())));
  scene->addRow(tr("Time step:"), label(tr("%1 ms").arg(number(1e3 * scenario.dt, 1))));
  scene->addRow(tr("State:"), restLabel());
  layout.addWidget(new LoadFields(m_document, {}, m_editing));
  const auto& model = m_link.snapshot().model;
  if (!model) return;
  QFormLayout* effects = group(layout, tr("Effects"));
  for (const EffectFacts& effect : effectFacts(*model)) {
    QLabel* state = label(effectSentence(effect));
    state->setObjectName(QStringLiteral("effect-") + text(effect.name));
    effects->addRow(tr("%1:").arg(effectName(effect.name)), state);
  }
}

void PropertiesPanel::showJoint(QVBoxLayout& layout) {
  const Joint& joint = m_document.joint();
  QFormLayout* form = group(layout, tr("Joint"));
  const auto line = [&](const char* name, const QString& what, const QString& about, const std::string& value, bool (*set)(Document&, const QString&)) {
    auto* made = new QLineEdit(text(value));
    made->setObjectName(QLatin1String(name));
    made->setAccessibleName(about);
    made->setToolTip(about);
    made->setCursorPosition(0);
    connect(made, &QLineEdit::editingFinished, this, [this, made, set] { set(m_document, made->text().trimmed()); });
    form->addRow(what, made);
  };
  line("jointName", tr("Name:"), tr("Name of the joint"), joint.name, renameJoint);
  line("jointDescription", tr("Description:"), tr("What the joint is and what it is for"), joint.description, describeJoint);
  line("jointAuthor", tr("Author:"), tr("Who made the joint"), joint.provenance.author, setJointAuthor);
  line("jointLicence", tr("Licence:"), tr("Under which terms the joint may be used, such as CC-BY-4.0"), joint.provenance.license, setJointLicence);
  form->addRow(tr("Side:"), sideBox());
}

QComboBox* PropertiesPanel::sideBox() {
  auto* box = new QComboBox;
  box->setObjectName(QStringLiteral("jointSide"));
  box->setAccessibleName(tr("Side of the body"));
  box->setToolTip(tr("On which side of the body the joint lies: lateral and medial follow it. Edit ▸ Mirror the joint makes the joint of the other side."));
  box->setFocusPolicy(Qt::StrongFocus);
  box->addItem(tr("none said"), static_cast<int>(JointSide::Unsaid));
  box->addItem(tr("left"), static_cast<int>(JointSide::Left));
  box->addItem(tr("right"), static_cast<int>(JointSide::Right));
  box->setCurrentIndex(box->findData(static_cast<int>(m_document.joint().side)));
  connect(box, &QComboBox::activated, this, [this, box] { setJointSide(m_document, static_cast<JointSide>(box->currentData().toInt())); });
  return box;
}

/// Refreshed five times a second, as the figures of the status bar.
QLabel* PropertiesPanel::restLabel() {
  QLabel* state = label({});
  state->setObjectName(QStringLiteral("restState"));
  state->setToolTip(tr("At rest: the loads are whole and no part moves faster than %1 mm/s").arg(number(1e3 * RestWatch::kSlow, 0)));
  const auto refresh = [this, state] {
    const RestState& rest = m_link.snapshot().rest;
    const QString words = !rest.stepped   ? tr("not run yet")
                          : rest.loadsRise ? tr("loads are rising")
                          : rest.slow      ? tr("at rest")
                                           : tr("moving at up to %1 mm/s").arg(number(1e3 * rest.speed, 1));
    if (state->text() != words) state->setText(words);
  };
  auto* timer = new QTimer(state);
  connect(timer, &QTimer::timeout, this, refresh);  // an old content outlives the panel where no event loop ran since
  timer->start(200);
  refresh();
  return state;
}

void PropertiesPanel::showPart(QVBoxLayout& layout, const Part& part) {
  layout.addWidget(label(anatomyName(part.name), "title"));
  QFormLayout* form = group(layout, tr("Part"));
  form->addRow(tr("Name:"), nameField(part));
  form->addRow(tr("Number:"), numberField(part));
  form->addRow(tr("Colour:"), colorButton(part));
  form->addRow(tr("Kind:"), label(part.kind == PartKind::Soft ? tr("soft") : tr("rigid")));
  form->addRow(tr("Movement:"), movementBox(part));
  if (part.visual) form->addRow(tr("Visual triangles:"), label(number(part.visual->triangles.size())));
  if (part.collision) form->addRow(tr("Collision triangles:"), label(number(part.collision->triangles.size())));
  if (part.volume) {
    form->addRow(tr("Elements:"), elementsBox(part));
    if (movementOf(m_document.scenario(), part.id) != Movement::Fixed) form->addRow(tr("Self-contact:"), foldsBox(part));
    form->addRow(tr("Tetrahedra:"), label(number(part.volume->tets.size())));
    form->addRow(tr("Nodes:"), label(number(part.volume->nodes.size())));
    form->addRow(tr("Cell size:"), label(tr("%1 mm").arg(number(1e3 * part.cellSize, 1))));
  }
  if (part.visual && !part.visual->vertices.empty()) {
    const Vec3 size = 1e3 * ::glenoid::boundsOf(*part.visual).sizes();
    form->addRow(tr("Size:"), label(tr("%1 × %2 × %3 mm").arg(number(size.x(), 0), number(size.y(), 0),
                                                              number(size.z(), 0))));
  }
  if (const auto& model = m_link.snapshot().model) {
    for (const SceneObject& object : model->objects) {
      if (object.id == part.id) form->addRow(tr("Mass:"), label(tr("%1 g").arg(number(1e3 * object.mass, 1))));
    }
  }
  if (movementOf(m_document.scenario(), part.id) != Movement::Fixed) layout.addWidget(new LoadFields(m_document, part.id, m_editing));
  layout.addWidget(new PlaceFields(m_document, part.id));
  showMaterials(layout, part);
  showCouplings(layout, part);
}

QLineEdit* PropertiesPanel::nameField(const Part& part) {
  auto* name = new QLineEdit(text(part.name));
  name->setObjectName(QStringLiteral("partName"));
  name->setAccessibleName(tr("Name of the part"));
  connect(name, &QLineEdit::editingFinished, this, [this, name, id = part.id] {
    if (!name->text().trimmed().isEmpty()) renamePart(m_document, id, name->text().trimmed());
  });
  return name;
}

QSpinBox* PropertiesPanel::numberField(const Part& part) {
  auto* box = new QSpinBox;
  box->setObjectName(QStringLiteral("partNumber"));
  box->setAccessibleName(tr("Number of the part"));
  box->setToolTip(tr("As printed in tables; no two parts have the same"));
  box->setRange(1, 1000000);
  box->setValue(part.number);
  box->setFocusPolicy(Qt::StrongFocus);
  connect(box, &QSpinBox::editingFinished, this, [this, box, id = part.id, number = part.number] {
    // One that another part has is put back.
    if (box->value() != number && !setPartNumber(m_document, id, box->value())) box->setValue(number);
  });
  return box;
}

QPushButton* PropertiesPanel::colorButton(const Part& part) {
  const QColor color = QColor::fromRgbF(part.color[0], part.color[1], part.color[2]);
  QPixmap swatch(32, 14);
  swatch.fill(color);
  auto* button = new QPushButton(QIcon(swatch), tr("Choose…"));
  button->setIconSize(swatch.size());
  button->setObjectName(QStringLiteral("partColor"));
  button->setAccessibleName(tr("Colour of the part"));
  connect(button, &QPushButton::clicked, this, [this, color, id = part.id] {
    const QColor chosen = QColorDialog::getColor(color, this, tr("Colour of the part"));
    if (chosen.isValid())
      setPartColor(m_document, id, {static_cast<float>(chosen.redF()), static_cast<float>(chosen.greenF()), static_cast<float>(chosen.blueF())});
  });
  return button;
}

QComboBox* PropertiesPanel::movementBox(const Part& part) {
  auto* box = new QComboBox;
  box->setObjectName(QStringLiteral("movement"));
  box->setAccessibleName(tr("Movement of the part"));
  box->setToolTip(tr("Whether the part stays where it is, is pulled back by a spring, or moves freely"));
  box->setFocusPolicy(Qt::StrongFocus);  // the wheel scrolls the panel
  box->addItem(tr("fixed in the room"), static_cast<int>(Movement::Fixed));
  if (part.kind == PartKind::Rigid) box->addItem(tr("held by a spring"), static_cast<int>(Movement::Held));
  box->addItem(tr("free"), static_cast<int>(Movement::Free));
  box->setCurrentIndex(box->findData(static_cast<int>(movementOf(m_document.scenario(), part.id))));
  connect(box, &QComboBox::activated, this, [this, box, id = part.id] {
    setMovement(m_document, id, static_cast<Movement>(box->currentData().toInt()));
  });
  return box;
}

QComboBox* PropertiesPanel::elementsBox(const Part& part) {
  auto* box = new QComboBox;
  box->setObjectName(QStringLiteral("elements"));
  box->setAccessibleName(tr("Elements of the part"));
  box->setToolTip(tr("Five tetrahedra in each cell, or whole cells, which bend where the tissue is thinner than a cell"));
  box->setFocusPolicy(Qt::StrongFocus);
  box->addItem(tr("tetrahedra"), static_cast<int>(Elements::Tetrahedra));
  box->addItem(tr("cells"), static_cast<int>(Elements::Cells));
  box->setCurrentIndex(box->findData(static_cast<int>(part.elements)));
  connect(box, &QComboBox::activated, this, [this, box, id = part.id] {
    setPartElements(m_document, id, static_cast<Elements>(box->currentData().toInt()));
  });
  return box;
}

QCheckBox* PropertiesPanel::foldsBox(const Part& part) {
  auto* box = new QCheckBox(tr("touches itself"));
  box->setObjectName(QStringLiteral("foldsOntoItself"));
  box->setAccessibleName(tr("Self-contact of the part"));
  box->setToolTip(tr("Whether the part may fold onto itself without passing through; it costs time in every step"));
  box->setChecked(foldsOntoItself(m_document.scenario(), part.id));
  connect(box, &QCheckBox::clicked, this, [this, id = part.id](bool folds) { setFoldsOntoItself(m_document, id, folds); });
  return box;
}

void PropertiesPanel::showMaterials(QVBoxLayout& layout, const Part& part) {
  for (const MaterialUse& use : part.materials) {
    const int index = findMaterial(m_document.joint(), use.material);
    if (index < 0) continue;
    const Material& material = m_document.joint().materials[index];
    QFormLayout* form = group(layout, tr("Material: %1").arg(anatomyName(material.name)));
    if (!use.region.empty()) {
      const Region* region = findRegion(part, use.region);
      form->addRow(tr("Where:"), label(text(region && !region->name.empty() ? region->name : use.region)));
    }
    form->addRow(tr("Density:"), label(tr("%1 kg/m³").arg(number(material.density, 0))));
    if (part.kind == PartKind::Soft) {
      QDoubleSpinBox* young = field(material.youngsModulus / 1e3, 0.001, 1e8, 3, tr("kPa"));
      young->setObjectName(QStringLiteral("young.") + text(material.id));
      young->setAccessibleName(tr("Young's modulus of %1").arg(anatomyName(material.name)));
      young->setToolTip(tr("How hard it is to stretch. Every part made of this material changes with it."));
      connect(young, &QDoubleSpinBox::valueChanged, this, [this, id = material.id](double kPa) {
        const QScopedValueRollback guard(m_editing, true);
        m_document.setYoungsModulus(id, 1e3 * kPa);
      });
      connect(young, &QDoubleSpinBox::editingFinished, this, [this] { m_document.endGesture(); });
      form->addRow(tr("Young's modulus:"), young);
      form->addRow(tr("Poisson's ratio:"), label(number(material.poissonRatio, 3)));
    }
    form->addRow(tr("Friction:"), label(number(material.friction, 2)));
    if (material.literatureYoungsModulus && part.kind == PartKind::Soft) {
      form->addRow(tr("Literature:"), label(tr("%1 kPa").arg(number(*material.literatureYoungsModulus / 1e3, 1))));
      if (!material.reason.empty()) form->addRow(label(text(material.reason), "hint"));
    }
    if (!material.source.empty()) form->addRow(label(tr("Source: %1").arg(text(material.source)), "hint"));
  }
}

void PropertiesPanel::showCouplings(QVBoxLayout& layout, const Part& part) {
  const Joint& joint = m_document.joint();
  const auto& model = m_link.snapshot().model;
  for (std::size_t i = 0; i < joint.couplings.size(); ++i) {
    const Coupling& coupling = joint.couplings[i];
    if (coupling.partA != part.id && coupling.partB != part.id) continue;
    const std::string& otherId = coupling.partA == part.id ? coupling.partB : coupling.partA;
    const int other = findPart(joint, otherId);
    QFormLayout* form = group(layout, tr("Coupled to %1").arg(anatomyName(other < 0 ? otherId : joint.parts[other].name)));
    const int owner = findPart(joint, coupling.partA);
    const Region* region = owner < 0 ? nullptr : findRegion(joint.parts[owner], coupling.regionA);
    form->addRow(tr("Over:"), label(coupling.byNodes() ? tr("%n picked node(s)", nullptr, static_cast<int>(coupling.nodesA.size()))
                                                       : text(region && !region->name.empty() ? region->name : coupling.regionA)));
    if (region) {
      form->addRow(tr("Area:"), label(tr("%1 mm²").arg(number(1e6 * areaOf(joint.parts[owner], *region), 0))));
    }
    // N/m per m² is Pa/m; N/mm per mm² is 1e9 of that, so N/mm per cm² reads best for tissue (1e7).
    const double unit = coupling.byNodes() ? 1e3 : 1e7;
    QDoubleSpinBox* stiffness = field((coupling.byNodes() ? coupling.stiffnessPerNode : coupling.stiffnessPerArea) / unit, 1e-4, 1e6, 4,
                                      coupling.byNodes() ? tr("N/mm per node") : tr("N/mm per cm²"));
    stiffness->setObjectName(QStringLiteral("coupling.") + text(coupling.id));
    stiffness->setAccessibleName(tr("Stiffness of the coupling"));
    connect(stiffness, &QDoubleSpinBox::valueChanged, this, [this, id = coupling.id, unit](double value) {
      const QScopedValueRollback guard(m_editing, true);
      m_document.setCouplingStiffness(id, unit * value);
    });
    connect(stiffness, &QDoubleSpinBox::editingFinished, this, [this] { m_document.endGesture(); });
    form->addRow(tr("Stiffness:"), stiffness);
    if (model) {
      const auto count = std::count_if(model->springs.begin(), model->springs.end(), [i](const SpringView& spring) {
        return spring.coupling == static_cast<int>(i);
      });
      form->addRow(tr("Springs:"), label(number(static_cast<long>(count))));
    }
  }
}

void PropertiesPanel::showTool(QVBoxLayout& layout, const Tool& tool) {
  layout.addWidget(label(text(tool.name), "title"));
  QFormLayout* form = group(layout, tr("Tool"));
  form->addRow(tr("Length:"), label(tr("%1 mm").arg(number(1e3 * tool.length, 0))));
  form->addRow(tr("Diameter:"), label(tr("%1 mm").arg(number(2e3 * tool.radius, 1))));
  form->addRow(tr("Mass:"), label(tr("%1 g").arg(number(1e3 * tool.mass, 0))));
  form->addRow(tr("Hand stiffness:"), label(tr("%1 N/mm").arg(number(1e-3 * tool.stiffness, 2))));
  form->addRow(tr("Largest pull:"), label(tr("%1 N").arg(number(tool.forceMax, 1))));
  form->addRow(tr("Friction:"), label(number(tool.friction, 2)));
}

void PropertiesPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) rebuild();
  QScrollArea::changeEvent(event);
}

}  // namespace glenoid
