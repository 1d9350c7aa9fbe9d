// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/ExportSentences.h"

#include <QCoreApplication>
#include <QLocale>
#include <numbers>

namespace glenoid {
namespace {

struct ExportSentences {
  Q_DECLARE_TR_FUNCTIONS(glenoid::ExportSentences)
};

}  // namespace

// One case for each kind and no default: the compiler names the one that is missing.
QString sentenceOf(const Loss& loss) {
  const QString count = QLocale().toString(static_cast<qlonglong>(loss.count));
  switch (loss.kind) {
    case LossKind::RigidParts: return ExportSentences::tr("Rigid parts are left out: %1.").arg(count);
    case LossKind::Surfaces: return ExportSentences::tr("Surfaces are left out: %1.").arg(count);
    case LossKind::Volumes: return ExportSentences::tr("Volumes are left out: %1.").arg(count);
    case LossKind::Materials: return ExportSentences::tr("Mechanical values of materials are left out: %1.").arg(count);
    case LossKind::MaterialLaw:
      return ExportSentences::tr("The tissue law becomes neo-Hookean, with the same Young's modulus and Poisson's ratio.");
    case LossKind::FillFractions:
      return ExportSentences::tr("Tetrahedra that are only partly tissue are written as full ones, so they are stiffer and heavier: %1.").arg(count);
    case LossKind::MaterialRegions: return ExportSentences::tr("Parts of several materials get their first one throughout: %1.").arg(count);
    case LossKind::Couplings: return ExportSentences::tr("Couplings are left out: %1.").arg(count);
    case LossKind::CouplingStiffness: return ExportSentences::tr("Couplings become bonds that do not give: %1.").arg(count);
    case LossKind::BondsLeftOut:
      return ExportSentences::tr("Nodes that two couplings hold get only one of the two bonds; bonds left out: %1.").arg(count);
    case LossKind::Contact: return ExportSentences::tr("Contact between the parts is left out.");
    case LossKind::ContactPenalty: return ExportSentences::tr("Contact becomes a penalty force instead of a hard limit.");
    case LossKind::Friction: return ExportSentences::tr("Friction is left out.");
    case LossKind::Damping: return ExportSentences::tr("The damping of all materials becomes their mean.");
    case LossKind::Exclusions: return ExportSentences::tr("Which pairs of parts do not touch is left out: %1.").arg(count);
    case LossKind::Bursae: return ExportSentences::tr("Bursae are left out: %1.").arg(count);
    case LossKind::Regions: return ExportSentences::tr("Regions and landmarks are left out: %1.").arg(count);
    case LossKind::Cages: return ExportSentences::tr("Cages are left out: %1.").arg(count);
    case LossKind::FixedBones:
      return ExportSentences::tr("Rigid parts are written as fixed, since who moves is a matter of the scenario: %1.").arg(count);
    case LossKind::Precision: return ExportSentences::tr("Coordinates are rounded to single precision.");
  }
  return {};
}

QString sentenceOf(const SolidFigures& solid, ExportMesh mesh) {
  const QLocale locale;
  const auto cubic = [&](double volume) { return locale.toString(1e6 * volume, 'g', 3); };
  const QString part = QString::fromStdString(solid.part), count = locale.toString(static_cast<qlonglong>(solid.tetrahedra));
  if (mesh == ExportMesh::Cells)
    return ExportSentences::tr("%1: %2 tetrahedra of its cells hold %3 cm³, %4 times the %5 cm³ of the part.")
        .arg(part, count, cubic(solid.volume), locale.toString(solid.volume / solid.partVolume, 'f', 2), cubic(solid.partVolume));
  return ExportSentences::tr("%1: %2 tetrahedra of the part itself hold %3 cm³ of its %4 cm³; least angle between faces %5°, least radius ratio %6.")
      .arg(part, count, cubic(solid.volume), cubic(solid.partVolume), locale.toString(solid.leastDihedral * 180 / std::numbers::pi, 'f', 1),
           locale.toString(solid.leastRadiusRatio, 'f', 2));
}

QString exportName(ExportFormat format) {
  switch (format) {
    case ExportFormat::Msh: return ExportSentences::tr("Gmsh mesh of the volumes");
    case ExportFormat::Vtu: return ExportSentences::tr("VTK grid of the volumes");
    case ExportFormat::Scn: return ExportSentences::tr("SOFA scene");
    case ExportFormat::Feb: return ExportSentences::tr("FEBio model");
    case ExportFormat::Inp: return ExportSentences::tr("CalculiX input");
    case ExportFormat::Glb: return ExportSentences::tr("glTF surfaces");
  }
  return {};
}

}  // namespace glenoid
