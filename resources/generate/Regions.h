// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>

#include "resources/generate/Parts.h"
#include "simcore/scene/Part.h"

/// Regions picked by a rule instead of by hand: the same rule on the same surface gives the same triangles.
/// Millimetres, frame W.
namespace glenoid::generate {

/// Triangles whose centroid satisfies the rule.
Region regionWhere(const TriMesh& visual, std::string id, std::string name, std::string kind,
                   const std::function<bool(const Vec3& centroid)>& rule);

/// Triangles between two places of a swept tube, as shares of its rings (0 first ring, 1 last).
Region regionAlong(const TriMesh& visual, int around, int along, std::string id, std::string name,
                   std::string kind, double from, double to);

/// Triangles of both.
Region common(const Region& a, const Region& b);

/// Root and end of the biceps anchor, made of so many rings of so many points.
std::vector<Region> labrumTendonRegions(const TriMesh& visual, int around, int along);

/// Regions and landmarks of a part by its id; landmarks in metres. Empty for an unknown id.
std::vector<Region> regionsOf(const std::string& id, const TriMesh& visual, const Bones& bones);
std::vector<Landmark> landmarksOf(const std::string& id, const Bones& bones);

}  // namespace glenoid::generate
