// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/ProblemSentences.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <cmath>

#include "editor/core/AnatomyNames.h"
#include "editor/core/PartName.h"
#include "editor/core/NoticeSentences.h"
#include "editor/core/Sentences.h"
#include "simcore/check/FixProblem.h"

namespace glenoid {
namespace {

struct ProblemSentences {
  Q_DECLARE_TR_FUNCTIONS(glenoid::ProblemSentences)
 public:
  explicit ProblemSentences(const Problem& problem, const Joint& joint) : p(problem), m_joint(joint) {}
  QString what() const;
  QString fix() const;

 private:
  QString name(const std::string& id) const { return partName(m_joint, id); }
  QString materialName(const std::string& id) const {
    const int index = findMaterial(m_joint, id);
    return index < 0 || m_joint.materials[index].name.empty() ? QString::fromStdString(id)
                                                              : anatomyName(m_joint.materials[index].name);
  }
  QString names() const {
    QStringList list;
    for (const std::string& id : p.parts) list << QStringLiteral("“%1”").arg(name(id));
    return list.join(tr(", "));
  }
  /// Millimetres with three figures that count.
  static QString millimetres(double metres) { return QLocale().toString(metres * 1e3, 'g', 3); }
  /// Stiffness per area of the coupling, N/m per m².
  double perArea() const {
    for (const Coupling& each : m_joint.couplings)
      if (each.id == p.coupling) return each.stiffnessPerArea;
    return 0;
  }
  static QString percent(double share) { return QLocale().toString(100 * share, 'f', 0); }
  static QString number(double value) { return QLocale().toString(value, 'g', 4); }
  QString surface() const {
    return p.surface == SurfaceKind::Collision ? tr("collision surface") : tr("visual surface");
  }
  static QString filled(QString text, std::initializer_list<QString> arguments) {
    // Not arg(): a name may hold “%1”.
    QString out;
    for (int i = 0; i < text.size(); ++i) {
      const int digit = text[i] == u'%' && i + 1 < text.size() ? text[i + 1].digitValue() : -1;
      if (digit < 1 || digit > static_cast<int>(arguments.size())) {
        out += text[i];
        continue;
      }
      out += *(arguments.begin() + digit - 1);
      ++i;
    }
    return out;
  }

  const Problem& p;
  const Joint& m_joint;
};

// One case for each kind and no default: the compiler names the one that is missing.
QString ProblemSentences::what() const {
  const QString part = name(p.part), other = name(p.other), count = QLocale().toString(static_cast<qlonglong>(p.count));
  const QString coupling = QString::fromStdString(p.coupling);
  const QString element = QString::number(p.element.value_or(0));
  switch (p.kind) {
    case ProblemKind::UnitOfJoint:
      return filled(tr("The largest part is %1 m long, which no human joint is: its meshes are probably in another unit. "
                       "Multiplied by %2 they would be metres."), {number(p.figure), number(p.wanted)});
    case ProblemKind::UnitOfPart:
      return filled(tr("“%1” is %2 m long, unlike the other parts: it is probably in another unit. Multiplied by %3 it would "
                       "be in metres."), {part, number(p.figure), number(p.wanted)});
    case ProblemKind::NoSurface:
      return filled(tr("“%1” has no usable %2. Bring its mesh in again."), {part, surface()});
    case ProblemKind::SurfaceOpen:
      return filled(tr("The %2 of “%1” is not closed (open edges: %3). Close its holes, so that inside and outside can be told "
                       "apart."), {part, surface(), count});
    case ProblemKind::SurfaceTangled:
      return filled(tr("The %2 of “%1” is no clean surface (edges, vertices or triangles at fault: %3). Repair the mesh and "
                       "bring it in again."), {part, surface(), count});
    case ProblemKind::SurfaceInwards:
      return filled(tr("The %2 of “%1” is wound inwards, so that its outside is inside. Turn its triangles around."),
                    {part, surface()});
    case ProblemKind::SurfaceCutsItself:
      return p.surface == SurfaceKind::Collision
                 ? filled(tr("The %2 of “%1” cuts itself (pairs of triangles: %3, the first at triangle %4), which makes "
                             "contacts push the wrong way. Simplify it again or repair it."), {part, surface(), count, element})
                 : filled(tr("The %2 of “%1” cuts itself (pairs of triangles: %3, the first at triangle %4). It is drawn wrong "
                             "there; nothing else comes of it."), {part, surface(), count, element});
    case ProblemKind::NoVolume:
      return filled(tr("“%1” is soft and has no usable tetrahedra. Embed it in cells."), {part});
    case ProblemKind::FlatTetrahedra:
      return filled(tr("“%1” has tetrahedra without volume (%2, the worst is number %3). Embed it again with another cell size."),
                    {part, count, element});
    case ProblemKind::InvertedTetrahedra:
      return filled(tr("“%1” has tetrahedra that are inside out (%2, the worst is number %3). Turn their corners around."),
                    {part, count, element});
    case ProblemKind::NoMaterial:
      return p.material.empty()
                 ? filled(tr("“%1” has no material. Choose one."), {part})
                 : filled(tr("“%1” has the material “%2”, which does not exist. Choose another."),
                          {part, QString::fromStdString(p.material)});
    case ProblemKind::CouplingBroken:
      if (p.count > 0)
        return filled(tr("The coupling “%1” names a part or nodes of cells that are not there (nodes: %2). Pick its nodes again, or remove it."),
                      {coupling, count});
      return filled(tr("The coupling “%1” names a part or a region that is not there (region “%2”). Paint its region again, or "
                       "remove it."), {coupling, QString::fromStdString(p.region)});
    case ProblemKind::RegionCannotHold:
      return filled(tr("The coupling “%1” between “%2” and “%3” cannot hold: its region is a line or empty (%4 mm wide), and "
                       "the parts would turn about it freely. Enlarge its region."), {coupling, part, other, millimetres(p.figure)});
    case ProblemKind::NodesCannotHold:
      return filled(tr("The coupling “%1” between “%2” and “%3” cannot hold. %4"),
                    {coupling, part, other, p.error ? glenoid::sentenceOf(Error{p.error->fault, {}, p.error->arguments, {}}) : QString()});
    case ProblemKind::RegionTooSmall:
      return filled(tr("The region of the coupling “%1” between “%2” and “%3” is too small for its stiffness: %4 N/mm on %5 mm² is "
                       "%6 N/mm per cm², more than a layer of 0.1 mm of the softer tissue. A layer of 1 mm has %7 N/mm per cm²: "
                       "enlarge the region to some %8 mm², or lower the stiffness."),
                    {coupling, part, other, number(1e-3 * perArea() * p.figure), number(1e6 * p.figure), number(1e-7 * perArea()),
                     number(1e-7 * p.wanted), number(p.wanted > 0 ? 1e6 * perArea() * p.figure / p.wanted : 0)});
    case ProblemKind::BondedCollision:
      return filled(tr("“%1” and “%2” are bonded over a large surface (%3 mm²) and still tested for contact. Switching that off "
                       "saves time and spares contacts that pull against the bond."),
                    {part, other, QLocale().toString(1e6 * p.figure, 'f', 0)});
    case ProblemKind::PartLoose:
      return std::isfinite(p.figure)
                 ? filled(tr("Nothing holds “%1”: it has no coupling and will fall. The nearest part is %2 mm away."),
                          {part, millimetres(p.figure)})
                 : filled(tr("Nothing holds “%1”: it has no coupling and will fall."), {part});
    case ProblemKind::IslandLoose:
      return filled(tr("These parts are coupled to each other and to nothing that stays: %1. They will fall together. Couple one "
                       "of them to a bone, or hold it."), {names()});
    case ProblemKind::WeightOverstretches:
      return filled(tr("“%1” hangs, and the weight below its weakest part will stretch that to %2 times its length, if nothing lies "
                       "under it. Couple its other end too, or give that part a stiffer material (%3 kPa or more)."),
                    {part, QLocale().toString(p.figure, 'g', 3), QLocale().toString(1e-3 * p.wanted, 'g', 2)});
    case ProblemKind::StepTooLong:
      return filled(tr("The spring that holds “%1” would swing %2 times a second, and steps this long damp it out at once. Steps of %3 ms or "
                       "less show it swing; otherwise soften the spring or give it the damping that is meant."),
                    {part, number(p.figure), QLocale().toString(1e3 * p.wanted, 'g', 2)});
    case ProblemKind::CageUnusable:
      return filled(tr("The cage around “%1” cannot be used. %2"), {part, p.error ? glenoid::sentenceOf(*p.error) : QString()});
    case ProblemKind::CageCrushes:
      return p.figure > 0
                 ? filled(tr("The cage squeezes “%1” too much: %2 tetrahedra keep less than a tenth of their volume, the worst "
                             "(number %3) keeps %4 %. Moving the handles back to %5 % of their way is enough."),
                          {part, count, element, QLocale().toString(100 * p.figure, 'g', 2), percent(p.wanted)})
                 : filled(tr("The cage turns tetrahedra of “%1” inside out (too little volume: %2, the worst is number %3). Moving "
                             "the handles back to %4 % of their way is enough."), {part, count, element, percent(p.wanted)});
    case ProblemKind::CageMovesFar:
      return filled(tr("The cage moves “%1” by up to %2 mm, farther than the part is thick (%3 mm): it may start on the wrong side of "
                       "a neighbour. Look at its start, and move the cage by hand or bring better surfaces in."),
                    {part, millimetres(p.figure), millimetres(p.wanted)});
    case ProblemKind::CageSqueezes:
      return filled(tr("The cage squeezes “%1”: %2 tetrahedra keep less than %3 % of their volume, the worst (number %4) keeps %5 %. "
                       "They will push back when the run begins. Use a smaller clearance or a cage with more handles."),
                    {part, count, percent(p.wanted), element, percent(p.figure)});
    case ProblemKind::Overlap: {
      const std::initializer_list<QString> facts{part, other, count, millimetres(p.figure), p.rigid ? QLocale().toString(p.rigid->triangles) : QString(),
                                                 p.rigid ? millimetres(p.rigid->clearance) : QString()};
      if (!p.rigid)
        return filled(tr("“%1” and “%2” cut each other at the start (pairs of triangles: %3, deepest %4 mm). Separate them with "
                         "cages, or switch off their contact."), facts);
      if (p.rigid->surfacesOverlap)
        return filled(tr("“%1” and “%2” are rigid and cut each other at the start (pairs of triangles: %3, deepest %4 mm), as their "
                         "visual surfaces do. Move one of them, or switch off their contact."), facts);
      if (p.rigid->triangles > 0 && p.rigid->clearance > 0)
        return filled(tr("“%1” and “%2” are rigid, and their collision surfaces cut each other at the start (pairs of triangles: %3, deepest "
                         "%4 mm) where the visual ones do not. With %5 triangles each they do not cut, nor as they are with a clearance of %6 mm "
                         "in the recipe."), facts);
      if (p.rigid->triangles > 0)
        return filled(tr("“%1” and “%2” are rigid, and their collision surfaces cut each other at the start (pairs of triangles: %3, deepest "
                         "%4 mm) where the visual ones do not. With %5 triangles each they do not cut."), facts);
      if (p.rigid->clearance > 0)
        return filled(tr("“%1” and “%2” are rigid, and their collision surfaces cut each other at the start (pairs of triangles: %3, deepest "
                         "%4 mm) where the visual ones do not. With a clearance of %6 mm in the recipe they do not cut."), facts);
      return filled(tr("“%1” and “%2” are rigid and cut each other at the start (pairs of triangles: %3, deepest %4 mm); neither more triangles "
                       "nor a clearance keeps them apart. Move one of them, or switch off their contact."), facts);
    }
    case ProblemKind::Swallowed:
      return filled(tr("“%1” starts wholly inside “%2” (deepest %3 mm). Move it out, or switch off their contact."),
                    {part, other, millimetres(p.figure)});
    case ProblemKind::ProofMissing:
      return tr("No two parts cut each other at the start, but the joint does not record it. Recording it lets others trust it.");
    case ProblemKind::ProofStale:
      return tr("The recorded proof of the start belongs to other meshes, cages or contacts. Check the start again.");
    case ProblemKind::SettingUnused: return p.unused ? glenoid::sentenceOf(*p.unused) : tr("A setting of the scenario changes nothing.");
    case ProblemKind::Unsound:
      return p.error ? glenoid::sentenceOf(*p.error) : tr("The joint cannot be saved as it is.");
  }
  return {};
}

QString ProblemSentences::fix() const {
  const QString part = name(p.part), other = name(p.other);
  switch (p.kind) {
    case ProblemKind::UnitOfJoint: return filled(tr("Multiply all lengths by %1"), {number(p.wanted)});
    case ProblemKind::UnitOfPart: return filled(tr("Multiply the lengths of “%1” by %2"), {part, number(p.wanted)});
    case ProblemKind::SurfaceOpen:
    case ProblemKind::SurfaceTangled:
    case ProblemKind::SurfaceCutsItself: return filled(tr("Repair the %2 of “%1”"), {part, surface()});
    case ProblemKind::SurfaceInwards: return filled(tr("Turn the %2 of “%1” around"), {part, surface()});
    case ProblemKind::InvertedTetrahedra: return filled(tr("Turn the tetrahedra of “%1” around"), {part});
    case ProblemKind::NoMaterial: return filled(tr("Give “%1” the material “%2”"), {part, materialName(p.other)});
    case ProblemKind::CouplingBroken: return filled(tr("Remove the coupling “%1”"), {QString::fromStdString(p.coupling)});
    case ProblemKind::RegionCannotHold: return filled(tr("Enlarge the region of the coupling “%1”"), {QString::fromStdString(p.coupling)});
    case ProblemKind::NodesCannotHold: return filled(tr("Add the nodes around those of the coupling “%1”"), {QString::fromStdString(p.coupling)});
    case ProblemKind::RegionTooSmall:
      return filled(tr("Lower the stiffness of the coupling “%1” to %2 N/mm per cm²"), {QString::fromStdString(p.coupling), number(1e-7 * p.wanted)});
    case ProblemKind::BondedCollision: return filled(tr("Switch off contact between “%1” and “%2”"), {part, other});
    case ProblemKind::CageUnusable: return filled(tr("Remove the cage around “%1”"), {part});
    case ProblemKind::CageCrushes: return filled(tr("Move the handles around “%1” back"), {part});
    case ProblemKind::Overlap:
    case ProblemKind::Swallowed:
      return p.rigid ? filled(tr("Simplify “%1” and “%2” again, to %3 triangles each"), {part, other, QLocale().toString(p.rigid->triangles)})
                     : filled(tr("Separate “%1” and “%2” with cages"), {part, other});
    case ProblemKind::ProofMissing: return tr("Record that the start is free of overlap");
    case ProblemKind::ProofStale: return tr("Check the start again");
    case ProblemKind::NoSurface:
    case ProblemKind::NoVolume:
    case ProblemKind::FlatTetrahedra:
    case ProblemKind::PartLoose:
    case ProblemKind::IslandLoose:
    case ProblemKind::WeightOverstretches:
    case ProblemKind::StepTooLong:
    case ProblemKind::CageMovesFar:
    case ProblemKind::CageSqueezes:
    case ProblemKind::SettingUnused:
    case ProblemKind::Unsound: break;
  }
  return {};
}

}  // namespace

QString sentenceOf(const Problem& problem, const Joint& joint) { return ProblemSentences(problem, joint).what(); }

QString fixTitleOf(const Problem& problem, const Joint& joint) {
  return canFix(problem) ? ProblemSentences(problem, joint).fix() : QString();
}

QString severityName(Severity severity) {
  switch (severity) {
    case Severity::Error: return ProblemSentences::tr("Error");
    case Severity::Warning: return ProblemSentences::tr("Warning");
    case Severity::Note: return ProblemSentences::tr("Note");
  }
  return {};
}

}  // namespace glenoid
