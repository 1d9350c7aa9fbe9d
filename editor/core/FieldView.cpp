// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/FieldView.h"

#include <algorithm>
#include <cmath>

#include "editor/core/FieldText.h"
#include "editor/core/PartName.h"

namespace glenoid {

FieldView::FieldView(PlayLink& link, QObject* parent) : QObject(parent), m_link(link) {
  connect(&link, &PlayLink::snapshotChanged, this, [this] { onSnapshot(); });
}

void FieldView::onSnapshot() {
  m_stale = true;
  if (m_quantity) prepare();
}

void FieldView::show(std::optional<Quantity> quantity) {
  if (quantity == m_quantity) return;
  m_quantity = quantity;
  m_byHand = false;
  m_steady.forget();
  m_values.reset();
  m_stale = true;
  m_range = quantity ? rangeFor(*quantity, 0) : FieldRange{};
  m_link.setRotationsWanted(quantity.has_value() && *quantity != Quantity::Contact);
  if (quantity) {
    prepare();
  } else {
    m_worker.drop();
    m_asked.reset();
    m_field.reset();
    m_valuesModel.reset();
  }
  emit rangeChanged();
  emit changed();
}

void FieldView::showNext() {
  constexpr int kCount = static_cast<int>(std::size(kQuantities));
  const int next = m_quantity ? static_cast<int>(*m_quantity) + 1 : 0;
  show(next < kCount ? std::optional(kQuantities[next]) : std::nullopt);
}

void FieldView::setShownRange(const FieldRange& range) {
  if (range == m_range) return;
  m_range = range;
  emit rangeChanged();
}

void FieldView::setRange(const FieldRange& range) {
  if (!m_quantity || !std::isfinite(range.low) || !std::isfinite(range.high)) return;
  m_byHand = true;
  m_range = range;
  const double least = 1e-6 * std::max({std::abs(range.low), std::abs(range.high), 1e-3});
  if (!(m_range.high >= m_range.low + least)) m_range.high = m_range.low + least;
  emit rangeChanged();
  emit changed();
}

void FieldView::setAutomatic() {
  if (!m_byHand) return;
  m_byHand = false;
  m_steady.forget();
  m_stale = true;
  emit rangeChanged();
  emit changed();
}

/// Weights for the snapshot's model, unless they are there or on their way.
void FieldView::prepare() {
  const std::shared_ptr<const Model> model = m_link.snapshot().model;
  if (!model || model == m_asked) return;
  m_asked = model;
  m_worker.ask([this, model](const std::atomic<bool>&) -> LatestJob::Answer {
    auto field = std::make_shared<const SurfaceField>(model);
    return [this, field = std::move(field)] {
      m_field = field;
      m_stale = true;
      emit changed();
    };
  });
}

void FieldView::compute() {
  const Snapshot& snapshot = m_link.snapshot();
  m_stale = false;
  if (!m_field || m_field->model() != snapshot.model) {
    m_values.reset();
    return;
  }
  const bool tissue = *m_quantity != Quantity::Contact;
  if (tissue && snapshot.rotations.size() != snapshot.model->start.rotations.size()) {  // asked for, not there yet
    m_values.reset();
    return;
  }
  State state;
  state.q = snapshot.q;
  state.rotations = snapshot.rotations;
  m_values = std::make_shared<const SurfaceValues>(
      m_field->read(*m_quantity, state, snapshot.report.contactViews, hasStretchLaw(snapshot.model->scenario.profile)));
  m_valuesModel = snapshot.model;
}

std::optional<FieldLook> FieldView::look(const Layers& layers) {
  if (!m_quantity) return std::nullopt;
  if (m_stale) compute();
  if (!m_values) return std::nullopt;
  if (!m_byHand) {
    std::vector<char> hidden;
    for (std::size_t i = 0; i < m_valuesModel->objects.size(); ++i) hidden.push_back(!layers.lookOf(static_cast<int>(i)).visible);
    setShownRange(m_steady.follow(*m_quantity, fieldReach(*m_quantity, *m_values, hidden)));
  }
  return fieldLook(*m_quantity, m_values, m_range, QLocale());
}

std::optional<FieldView::Place> FieldView::placeOf(const PickHit& hit) const {
  const Snapshot& snapshot = m_link.snapshot();
  if (!m_quantity || !snapshot.model || hit.surface != SurfaceKind::Visual || hit.object < 0 ||
      hit.object >= static_cast<int>(snapshot.model->objects.size()))
    return std::nullopt;
  const SceneObject& object = snapshot.model->objects[hit.object];
  if (!object.visual.mesh || hit.triangle < 0 || hit.triangle >= static_cast<int>(object.visual.mesh->triangles.size())) return std::nullopt;
  Place place{snapshot.model, hit.object, object.visual.mesh->triangles[hit.triangle], {}};
  std::vector<Vec3> at(object.visual.vertices.size());
  surfacePositions(object.visual, object.layout, snapshot.q, at);
  const Vec3 a = at[place.vertices[0]], b = at[place.vertices[1]], c = at[place.vertices[2]], n = (b - a).cross(c - a);
  const double area = n.squaredNorm();
  if (!(area > 0)) return std::nullopt;
  const double u = (c - b).cross(hit.point_W - b).dot(n) / area, v = (a - c).cross(hit.point_W - c).dot(n) / area;
  place.weights = {std::clamp(u, 0.0, 1.0), std::clamp(v, 0.0, 1.0), 0};
  place.weights[2] = std::max(0.0, 1 - place.weights[0] - place.weights[1]);
  return place;
}

std::optional<double> FieldView::valueAt(const Place& place) const {
  if (!m_quantity || !m_values || place.model != m_valuesModel) return std::nullopt;
  const std::vector<float>& own = (*m_values)[place.object];
  if (own.empty()) return std::nullopt;
  double value = 0;
  for (int k = 0; k < 3; ++k) value += place.weights[k] * own[place.vertices[k]];
  return value;
}

QString FieldView::readingAt(const Place& place) const {
  if (!m_quantity || !m_values || place.model != m_valuesModel) return {};
  const SceneObject& object = place.model->objects[place.object];
  const QString name = object.tool ? QString::fromStdString(object.name) : partName(place.model->joint, object.id);
  const auto value = valueAt(place);
  if (!value) return noFieldReading(*m_quantity, name);
  return fieldReading(*m_quantity, name, *value, fieldUnit(*m_quantity, std::max(std::abs(m_range.low), std::abs(m_range.high))));
}

}  // namespace glenoid
