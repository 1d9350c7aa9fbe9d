// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "editor/core/Document.h"
#include "simcore/author/MakeBody.h"
#include "simcore/scene/ProposeExclusions.h"

/// What an author does to regions, couplings, exclusions, cages and bodies: each function is one undo step on
/// the document, or does nothing and answers so. Ids are those of the joint; SI units. GUI thread only.
namespace glenoid {

/// A slug that is not taken: letters, digits and hyphens of `wish`, with a number where needed.
std::string freshId(const std::string& wish, const std::vector<std::string>& taken);

/// The wish for a coupling: a region of part A, or triangles from which one is made, or nodes of its cells.
struct CouplingWish {
  std::string partA, partB;
  std::string region;  ///< id of a region of A; empty: made from `triangles`
  SurfaceKind surface = SurfaceKind::Visual;
  std::vector<int> triangles;   ///< ascending
  double stiffnessPerArea = 0;  ///< N/m per m²
  double damping = 1e-3;        ///< s
  std::string reason = {};
  std::vector<int> nodes = {};  ///< ascending; then neither region nor triangles
  double stiffnessPerNode = 0;  ///< N/m of each spring
};

/// Id of the new region; empty when the part is unknown or nothing is selected.
std::string addRegion(Document& document, const std::string& part, const QString& name, SurfaceKind surface,
                      const std::vector<int>& triangles);
bool setRegion(Document& document, const std::string& part, const std::string& region, SurfaceKind surface,
               const std::vector<int>& triangles);
bool renameRegion(Document& document, const std::string& part, const std::string& region,
                  const QString& name);
/// Not while a coupling, a material or a bursa refers to it.
bool removeRegion(Document& document, const std::string& part, const std::string& region);
bool isRegionUsed(const Joint& joint, const std::string& part, const std::string& region);

/// Id of the new coupling; empty when a part is unknown, both are the same, nothing is selected, or nodes cannot hold.
std::string addCoupling(Document& document, const CouplingWish& wish);
/// Other nodes for a coupling at nodes; nothing where they cannot hold.
bool setCouplingNodes(Document& document, const std::string& coupling, const std::vector<int>& nodes);
/// Whether such a coupling at nodes would hold its parts against turning.
bool canHoldAt(const Joint& joint, const Coupling& coupling);
bool removeCoupling(Document& document, const std::string& coupling);
bool setCouplingReason(Document& document, const std::string& coupling, const QString& reason);
bool setCouplingDamping(Document& document, const std::string& coupling, double seconds);

/// Collision of a pair off, with the reason written into the joint.
bool excludePair(Document& document, const ExclusionProposal& proposal);

/// The cage in the place of the one its part had; false for a part that is not soft, an id that another has,
/// or no change. The proof of the start goes with every change of a cage.
bool setCage(Document& document, const Cage& cage, const QString& text);
/// Handles to these places, as many as there are; steps in a row with one `gesture` are one.
bool moveHandles(Document& document, const std::string& part, const std::vector<Vec3>& moved_W,
                 const QString& gesture = {});
bool removeCage(Document& document, const std::string& part);
/// All cages and the proof at once, as a job found them.
bool setStart(Document& document, const std::vector<Cage>& cages, const std::optional<StartProof>& proof,
              const QString& text);

/// Another body for a part: its cage and the proof of the start go with the meshes they were made for.
/// Nothing is done where a region that something refers to would be lost, or couplings at its nodes cannot be carried over
/// to the new cells (coupling/CarryNodes.h). `said`: how many were, or why not.
bool setBody(Document& document, const std::string& part, const BodyWish& wish, const Body& body, QString* said = nullptr);

/// What a part of such a tissue is coloured where its author did not choose; sRGB.
std::array<float, 3> usualColor(Appearance appearance);
/// The part's main material becomes this one, which joins the joint where its id is not known there yet. A part in the
/// usual colour of its old tissue takes that of the new one.
bool setMaterial(Document& document, const std::string& part, const Material& material);
/// A copy of the part's main material of its own, to be changed freely; id of it, empty where there is none.
std::string ownMaterial(Document& document, const std::string& part);

}  // namespace glenoid
