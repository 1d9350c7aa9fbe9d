// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "app/PublishedTable.h"
#include "app/commands/Console.h"
#include "app/commands/JointReport.h"
#include "simcore/file/JsonObject.h"
#include "simcore/reading/Readings.h"
#include "simcore/scene/SceneWords.h"

namespace glenoid {
namespace {

using Json = JsonValue;

bool isPublishedShoulder(const Joint& joint) { return joint.id == "shoulder"; }

struct CouplingRow {
  const Coupling* coupling;
  int a, b;         ///< numbers of the parts
  int springs = 0;
  double stiffness = 0, area = 0;
};

std::vector<CouplingRow> couplingRows(const Model& model) {
  std::vector<CouplingRow> rows;
  const auto number = [&](const std::string& id) {
    const int part = findPart(model.joint, id);
    return part < 0 ? 0 : model.joint.parts[part].number;
  };
  for (const Coupling& coupling : model.joint.couplings) rows.push_back({&coupling, number(coupling.partA), number(coupling.partB)});
  for (const SpringView& spring : model.springs) {
    ++rows[spring.coupling].springs;
    rows[spring.coupling].stiffness += spring.stiffness;
  }
  for (CouplingRow& row : rows)
    if (row.coupling->stiffnessPerArea > 0) row.area = row.stiffness / row.coupling->stiffnessPerArea;
  return rows;
}

/// Its region, or how many nodes.
std::string heldText(const Coupling& coupling) { return coupling.byNodes() ? text("%zu nodes", coupling.nodesA.size()) : coupling.regionA; }

std::vector<int> couplingNumbers(const PartReport& part) {
  std::vector<int> numbers;
  for (const PartCoupling& coupling : part.couplings) numbers.push_back(coupling.part);
  return numbers;
}

/// Characters, not bytes: names may hold accents.
std::string padded(const std::string& words, std::size_t width) {
  const auto shown = static_cast<std::size_t>(std::count_if(words.begin(), words.end(), [](char c) { return (c & 0xc0) != 0x80; }));
  return words + std::string(width > shown ? width - shown : 0, ' ');
}

/// A part without a name is known by its id.
const std::string& shownName(const PartReport& part) { return part.name.empty() ? part.id : part.name; }

/// What a part weighs in a run, and how large its visual surface is.
struct Body {
  double mass = 0, volume = 0;    ///< kg, m³
  Vec3 size = Vec3::Zero();       ///< m, of its box
};
Body bodyOf(const Model& model, std::size_t part) {  // parts come first among the objects, in the joint's order
  const TriMesh& surface = *model.joint.parts[part].visual;
  return {readPart(model, model.start, static_cast<int>(part)).mass, enclosedVolume(surface), boundsOf(surface).sizes()};
}

std::string bodiesText(const Model& model, const std::vector<PartReport>& parts) {
  std::string out = text("\n%-3s %-27s %10s %11s  %s\n", "id", "part", "mass g", "volume cm³", "size mm");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Body body = bodyOf(model, i);
    const Vec3 mm = 1e3 * body.size;
    out += text("%-3d ", parts[i].number) + padded(shownName(parts[i]), 27) +
           text(" %10.4g %10.4g  %.4g × %.4g × %.4g\n", 1e3 * body.mass, 1e6 * body.volume, mm.x(), mm.y(), mm.z());
  }
  return out;
}

std::string share(int ours, int theirs) { return text("%+.1f %%", 100.0 * (ours - theirs) / theirs); }

std::string publishedText(const Model& model, const std::vector<PartReport>& parts) {
  std::string out = text("%-3s %-27s %-5s  %7s %6s %8s  %9s %5s %4s  %10s %5s %8s  %-24s %s\n", "id", "part", "kind", "visual",
                         "paper", "", "collision", "paper", "", "tetrahedra", "paper", "", "couplings", "within tolerance");
  int fitting = 0;
  for (const PartReport& part : parts) {
    const Comparison comparison = compare(part);
    const PublishedRow* row = comparison.published;
    out += text("%-3d ", part.number) + padded(shownName(part), 27) + text(" %-5s  %7d ", part.rigid ? "rigid" : "soft", part.renderTriangles);
    if (!row) {
      out += text("%6s %8s  %9d %5s %4s  %10d %5s %8s  ", "-", "", part.collisionTriangles, "-", "", part.tetrahedra, "-", "");
    } else {
      out += text("%6d %8s  %9d %5d %+4d  ", row->render, share(part.renderTriangles, row->render).c_str(),
                  part.collisionTriangles, row->collision, part.collisionTriangles - row->collision);
      if (part.rigid || row->tetrahedra < 0)
        out += text("%10s %5s %8s  ", part.rigid ? "NA" : text("%d", part.tetrahedra).c_str(),
                    row->tetrahedra < 0 ? "NA" : text("%d", row->tetrahedra).c_str(), "");
      else
        out += text("%10d %5d %8s  ", part.tetrahedra, row->tetrahedra, share(part.tetrahedra, row->tetrahedra).c_str());
    }
    out += padded(couplingText(couplingNumbers(part)), 25);
    std::string misses;
    if (!row) misses = "not in the paper";
    for (const auto& [fits, name] : {std::pair(comparison.kind, "kind"), std::pair(comparison.render, "visual"),
                                     std::pair(comparison.collision, "collision"), std::pair(comparison.tetrahedra, "tetrahedra"),
                                     std::pair(comparison.couplings, "couplings")})
      if (row && !fits) misses += (misses.empty() ? "no: " : ", ") + std::string(name);
    out += (misses.empty() ? "yes" : misses) + "\n";
    fitting += comparison.all();
  }
  return out + text("\n%d of %zu parts within the tolerances (visual 5 %%; collision 5 %% or 4; tetrahedra 15 %%), %zu in the paper.\n",
                    fitting, model.joint.parts.size(), publishedTable().size());
}

std::string plainText(const std::vector<PartReport>& parts) {
  std::string out = text("%-3s %-27s %-5s  %8s %10s %11s  %s\n", "id", "part", "kind", "visual", "collision", "tetrahedra", "couplings");
  for (const PartReport& part : parts)
    out += text("%-3d ", part.number) + padded(shownName(part), 27) +
           text(" %-5s  %8d %10d %11s  ", part.rigid ? "rigid" : "soft", part.renderTriangles, part.collisionTriangles,
                part.rigid ? "NA" : text("%d", part.tetrahedra).c_str()) +
           couplingText(couplingNumbers(part)) + "\n";
  return out;
}

/// Side, licence and description as far as they are said.
std::string aboutText(const Joint& joint) {
  std::string out;
  const auto line = [&](const char* what, const std::string& words) {
    if (!words.empty()) out += text("%-12s ", what) + words + "\n";
  };
  line("side:", scene_words::wordOf(scene_words::kJointSides, joint.side));
  line("licence:", joint.provenance.license);
  line("author:", joint.provenance.author);
  line("description:", joint.description);
  return out;
}

}  // namespace

std::string jointInfoText(const Model& model) {
  const Joint& joint = model.joint;
  const std::vector<PartReport> parts = partReports(model);
  std::string out = text("%s: %zu parts, %zu couplings, hash %s\n", joint.name.c_str(), joint.parts.size(),
                         joint.couplings.size(), model.jointHash.c_str());
  out += aboutText(joint) + "\n";
  out += isPublishedShoulder(joint) ? publishedText(model, parts) : plainText(parts);
  out += bodiesText(model, parts);
  out += text("\n%-7s %-40s %-42s %7s %13s %9s\n", "between", "coupling", "region or nodes", "springs", "stiffness N/m", "area mm²");
  for (const CouplingRow& row : couplingRows(model))
    out += text("%-7s ", text("%d-%d", std::min(row.a, row.b), std::max(row.a, row.b)).c_str()) + padded(row.coupling->id, 41) +
           padded(row.coupling->partA + "/" + heldText(*row.coupling), 42) + text(" %7d %13.0f", row.springs, row.stiffness) +
           (row.coupling->byNodes() ? text(" %8s\n", "-") : text(" %8.1f\n", row.area * 1e6));
  return out;
}

std::string jointInfoJson(const Model& model) {
  const Joint& joint = model.joint;
  Json parts = Json::array();
  const std::vector<PartReport> reports = partReports(model);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const PartReport& part = reports[i];
    const Body body = bodyOf(model, i);
    Json size = Json::array();
    for (const double side : body.size) size.append(side);
    Json entry = jsonObject({{"id", part.id}, {"number", part.number}, {"name", part.name},
                             {"kind", part.rigid ? "rigid" : "soft"}, {"renderTriangles", part.renderTriangles},
                             {"collisionTriangles", part.collisionTriangles},
                             {"tetrahedra", part.rigid ? Json() : Json(part.tetrahedra)},
                             {"couplings", jsonArray(couplingNumbers(part))}, {"mass", body.mass}, {"volume", body.volume}, {"size", size}});
    const Comparison fits = compare(part);
    if (isPublishedShoulder(joint) && fits.published) {
      const PublishedRow& row = *fits.published;
      entry.set("published", jsonObject({{"name", row.name}, {"renderTriangles", row.render},
                                         {"collisionTriangles", row.collision},
                                         {"tetrahedra", row.tetrahedra < 0 ? Json() : Json(row.tetrahedra)},
                                         {"couplings", jsonArray(row.couplings)}}));
      entry.set("within", jsonObject({{"kind", fits.kind}, {"renderTriangles", fits.render}, {"collisionTriangles", fits.collision},
                                      {"tetrahedra", fits.tetrahedra}, {"couplings", fits.couplings}, {"all", fits.all()}}));
    }
    parts.append(entry);
  }
  Json couplings = Json::array();
  for (const CouplingRow& row : couplingRows(model)) {
    Json entry = jsonObject({{"id", row.coupling->id}, {"partA", row.coupling->partA}, {"partB", row.coupling->partB}});
    if (!row.coupling->byNodes()) entry.set("regionA", row.coupling->regionA);
    if (row.coupling->byNodes()) entry.set("nodesA", jsonArray(row.coupling->nodesA));
    entry.set("springs", row.springs);
    entry.set("stiffness", row.stiffness);
    if (!row.coupling->byNodes()) entry.set("stiffnessPerArea", row.coupling->stiffnessPerArea);
    if (row.coupling->byNodes()) entry.set("stiffnessPerNode", row.coupling->stiffnessPerNode);
    couplings.append(entry);
  }
  const std::string side = scene_words::wordOf(scene_words::kJointSides, joint.side);
  return toText(jsonObject({{"id", joint.id}, {"name", joint.name}, {"description", joint.description},
                            {"side", side.empty() ? Json() : Json(side)}, {"license", joint.provenance.license},
                            {"hash", model.jointHash}, {"parts", parts}, {"couplings", couplings}}));
}

}  // namespace glenoid
