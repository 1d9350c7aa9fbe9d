// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/IslandRows.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <set>

#include "editor/core/AnatomyNames.h"

namespace glenoid {
namespace {

struct IslandTexts {
  Q_DECLARE_TR_FUNCTIONS(glenoid::IslandRows)
 public:
  static QString method(IslandMethod method) {
    switch (method) {
      case IslandMethod::Nothing: return tr("nothing presses");
      case IslandMethod::Pivoting: return tr("pivoting");
      case IslandMethod::Impulses: return tr("Newton on impulses");
      case IslandMethod::Velocities: return tr("Newton on velocities");
      case IslandMethod::Splitting: return tr("as published");
    }
    return {};
  }
  static QString coupling(const QString& a, const QString& b) { return tr("%1 coupled to %2").arg(a, b); }
  static QString contact(const QString& a, const QString& b, int contacts, double force) {
    return tr("%1 touches %2: %n contact(s), %3 N", nullptr, contacts).arg(a, b, QLocale().toString(force, 'f', 2));
  }
  static QString itself(const QString& a, int contacts, double force) {
    return tr("%1 touches itself: %n contact(s), %2 N", nullptr, contacts).arg(a, QLocale().toString(force, 'f', 2));
  }
};

QString nameOfObject(const Model& model, int object) {
  const SceneObject& one = model.objects[static_cast<std::size_t>(object)];
  return anatomyName(one.name.empty() ? one.id : one.name);
}

void addMembers(const Model& model, const std::vector<int>& couplingIslands, QStringList& names) {
  for (std::size_t i = 0; i < model.objects.size(); ++i)
    if (std::find(couplingIslands.begin(), couplingIslands.end(), model.couplingIslandOfObject[i]) != couplingIslands.end()) names << nameOfObject(model, static_cast<int>(i));
}

/// Pairs of objects that springs join inside these islands; what a coupling holds to a fixed part joins nothing.
void addCouplings(const Model& model, const std::vector<int>& couplingIslands, QStringList& why) {
  std::set<std::pair<int, int>> pairs;
  for (const SpringView& spring : model.springs) {
    const int island = model.couplingIslandOfObject[static_cast<std::size_t>(spring.objectA)];
    if (island < 0 || island != model.couplingIslandOfObject[static_cast<std::size_t>(spring.objectB)]) continue;
    if (std::find(couplingIslands.begin(), couplingIslands.end(), island) != couplingIslands.end()) pairs.insert(std::minmax(spring.objectA, spring.objectB));
  }
  for (const auto& [a, b] : pairs) why << IslandTexts::coupling(nameOfObject(model, a), nameOfObject(model, b));
}

IslandRow rowOf(const Model& model, const IslandViews& views, const std::vector<int>& couplingIslands) {
  IslandRow row;
  QStringList members, why;
  addMembers(model, couplingIslands, members);
  addCouplings(model, couplingIslands, why);
  for (const int island : couplingIslands) {
    if (static_cast<std::size_t>(island) >= views.coupling.size()) continue;
    const CouplingIslandView& view = views.coupling[static_cast<std::size_t>(island)];
    row.unknowns += view.unknowns;
    row.ms += view.assembleMs + view.solveMs;
  }
  row.members = members.join(QStringLiteral(", "));
  row.why = why.join(QStringLiteral("; "));
  row.residual = std::nan("");
  return row;
}

}  // namespace

std::vector<IslandRow> islandRows(const Model& model, const IslandViews& views) {
  std::vector<IslandRow> touching, alone;
  std::set<int> used;
  for (const ContactIslandView& view : views.contact) {
    IslandRow row = rowOf(model, views, view.couplingIslands);
    used.insert(view.couplingIslands.begin(), view.couplingIslands.end());
    QStringList why;
    if (!row.why.isEmpty()) why << row.why;
    for (const ContactIslandView::Joint& joint : view.joinedBy)
      why << (joint.objectA == joint.objectB ? IslandTexts::itself(nameOfObject(model, joint.objectA), joint.contacts, joint.force)
                                             : IslandTexts::contact(nameOfObject(model, joint.objectA), nameOfObject(model, joint.objectB), joint.contacts, joint.force));
    row.why = why.join(QStringLiteral("; "));
    row.rows = view.rows;
    row.contacts = view.contacts;
    row.pressing = view.pressing;
    row.residual = view.residual;
    row.ms += view.ms;
    row.method = IslandTexts::method(view.method);
    touching.push_back(std::move(row));
  }
  for (int island = 0; island < static_cast<int>(views.coupling.size()); ++island) {
    if (used.count(island)) continue;
    IslandRow row = rowOf(model, views, {island});
    if (row.why.isEmpty()) row.why = IslandTexts::tr("by itself: nothing touches it and nothing free is coupled to it");
    row.method = IslandTexts::tr("free motion");
    alone.push_back(std::move(row));
  }
  const auto dearer = [](const IslandRow& a, const IslandRow& b) { return a.ms > b.ms; };
  std::stable_sort(touching.begin(), touching.end(), dearer);
  std::stable_sort(alone.begin(), alone.end(), dearer);
  touching.insert(touching.end(), std::make_move_iterator(alone.begin()), std::make_move_iterator(alone.end()));
  return touching;
}

}  // namespace glenoid
