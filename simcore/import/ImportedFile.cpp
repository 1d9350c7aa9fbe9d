// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/ImportedFile.h"

#include <algorithm>
#include <bit>
#include <unordered_map>

namespace glenoid {
namespace {

struct Bits {
  std::array<std::uint64_t, 3> part;
  bool operator==(const Bits&) const = default;
};

struct HashOfBits {
  std::size_t operator()(const Bits& b) const { return hashBytes(b.part.data(), sizeof b.part).low; }
};

Bits bitsOf(const Vec3& p) {
  Bits bits{};
  for (int k = 0; k < 3; ++k) bits.part[k] = std::bit_cast<std::uint64_t>(p[k] == 0 ? 0.0 : p[k]);
  return bits;
}

}  // namespace

const char* importNoteName(ImportNote note) {
  switch (note) {
    case ImportNote::PolygonsSplit: return "polygons-split";
    case ImportNote::StripsSplit: return "strips-split";
    case ImportNote::PointsJoined: return "points-joined";
    case ImportNote::NodesMoved: return "nodes-moved";
    case ImportNote::NodesMirrored: return "nodes-mirrored";
    case ImportNote::LinesDropped: return "lines-dropped";
    case ImportNote::PointsDropped: return "points-dropped";
    case ImportNote::NormalsDropped: return "normals-dropped";
    case ImportNote::TexturesDropped: return "textures-dropped";
    case ImportNote::ColoursDropped: return "colours-dropped";
    case ImportNote::MaterialsDropped: return "materials-dropped";
    case ImportNote::AnimationsDropped: return "animations-dropped";
    case ImportNote::OthersDropped: return "lights-and-cameras-dropped";
    case ImportNote::DataDropped: return "data-dropped";
    case ImportNote::SurfacesWithoutTriangles: return "surfaces-without-triangles";
    case ImportNote::SolidsSkinned: return "solids-skinned";
  }
  return "";
}

const char* fileAxesName(FileAxes axes) {
  switch (axes) {
    case FileAxes::Unsaid: return "";
    case FileAxes::Lps: return "LPS";
    case FileAxes::Ras: return "RAS";
    case FileAxes::XUp: return "X up";
    case FileAxes::YUp: return "Y up";
    case FileAxes::ZUp: return "Z up";
  }
  return "";
}

void addNote(std::vector<NoteCount>& notes, ImportNote note, long count) {
  if (count <= 0) return;
  const auto at = std::lower_bound(notes.begin(), notes.end(), note,
                                   [](const NoteCount& a, ImportNote b) { return a.note < b; });
  if (at != notes.end() && at->note == note)
    at->count += count;
  else
    notes.insert(at, {note, count});
}

long joinIdenticalPoints(TriMesh& mesh) {
  std::vector<int> first(mesh.vertices.size(), -1), number(mesh.vertices.size(), -1);
  std::unordered_map<Bits, int, HashOfBits> known;
  known.reserve(mesh.vertices.size());
  long joined = 0;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const auto [found, isNew] = known.try_emplace(bitsOf(mesh.vertices[i]), static_cast<int>(i));
    first[i] = found->second;
    joined += !isNew;
  }
  for (auto& t : mesh.triangles)
    for (int& i : t) {
      i = first[i];
      number[i] = 0;
    }
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < number.size(); ++i)
    if (number[i] == 0) {
      number[i] = static_cast<int>(kept.size());
      kept.push_back(mesh.vertices[i]);
    }
  for (auto& t : mesh.triangles)
    for (int& i : t) i = number[i];
  mesh.vertices = std::move(kept);
  return joined;
}

}  // namespace glenoid
