// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QObject>
#include <set>
#include <string>

namespace glenoid {

/// Which objects (parts and tools, by id) are selected, and which one lies under the cursor. GUI thread only.
class Selection : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  const std::set<std::string>& ids() const { return m_ids; }
  bool contains(const std::string& id) const { return m_ids.count(id) > 0; }
  /// The one whose properties are shown: the last one selected; empty when none is.
  const std::string& current() const { return m_current; }
  const std::string& hovered() const { return m_hovered; }

  void select(const std::string& id) { assign({id}, id); }
  void clear() { assign({}, {}); }
  void add(const std::string& id) {
    std::set<std::string> ids = m_ids;
    ids.insert(id);
    assign(std::move(ids), id);
  }
  void remove(const std::string& id) {
    std::set<std::string> ids = m_ids;
    ids.erase(id);
    const std::string current = m_current != id ? m_current : ids.empty() ? std::string() : *ids.begin();
    assign(std::move(ids), current);
  }
  void assign(std::set<std::string> ids, const std::string& current) {
    if (ids == m_ids && current == m_current) return;
    m_ids = std::move(ids);
    m_current = current;
    emit changed();
  }
  void hover(const std::string& id) {
    if (id == m_hovered) return;
    m_hovered = id;
    emit hoverChanged();
  }

 signals:
  void changed();
  void hoverChanged();

 private:
  std::set<std::string> m_ids;
  std::string m_current, m_hovered;
};

}  // namespace glenoid
