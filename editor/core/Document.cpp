// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/Document.h"

#include <QUndoCommand>
#include <algorithm>

#include "editor/core/AnatomyNames.h"
#include "editor/core/FrozenScene.h"

namespace glenoid {

class Document::SwapCommand : public QUndoCommand {
 public:
  using Kept = std::shared_ptr<const FrozenScene>;

  SwapCommand(Document& document, const QString& text, Kept before, Kept after, ChangeSet changes, QString gesture,
              int gestureNumber)
      : QUndoCommand(text), m_document(document), m_before(std::move(before)), m_after(std::move(after)),
        m_changes(std::move(changes)), m_gesture(std::move(gesture)), m_gestureNumber(gestureNumber) {}

  void undo() override { m_document.swap(m_before->thaw(), m_before, m_changes); }
  void redo() override { m_document.swap(m_after->thaw(), m_after, m_changes); }
  int id() const override { return m_gesture.isEmpty() ? -1 : 1; }

  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = static_cast<const SwapCommand*>(other);  // the only command with an id
    if (next->m_gesture != m_gesture || next->m_gestureNumber != m_gestureNumber) return false;
    m_after = next->m_after;
    return true;
  }

 private:
  Document& m_document;
  Kept m_before, m_after;
  ChangeSet m_changes;
  QString m_gesture;
  int m_gestureNumber;
};

Document::Document(QObject* parent) : QObject(parent), m_frozen(FrozenScene::of(m_scene, nullptr)) {}
Document::~Document() = default;

void Document::swap(Scene scene, std::shared_ptr<const FrozenScene> frozen, const ChangeSet& changes) {
  m_scene = std::move(scene);
  m_frozen = std::move(frozen);
  emit changed(changes);
}

void Document::open(Scene scene, const QString& path) {
  m_undo.clear();
  m_undo.setClean();  // of a stack that was empty before, clear() leaves the clean index as it was
  m_path = path;
  ++m_gestureNumber;
  ChangeSet all;
  all.everything = all.model = all.settings = true;
  auto frozen = FrozenScene::of(scene, nullptr);
  swap(std::move(scene), std::move(frozen), all);
}

void Document::openUnsaved(Scene scene, const QString& origin) {
  open(std::move(scene), origin);
  m_undo.resetClean();
}

void Document::saved(const QString& path) {
  m_path = path;
  m_undo.setClean();
  ++m_gestureNumber;
  emit savedTo(path);
}

void Document::edit(const QString& text, const ChangeSet& changes, const Edit& change, const QString& gesture) {
  Scene after = m_scene;
  change(after);
  m_undo.push(new SwapCommand(*this, text, m_frozen, FrozenScene::of(after, m_frozen.get()), changes, gesture, m_gestureNumber));
}

void Document::setYoungsModulus(const std::string& material, double pascal) {
  const int index = findMaterial(joint(), material);
  if (index < 0 || joint().materials[index].youngsModulus == pascal) return;
  ChangeSet changes;
  changes.model = true;
  changes.materials = {material};
  edit(tr("Change the stiffness of “%1”").arg(anatomyName(joint().materials[index].name)), changes,
       [=](Scene& scene) { scene.joint.materials[index].youngsModulus = pascal; },
       QStringLiteral("young:") + QString::fromStdString(material));
}

void Document::setCouplingStiffness(const std::string& coupling, double stiffness) {
  const auto& all = joint().couplings;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Coupling& c) { return c.id == coupling; });
  const auto member = found != all.end() && found->byNodes() ? &Coupling::stiffnessPerNode : &Coupling::stiffnessPerArea;
  if (found == all.end() || (*found).*member == stiffness) return;
  const std::size_t index = found - all.begin();
  ChangeSet changes;
  changes.model = true;
  changes.couplings = {coupling};
  edit(tr("Change the coupling “%1”").arg(QString::fromStdString(coupling)), changes,
       [=](Scene& scene) { scene.joint.couplings[index].*member = stiffness; },
       QStringLiteral("coupling:") + QString::fromStdString(coupling));
}

void Document::setProfile(Profile profile) {
  if (scenario().profile == profile) return;
  ChangeSet changes;
  changes.model = changes.settings = true;
  edit(tr("Change the solver"), changes, [=](Scene& scene) { scene.scenario.profile = profile; });
}

}  // namespace glenoid
