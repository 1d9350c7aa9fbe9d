// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/ImportWords.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

#include "simcore/import/LengthUnit.h"

namespace glenoid {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(glenoid::ImportWords)
 public:
  static QString finding(const Finding& finding, const QString& length);
  static QString repair(const Finding& finding, const QString& length);
  static QString note(ImportNote note, int n);
  static QString reason(const UnitGuess& guess, bool named);
  static QString unit(double metres);
  static QString side(BodySide side);
  static QString state(const ImportSession::Row& row);
};

QString millimetres(double value, double metres) { return QLocale().toString(1e3 * metres * value, 'g', 3); }

// One case for each kind and no default: the compiler names the one that is missing.
QString Words::finding(const Finding& f, const QString& length) {
  const int n = static_cast<int>(f.count);
  switch (f.kind) {
    case FindingKind::Unit: return f.severity == FindingSeverity::Note ? tr("The file does not say its unit.") : tr("The unit is not clear: look at the size.");
    case FindingKind::TwoSides: return tr("Both sides of a body are in one surface.");
    case FindingKind::Pieces: return tr("It consists of %n piece(s).", nullptr, n);
    case FindingKind::UnusedVertices: return tr("%n point(s) belong to no triangle.", nullptr, n);
    case FindingKind::DuplicateVertices: return tr("%n point(s) lie on others.", nullptr, n);
    case FindingKind::DegenerateFaces: return tr("%n triangle(s) have no area.", nullptr, n);
    case FindingKind::DuplicateFaces: return tr("%n triangle(s) are there twice.", nullptr, n);
    case FindingKind::NonManifoldEdges: return tr("%n edge(s) have three or more triangles.", nullptr, n);
    case FindingKind::NonManifoldVertices: return tr("%n point(s) pinch the surface.", nullptr, n);
    case FindingKind::MisorientedEdges: return tr("At %n edge(s) the triangles face contrary ways.", nullptr, n);
    case FindingKind::InsideOut: return tr("%n piece(s) are inside out.", nullptr, n);
    case FindingKind::Holes: return tr("%n hole(s); the longest is %1 mm around.", nullptr, n).arg(length);
    case FindingKind::Sheets: return tr("%n piece(s) have no thickness.", nullptr, n);
    case FindingKind::Handles: return tr("The surface has %n handle(s), as a ring has one.", nullptr, n);
    case FindingKind::SelfIntersections: return tr("%n pair(s) of triangles cut each other.", nullptr, n);
    case FindingKind::Thin:
      return f.severity == FindingSeverity::Note ? tr("Walls are thin in places; %1 mm is their middle.").arg(length)
                                                 : tr("Walls are thin: %1 mm in the middle.").arg(length);
    case FindingKind::CannotBeRead: return tr("The surface holds indices or numbers that make no sense.");
  }
  return {};
}

QString Words::repair(const Finding& f, const QString& length) {
  if (f.repairs.empty()) return {};
  switch (f.kind) {
    case FindingKind::TwoSides: return tr("Keep the side with the lower coordinates");
    case FindingKind::Pieces: return f.repairs[0].kind == RepairKind::DropSmall ? tr("Drop the small pieces") : tr("Keep the largest piece alone");
    case FindingKind::UnusedVertices: return tr("Drop them");
    case FindingKind::DuplicateVertices: return tr("Join them");
    case FindingKind::DegenerateFaces: return tr("Remove them without opening cracks");
    case FindingKind::DuplicateFaces: return tr("Keep one of each");
    case FindingKind::NonManifoldEdges: return tr("Cut the surface apart there, drop the scraps and close what is left open");
    case FindingKind::NonManifoldVertices: return tr("Cut the surface apart there");
    case FindingKind::MisorientedEdges: return tr("Turn triangles so that neighbours face alike");
    case FindingKind::InsideOut: return tr("Turn them outwards");
    case FindingKind::Holes: return tr("Close them");
    case FindingKind::Sheets:
    case FindingKind::Thin: return tr("Thicken to %1 mm").arg(length);
    case FindingKind::SelfIntersections:
      return f.repairs[0].kind == RepairKind::Wrap ? tr("Draw a new closed surface around it") : tr("Cut those triangles out and close the holes");
    case FindingKind::Unit:
    case FindingKind::Handles:
    case FindingKind::CannotBeRead: break;
  }
  return {};
}

QString Words::note(ImportNote note, int n) {
  switch (note) {
    case ImportNote::PolygonsSplit: return tr("%n polygon(s) were cut into triangles.", nullptr, n);
    case ImportNote::StripsSplit: return tr("%n triangle strip(s) were cut into triangles.", nullptr, n);
    case ImportNote::PointsJoined: return tr("%n repeated point(s) were joined.", nullptr, n);
    case ImportNote::NodesMoved: return tr("%n node(s) had a transform, which was applied.", nullptr, n);
    case ImportNote::NodesMirrored: return tr("%n node(s) were mirrored; their triangles were turned back.", nullptr, n);
    case ImportNote::LinesDropped: return tr("%n line(s) were left out.", nullptr, n);
    case ImportNote::PointsDropped: return tr("%n single point(s) were left out.", nullptr, n);
    case ImportNote::NormalsDropped: return tr("Normals of %n surface(s) were left out.", nullptr, n);
    case ImportNote::TexturesDropped: return tr("Texture coordinates of %n surface(s) were left out.", nullptr, n);
    case ImportNote::ColoursDropped: return tr("Colours of %n surface(s) were left out.", nullptr, n);
    case ImportNote::MaterialsDropped: return tr("%n material(s) were left out.", nullptr, n);
    case ImportNote::AnimationsDropped: return tr("%n animation(s) or bone(s) were left out.", nullptr, n);
    case ImportNote::OthersDropped: return tr("%n light(s) or camera(s) were left out.", nullptr, n);
    case ImportNote::DataDropped: return tr("%n array(s) of values were left out.", nullptr, n);
    case ImportNote::SurfacesWithoutTriangles: return tr("%n surface(s) without triangles were left out.", nullptr, n);
    case ImportNote::SolidsSkinned: return tr("Of %n solid cell(s) the outside was taken.", nullptr, n);
  }
  return {};
}

QString Words::reason(const UnitGuess& guess, bool named) {
  if (named) return tr("The file says so.");
  const QString percent = QLocale().toString(std::lround(100 * guess.confidence));
  const QString word = QString::fromLatin1(guess.reason);
  if (word == u"name") return tr("Guessed from the size of such a part (%1 %).").arg(percent);
  if (word == u"place") return tr("Guessed from the place in a body (%1 %).").arg(percent);
  if (word == u"size") return tr("Guessed from the size (%1 %).").arg(percent);
  return tr("No unit fits well: choose one.");
}

QString Words::unit(double metres) {
  const std::string_view word = unitWord(metres);
  if (word == "mm") return tr("millimetres");
  if (word == "cm") return tr("centimetres");
  if (word == "m") return tr("metres");
  if (word == "inch") return tr("inches");
  if (word == "ft") return tr("feet");
  if (word == "um") return tr("micrometres");
  return tr("units of %1 m").arg(QLocale().toString(metres, 'g', 4));
}

QString Words::side(BodySide side) {
  switch (side) {
    case BodySide::Left: return tr("left");
    case BodySide::Right: return tr("right");
    case BodySide::Both: return tr("both");
    case BodySide::Unknown: return tr("unknown");
  }
  return {};
}

QString Words::state(const ImportSession::Row& row) {
  switch (row.state) {
    case ImportSession::State::Reading: return tr("Being read…");
    case ImportSession::State::Working: return tr("Being worked on…");
    case ImportSession::State::Failed: return tr("Failed");
    case ImportSession::State::Ready: break;
  }
  if (!row.after.healthy()) return tr("Not closed or not sound yet");
  return row.after.selfIntersections > 0 ? tr("Sound, but cuts itself") : tr("Sound");
}

}  // namespace

QString findingSentence(const Finding& finding, double metres) { return Words::finding(finding, millimetres(finding.measure, metres)); }
QString repairSentence(const Finding& finding, double metres) {
  return Words::repair(finding, finding.repairs.empty() ? QString() : millimetres(finding.repairs.back().amount, metres));
}
QString noteSentence(const NoteCount& note) { return Words::note(note.note, static_cast<int>(note.count)); }
QString unitReason(const UnitGuess& guess, bool named) { return Words::reason(guess, named); }
QString unitName(double metres) { return Words::unit(metres); }
QString sideSentence(BodySide side) { return Words::side(side); }
QString stateSentence(const ImportSession::Row& row) { return Words::state(row); }

QString sizeSentence(const Box3& box_W) {
  if (box_W.isEmpty()) return {};
  const Vec3 mm = 1e3 * box_W.sizes();
  const QLocale locale;
  return QStringLiteral("%1 × %2 × %3 mm").arg(locale.toString(mm.x(), 'g', 4), locale.toString(mm.y(), 'g', 4), locale.toString(mm.z(), 'g', 4));
}

}  // namespace glenoid
