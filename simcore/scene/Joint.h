// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "simcore/scene/Cage.h"
#include "simcore/scene/JointSide.h"
#include "simcore/scene/Material.h"
#include "simcore/scene/Part.h"

namespace glenoid {

/// Zero-length springs between parts `a` and `b`, by one of two ways.
/// Over a region of A: springs are derived when a scenario is compiled, so the coupling survives another cell size and
/// its total stiffness does not depend on the mesh: total k = stiffnessPerArea × area of the region at rest.
/// At nodes of A's cells that somebody picked, as published (paper §4.2): one spring at each, total k =
/// stiffnessPerNode × their number. A must be soft. Their numbers mean nothing in other cells; whoever makes those
/// carries them over (coupling/CarryNodes.h).
/// On B a spring ends at the same place at rest: of a bone, or of the tetrahedron that encloses it.
struct Coupling {
  std::string id;                ///< slug, unique in the joint
  std::string partA, partB;      ///< ids
  std::string regionA;           ///< region of part A; empty: by nodes
  double stiffnessPerArea = 0;   ///< N/m per m², > 0; over a region
  double damping = 0;            ///< s: spring damping coefficient per stiffness (c = damping · k)
  std::string reason;            ///< why the two are joined, a sentence for people; may be empty
  std::vector<int> nodesA = {};  ///< of part A's volume, each once; empty: over the region
  double stiffnessPerNode = 0;   ///< N/m of each spring, > 0; at nodes
  bool byNodes() const { return !nodesA.empty(); }
  bool operator==(const Coupling&) const = default;
};

/// Two parts whose surfaces are not tested against each other, and why.
struct Exclusion {
  std::string partA, partB;  ///< ids
  std::string reason;        ///< a sentence for people
  bool operator==(const Exclusion&) const = default;
};

/// One side of a bursa: a part's collision surface, or what of it lies nearest to one of its visual regions.
struct BursaSide {
  std::string part;    ///< id
  std::string region;  ///< id of a region of that part; empty: the whole surface
  bool operator==(const BursaSide&) const = default;
};

/// A thin slippery sac between tissues that face each other. Its film keeps them apart with a soft pressure,
/// E (thickness − gap) / thickness, and lets them slide. Acts where the effect "bursa" is on, also between parts
/// that are otherwise not tested against each other.
struct Bursa {
  std::string id;                     ///< slug, unique in the joint
  std::string name;                   ///< shown to people
  std::vector<BursaSide> floor, roof; ///< the film is felt at the floor's vertices
  double thickness = 1.5e-3;          ///< m, unloaded
  double youngsModulus = 5e3;         ///< Pa
  double damping = 0;                 ///< s, of the film per stiffness
  double friction = 0;                ///< Coulomb's coefficient of contacts inside the bursa, instead of the materials'
  std::string source;                 ///< where the figures come from
  bool operator==(const Bursa&) const = default;
};

/// Where a joint comes from and under which terms it may be used.
struct Provenance {
  std::string author, license, source, made;  ///< `made`: ISO date or program name
  bool operator==(const Provenance&) const = default;
};

/// What an author made. Values only: ids refer, nothing points. Frame W: X anterior, Y superior, Z to the right of the
/// body (lateral of a right joint, medial of a left one), origin at the joint's centre; metres.
struct Joint {
  std::string id;    ///< slug
  std::string name;  ///< shown to people
  std::string description = {};          ///< shown to people; may be empty
  JointSide side = JointSide::Unsaid;    ///< of the body
  /// Rows: the directions in W along which a run takes what is computed of the joint and needs directions (the integration
  /// points of couplings). Orthogonal, of either hand; W's own unless the joint was built in a frame of its own or mirrored.
  /// A joint and these turned together run alike.
  Mat3 axes_W = Mat3::Identity();
  std::vector<Material> materials;
  std::vector<Part> parts;  ///< ascending by number
  std::vector<Coupling> couplings;
  std::vector<Exclusion> exclusions;
  std::vector<Bursa> bursae;
  std::vector<Cage> cages;
  std::optional<StartProof> startProof;
  Provenance provenance;
};

/// Position in the vector or −1.
int findPart(const Joint& joint, const std::string& id);
int findMaterial(const Joint& joint, const std::string& id);
/// What a part looks like: as its default material does; Plain without one.
Appearance appearanceOf(const Joint& joint, const Part& part);
/// The cage of a part, or null.
const Cage* findCage(const Joint& joint, const std::string& part);
const Region* findRegion(const Part& part, const std::string& id);

/// Triangle indices of a region, ascending.
std::vector<int> trianglesOf(const Region& region);

/// Runs that hold exactly these triangles (sorted and made unique first).
std::vector<TriangleRun> runsOf(std::vector<int> triangles);

/// Area of the region at rest, m².
double areaOf(const Part& part, const Region& region);

}  // namespace glenoid
