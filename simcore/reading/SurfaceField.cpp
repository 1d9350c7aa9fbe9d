// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/reading/SurfaceField.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "simcore/reading/ContactSpread.h"
#include "simcore/reading/Tissue.h"
#include "simcore/step/StepModel.h"

namespace glenoid {

namespace {

constexpr const char* kNames[] = {"stress", "strain", "pressure", "contact"};

/// xx, yy, zz, xy, xz, yz and room for a whole vector register.
using Packed = Eigen::Matrix<float, 8, 1>;

Packed packed(const Mat3& s) {
  Packed out;
  out << float(s(0, 0)), float(s(1, 1)), float(s(2, 2)), float(s(0, 1)), float(s(0, 2)), float(s(1, 2)), 0, 0;
  return out;
}

Mat3 unpacked(const Packed& p) {
  Mat3 s;
  s << p[0], p[3], p[4], p[3], p[1], p[5], p[4], p[5], p[2];
  return s;
}

double numberOf(Quantity quantity, const Mat3& tensor) {
  switch (quantity) {
    case Quantity::Stress: return vonMises(tensor);
    case Quantity::Strain: return largestPrincipal(tensor);
    case Quantity::Pressure: return pressureOf(tensor);
    case Quantity::Contact: break;
  }
  return 0;
}

const SoftObject& softOf(const Model& model, int object) { return static_cast<const SoftObject&>(*model.inside->objects[object]); }

}  // namespace

const char* quantityName(Quantity quantity) { return kNames[static_cast<int>(quantity)]; }

std::optional<Quantity> quantityNamed(std::string_view name) {
  for (const Quantity quantity : kQuantities)
    if (name == quantityName(quantity)) return quantity;
  return std::nullopt;
}

double largestPrincipal(const Mat3& symmetric) {
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(symmetric, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[2];
}

double pressureOf(const Mat3& stress) { return -stress.trace() / 3; }

SurfaceField::SurfaceField(std::shared_ptr<const Model> model) : m_model(std::move(model)), m_tables(m_model->objects.size()) {
  for (std::size_t i = 0; i < m_model->objects.size(); ++i) {
    const SceneObject& object = m_model->objects[i];
    if (object.layout.rigid || !object.visual.mesh || !object.volume) continue;
    m_hasTissue = true;
    m_tables[i] = recoveryTable(softOf(*m_model, static_cast<int>(i)).samples(), object.visual.mesh->vertices, recoveryReach(*object.volume));
  }
}

void SurfaceField::readTissue(int object, Quantity quantity, const State& state, bool stretchLaw, std::vector<float>& out) const {
  const RecoveryTable& table = m_tables[object];
  std::vector<ElementReading> readings;
  softOf(*m_model, object).readSamples(state, readings, stretchLaw);
  std::vector<Packed> samples(readings.size());
  for (std::size_t i = 0; i < readings.size(); ++i)
    samples[i] = packed(quantity == Quantity::Strain ? readings[i].strain_W : readings[i].stress_W);
  out.resize(table.places());
  for (std::size_t v = 0; v < out.size(); ++v) {
    Packed sum = Packed::Zero();
    for (int k = table.first[v]; k < table.first[v + 1]; ++k) sum += table.weight[k] * samples[table.index[k]];
    out[v] = static_cast<float>(numberOf(quantity, unpacked(sum)));
  }
}

SurfaceValues SurfaceField::read(Quantity quantity, const State& state, std::span<const ContactView> contacts, bool stretchLaw) const {
  if (quantity == Quantity::Contact) return spreadContacts(*m_model, state.q, contacts);
  SurfaceValues values(m_model->objects.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (m_tables[i].places() > 0) readTissue(static_cast<int>(i), quantity, state, stretchLaw, values[i]);
  return values;
}

std::optional<FieldPeak> peakOf(const Model& model, const SurfaceValues& values, int object, const VecX& q) {
  const std::vector<float>& own = values[object];
  if (own.empty()) return std::nullopt;
  const auto most = std::max_element(own.begin(), own.end());
  const SceneObject& scene = model.objects[object];
  std::vector<Vec3> positions(scene.visual.vertices.size());
  surfacePositions(scene.visual, scene.layout, q, positions);
  return FieldPeak{*most, positions[static_cast<std::size_t>(most - own.begin())]};
}

}  // namespace glenoid
