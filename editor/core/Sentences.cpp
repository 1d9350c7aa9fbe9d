// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/Sentences.h"

#include <QCoreApplication>
#include <QStringList>

namespace glenoid {
namespace {

struct Sentences {
  Q_DECLARE_TR_FUNCTIONS(glenoid::Sentences)
 public:
  static QString what(const Error& error, const std::vector<QString>& a);
  static QString advice(Fault fault);
  static QString nodes(const std::vector<QString>& a);
  static QString place(const Place& place);
  static QString reason(const QString& word);
  static QString effect(const QString& word);
};

// One case for each fault and no default: the compiler names the one that is missing.
QString Sentences::what(const Error& error, const std::vector<QString>& a) {
  switch (error.fault) {
    case Fault::FileMissing: return tr("There is no such file or folder.");
    case Fault::FileUnreadable: return tr("The file cannot be read.");
    case Fault::FileUnwritable: return tr("The file cannot be written.");
    case Fault::FileEmpty: return tr("The file is empty.");
    case Fault::FileTruncated: return tr("The file ends before its own header says it should.");
    case Fault::FileTooLarge: return tr("The file is too large: %1, where at most %2 is accepted.").arg(a[0], a[1]);
    case Fault::NotJson: return tr("The text is not valid JSON: line %1, column %2.").arg(a[0], a[1]);
    case Fault::TooDeep: return tr("The text is nested more deeply than any sensible file.");
    case Fault::NewerSchema:
      return tr("The file was written by a newer version: it says schema %1, this program knows up to %2.")
          .arg(a[0], a[1]);
    case Fault::SchemaMismatch: return tr("The content does not have the expected form: %1.").arg(a[0]);
    case Fault::NotFinite: return tr("A number is not finite.");
    case Fault::OutOfRange: return tr("The value %1 is outside the range from %2 to %3.").arg(a[0], a[1], a[2]);
    case Fault::UnknownId: return tr("“%1” is referred to as %2, but nothing has that name.").arg(a[0], a[1]);
    case Fault::DuplicateId: return tr("The name “%1” is used twice.").arg(a[0]);
    case Fault::CyclicReference: return tr("“%1” refers back to itself.").arg(a[0]);
    case Fault::BadReference: return tr("A reference leaves its folder or points at the wrong kind of thing.");
    case Fault::BadMesh: return tr("The mesh cannot be used: %1.").arg(a[0]);
    case Fault::BadElement: return tr("A tetrahedron has no positive volume (%1).").arg(a[0]);
    case Fault::MeshNotClosed: return tr("The surface is not closed: open edges: %1.").arg(a[0]);
    case Fault::BadIndex: return tr("Index %1 is outside a list of %2 entries.").arg(a[0], a[1]);
    case Fault::HashMismatch: return tr("The content is not what its name promises; the file was changed or damaged.");
    case Fault::UnknownFormat: return tr("The format of the file is not known.");
    case Fault::TooFewSprings:
      return tr("The region of the coupling cannot hold against turning: %1 mm² with radii of gyration of %2 and %3 mm.").arg(a[0], a[1], a[2]);
    case Fault::BadNodes: return nodes(a);
    case Fault::NothingNear: return tr("Couplings find nothing to hold: %1.").arg(a[0]);
    case Fault::Unusable: return tr("The scene cannot be simulated: %1.").arg(a[0]);
    case Fault::BadUsage: return tr("The command cannot be understood: %1.").arg(a[0]);
    case Fault::NoGraphics: return tr("No OpenGL 3.3 context could be made, so nothing can be drawn in 3D.");
    case Fault::Cancelled: return tr("The work was stopped as you asked; nothing was changed.");
    case Fault::TimedOut: return tr("It took longer than %1 s and was stopped.").arg(a[0]);
    case Fault::OutOfMemory: return tr("It needed more memory than %1 and was stopped.").arg(a[0]);
    case Fault::ReaderStopped: return tr("Reading the file made its reader break down; nothing else was harmed.");
    case Fault::CheckFailed: return tr("A check did not hold: %1.").arg(a[0]);
    case Fault::Internal: return tr("Something went wrong inside the program; this is an error of ours.");
  }
  return {};
}

QString Sentences::advice(Fault fault) {
  switch (fault) {
    case Fault::FileMissing: return tr("Check the path and the spelling.");
    case Fault::FileUnreadable: return tr("Check that it is a file and that you are allowed to read it.");
    case Fault::FileUnwritable: return tr("Check that the folder exists, that you may write there and that the disk has room.");
    case Fault::FileEmpty: return tr("Save or copy it again.");
    case Fault::FileTruncated: return tr("Copy or download it again; the first try stopped half way.");
    case Fault::FileTooLarge: return tr("Simplify the mesh before you bring it in.");
    case Fault::NotJson: return tr("Correct the text at that place.");
    case Fault::TooDeep: return tr("Check that it is the file you meant.");
    case Fault::NewerSchema: return tr("Update Glenoid Studio to open it.");
    case Fault::SchemaMismatch: return tr("Correct that entry; the schemas that ship with the program describe the form.");
    case Fault::NotFinite: return tr("Replace it by an ordinary number.");
    case Fault::OutOfRange: return tr("Choose a value inside the range.");
    case Fault::UnknownId: return tr("Correct the name, or add what is missing.");
    case Fault::DuplicateId: return tr("Give one of the two another name.");
    case Fault::CyclicReference: return tr("Remove one of the references of the circle.");
    case Fault::BadReference: return tr("Refer to something of the right kind inside the folder.");
    case Fault::BadMesh: return tr("Repair the mesh in the program that made it and bring it in again.");
    case Fault::BadElement: return tr("Build the volume again, or choose another cell size.");
    case Fault::MeshNotClosed: return tr("Close the holes, so that inside and outside can be told apart.");
    case Fault::BadIndex: return tr("The file was cut or edited; write it again from its source.");
    case Fault::HashMismatch: return tr("Restore the original file, or save the joint again.");
    case Fault::UnknownFormat: return tr("Use a .joint folder, a .jointz file, a .scenario.json, or a surface as OBJ, STL, PLY, glTF, GLB, 3MF, DAE, FBX, VTP, VTU or VTK.");
    case Fault::TooFewSprings: return tr("Enlarge the region of the coupling.");
    case Fault::BadNodes: return {};  // each word brings its own
    case Fault::NothingNear: return tr("Enlarge “within”, or check unit and place of both parts.");
    case Fault::Unusable: return tr("Change the part or the setting that is named.");
    case Fault::BadUsage: return tr("“glenoid --help” lists what can be said.");
    case Fault::NoGraphics: return tr("Update the graphics driver, or use the command line, which needs no display.");
    case Fault::Cancelled: return tr("Start it again whenever you like.");
    case Fault::TimedOut: return tr("Use a smaller file, or allow more time.");
    case Fault::OutOfMemory: return tr("Use a smaller file, or allow more memory.");
    case Fault::ReaderStopped: return tr("The file is damaged: write it again in the program that made it, or in another format.");
    case Fault::CheckFailed: return tr("Look at the report for the figures behind it.");
    case Fault::Internal: return tr("Please report it with the log, and save your work under another name.");
  }
  return {};
}

/// What is wrong with the nodes of a coupling, and what to do about it.
QString Sentences::nodes(const std::vector<QString>& a) {
  const QString& why = a[0];
  if (why == u"neither") return tr("The coupling names neither a region nor nodes to hold at. Give it one of the two.");
  if (why == u"both") return tr("The coupling names a region and nodes, and holds by one of the two. Take the other out.");
  if (why == u"unit") return tr("The stiffness of a coupling at nodes is stiffnessPerNode, that of one over a region stiffnessPerArea. Take the other out.");
  if (why == u"rigid") return tr("The coupling names nodes of “%1”, which is rigid and has none. Name a region of it instead, or make the soft part its part A.").arg(a[1]);
  if (why == u"outside") return tr("The coupling names node %1, where the last one of its part’s cells is %2. Pick its nodes again.").arg(a[1], a[2]);
  if (why == u"twice") return tr("The coupling names node %1 twice. Take one of them out.").arg(a[1]);
  if (why == u"few") return tr("The coupling cannot hold against turning: nodes picked: %1. Pick three or more that do not lie in a line.").arg(a[1]);
  if (why == u"line") return tr("The coupling cannot hold against turning: its nodes lie in a line (number: %1). Pick another one beside it.").arg(a[1]);
  if (why == u"far")
    return tr("Of the nodes that hold the coupling, %1 have no node of the new cells within half the diagonal of a cell (the farthest: %2 mm). Make other cells, or "
              "remove the coupling and pick its nodes on the new cells.")
        .arg(a[1], a[2]);
  return tr("The nodes of the coupling cannot be used: %1. Pick them again.").arg(why);
}

QString Sentences::place(const Place& place) {
  QStringList words;
  if (!place.file.empty()) words << QString::fromStdString(place.file);
  if (!place.pointer.empty()) words << tr("at %1").arg(QString::fromStdString(place.pointer));
  if (!place.part.empty()) words << tr("in “%1”").arg(QString::fromStdString(place.part));
  if (place.element) words << tr("element %1").arg(*place.element);
  return words.join(tr(", "));
}

QString Sentences::reason(const QString& word) {
  if (word == u"asked-on") return tr("switched on by the scenario");
  if (word == u"asked-off") return tr("switched off by the scenario");
  if (word == u"auto-present") return tr("the scene holds something it acts on");
  if (word == u"nothing-to-act-on") return tr("nothing in the scene for it to act on");
  if (word == u"not-built") return tr("not available in this version");
  return word;
}

QString Sentences::effect(const QString& word) {
  if (word == u"gravity") return tr("Gravity");
  if (word == u"couplings") return tr("Couplings");
  if (word == u"contact") return tr("Contact");
  if (word == u"selfContact") return tr("Self-contact");
  if (word == u"bursa") return tr("Bursa");
  if (word == u"friction") return tr("Friction");
  if (word == u"damping") return tr("Damping");
  if (word == u"haptics") return tr("Haptics");
  if (word == u"dent") return tr("Dents under a tip");
  if (word == u"skin") return tr("Skin layer");
  return word;
}

}  // namespace

QString placeOf(const Place& place) { return Sentences::place(place); }

QString sentenceOf(const Error& error) {
  std::vector<QString> arguments;
  for (const std::string& argument : error.arguments) arguments.push_back(QString::fromStdString(argument));
  while (arguments.size() < 3) arguments.push_back(QStringLiteral("?"));
  const QString advice = Sentences::advice(error.fault);
  const QString text = Sentences::what(error, arguments) + (advice.isEmpty() ? QString() : QLatin1Char(' ') + advice);
  const QString where = placeOf(error.place);
  return where.isEmpty() ? text : where + QStringLiteral(": ") + text;
}

QString effectReason(const std::string& reason) { return Sentences::reason(QString::fromStdString(reason)); }

QString effectName(const std::string& name) { return Sentences::effect(QString::fromStdString(name)); }

}  // namespace glenoid
