// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "editor/core/Document.h"
#include "simcore/author/MovePart.h"

/// What an author does to parts, materials and contact pairs: each function is one undo step on the document, or
/// does nothing and answers false (an id is unknown or taken, a reference leads nowhere, or the value is the same).
/// Regions, couplings and cages are in AuthorEdits. SI units. GUI thread only.
namespace glenoid {

bool renamePart(Document& document, const std::string& part, const QString& name);
/// Parts stay in the order of their numbers. Not a number that another part has.
bool setPartNumber(Document& document, const std::string& part, int number);
/// Soft needs a volume that is there; rigid lets volume, cell size and cage go. Where a part gets other cells or none, couplings at
/// its nodes are carried over (coupling/CarryNodes.h), which the step's name says; where they cannot be, nothing is done and
/// `why` is the sentence. So in all that follow.
bool setPartKind(Document& document, const std::string& part, PartKind kind, std::shared_ptr<const TetMesh> volume = {},
                 double cellSize = 0, QString* why = nullptr);
/// sRGB, 0…1.
bool setPartColor(Document& document, const std::string& part, const std::array<float, 3>& color);
/// First: default, for the whole part.
bool setPartMaterials(Document& document, const std::string& part, const std::vector<MaterialUse>& materials);
/// Behind all others; its id must be free.
bool addPart(Document& document, const Part& part);
/// With everything that refers to it: couplings, exclusions, sides of bursae, its cage, and what the scenario says of it.
bool removePart(Document& document, const std::string& part);

/// Meshes. Regions on a surface that is replaced are kept only where all their triangles still exist; couplings,
/// materials and bursae that need one that went go with it.
bool setPartSurface(Document& document, const std::string& part, SurfaceKind kind, std::shared_ptr<const TriMesh> mesh);
bool setPartVolume(Document& document, const std::string& part, std::shared_ptr<const TetMesh> volume, double cellSize,
                   QString* why = nullptr);

/// Elsewhere, larger or turned (author/MovePart.h). Its cage and the proof of the start go, since what overlaps is another thing
/// now. `why`: the sentence where it cannot be done.
bool movePart(Document& document, const std::string& part, const PartMove& move, QString* why = nullptr);

/// What a soft part is made of in a run.
bool setPartElements(Document& document, const std::string& part, Elements elements);

bool addMaterial(Document& document, const Material& material);
/// All of its values; the id stays.
bool setMaterial(Document& document, const Material& material, const QString& gesture = {});
/// Not while a part has it.
bool removeMaterial(Document& document, const std::string& material);

bool addExclusion(Document& document, const Exclusion& exclusion);
bool removeExclusion(Document& document, const std::string& partA, const std::string& partB);
/// Contact of a pair on or off, whatever said so before. False when it is so already, or for parts that are not two.
bool setContact(Document& document, const std::string& partA, const std::string& partB, bool on);

}  // namespace glenoid
