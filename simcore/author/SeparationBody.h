// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "simcore/author/CagedPart.h"
#include "simcore/spatial/TriangleTree.h"

/// One part while the start is freed of intersections, and what it is asked for. Internal to SeparateStart; README has
/// the equations.
namespace glenoid::separation {

/// A wish of one point of a part's surface: n · Δx ≥ amount.
struct Wish {
  std::array<int, 3> vertex;
  Vec3 weight;
  Vec3 normal;
  double amount;
};

/// One part while things are moved.
struct Body {
  const Part* part = nullptr;
  TriMesh surface;
  std::unique_ptr<TriangleTree> tree;
  Box3 box;
  std::vector<std::array<int, 2>> edges;
  std::optional<CagedPart> caged;  ///< only where the cage may move
  std::vector<double> hardness;
  MatX stiffness;

  void refresh() {
    tree = std::make_unique<TriangleTree>(surface);
    box = boundsOf(surface);
  }
};

/// Edges of a closed surface, each once.
std::vector<std::array<int, 2>> edgesOf(const TriMesh& mesh);

/// Makes the part follow a cage from now on. Fails as CagedPart::make does.
Result<Done> putInCage(Body& body, const Cage& cage);

/// What the surface of `body` must do to keep `clearance` to `other`; `share`: the part of it that it does itself.
void wishesAgainst(const Body& body, const Body& other, double clearance, double share, std::vector<Wish>& wishes);

/// Ways by which a thin body that another cuts through can come to lie on one side of it: out of `other` on the side of
/// most of the body's points near it, and the opposite; the one with less to go first. Zero where there is none.
std::array<Vec3, 2> sidesOf(const Body& body, const Body& other);

/// As wishesAgainst, but all points go the same way: each whose path along `side` still meets the other's surface within
/// a few millimetres goes to where that path leaves it.
void wishesToward(const Body& body, const Body& other, const Vec3& side, double clearance, std::vector<Wish>& wishes);

/// Handle shifts of least energy that fulfil the wishes, as far as the penalty goes (against a stiffness whose mean
/// diagonal is one).
VecX leastEnergy(const Body& body, const std::vector<Wish>& wishes, double penalty);

/// Takes the step as far as no tetrahedron is squeezed too much; what is squeezed gets harder.
void take(Body& body, const VecX& goal);

}  // namespace glenoid::separation
