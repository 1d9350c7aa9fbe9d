// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/accuracy/AccuracyErrors.h"

#include <cassert>
#include <cmath>

namespace glenoid {
namespace {

/// Sum of squares of one object, pair or tool.
struct Sum {
  double squares = 0, most = 0;
  long count = 0;
  void add(double error) {
    squares += error * error;
    most = std::max(most, error);
    ++count;
  }
};

template <class Name>
AccuracyError largest(const std::vector<Sum>& sums, const Name& name) {
  AccuracyError found;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (sums[i].count == 0) continue;
    const double value = std::sqrt(sums[i].squares / static_cast<double>(sums[i].count));
    found.most = std::max(found.most, sums[i].most);
    if (value <= found.value) continue;
    found.value = value;
    found.where = name(i);
  }
  return found;
}

}  // namespace

const char* quantityKey(AccuracyQuantity quantity) {
  switch (quantity) {
    case AccuracyQuantity::Displacement: return "displacement";
    case AccuracyQuantity::ContactForce: return "contactForce";
    case AccuracyQuantity::Penetration: return "penetration";
    case AccuracyQuantity::HandForce: return "handForce";
  }
  return "";
}

AccuracyErrors errorsOf(const Model& model, std::span<const AccuracyTrace> traces, std::span<const AccuracyTrace> reference) {
  assert(traces.size() == reference.size() && !traces.empty());
  const std::size_t count = model.objects.size();
  std::vector<Sum> places(count), forces(count * count), depths(count * count), hands(model.scenario.tools.size());
  for (std::size_t w = 0; w < traces.size(); ++w) {
    for (std::size_t k = 0; k < traces[w].samples.size(); ++k) {
      const AccuracySample &a = traces[w].samples[k], &b = reference[w].samples[k];
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t p = 0; p < a.places[i].size(); ++p) places[i].add((a.places[i][p] - b.places[i][p]).norm());
      for (std::size_t pair = 0; pair < forces.size(); ++pair) forces[pair].add((a.pairForces[pair] - b.pairForces[pair]).norm());
      for (std::size_t tool = 0; tool < hands.size(); ++tool) hands[tool].add((a.handForces[tool] - b.handForces[tool]).norm());
    }
    for (std::size_t pair = 0; pair < depths.size(); ++pair) depths[pair].add(std::abs(traces[w].depths[pair] - reference[w].depths[pair]));
  }
  const auto object = [&](std::size_t i) { return model.objects[i].id; };
  const auto pair = [&](std::size_t i) { return i / count == i % count ? object(i / count) : object(i / count) + " / " + object(i % count); };
  AccuracyErrors errors;
  errors.by[0] = largest(places, object);
  errors.by[1] = largest(forces, pair);
  errors.by[2] = largest(depths, pair);
  errors.by[3] = largest(hands, [&](std::size_t i) { return model.scenario.tools[i].id; });
  return errors;
}

}  // namespace glenoid
