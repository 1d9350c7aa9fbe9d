// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/reading/Trace.h"

#include <algorithm>
#include <charconv>

#include "simcore/reading/Readings.h"

namespace glenoid {

namespace {

constexpr const char* kPartColumns[] = {"x", "y", "z", "vx", "vy", "vz", "qx", "qy", "qz", "qw", "wx", "wy", "wz"};
constexpr const char* kPairColumns[] = {"contacts", "fx", "fy", "fz", "normal", "penetration"};

void appendNumber(std::string& out, double value) {
  char text[40];
  out.append(text, std::to_chars(text, text + sizeof text, value).ptr);
}

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::vector<std::string> split(const std::string& list, char separator) {
  std::vector<std::string> items;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(separator, begin), list.size());
    items.push_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return items;
}

Error badList(const char* option, const std::string& list, const char* form) {
  return {Fault::BadUsage, {}, {std::string(option) + " says “" + list + "” and must say " + form}, ""};
}

int objectNamed(const Model& model, const std::string& id) {
  for (std::size_t i = 0; i < model.objects.size(); ++i)
    if (model.objects[i].id == id) return static_cast<int>(i);
  return -1;
}

}  // namespace

Result<std::vector<std::string>> tracePartsIn(const std::string& list) {
  std::vector<std::string> parts = split(list, ',');
  for (const std::string& part : parts)
    if (part.empty()) return badList("--trace-parts", list, "ID,ID,…");
  return parts;
}

Result<std::vector<std::array<std::string, 2>>> tracePairsIn(const std::string& list) {
  std::vector<std::array<std::string, 2>> pairs;
  for (const std::string& item : split(list, ',')) {
    const std::vector<std::string> ends = split(item, ':');
    if (ends.size() != 2 || ends[0].empty() || ends[1].empty()) return badList("--trace-pairs", list, "ID:ID,ID:ID,…");
    pairs.push_back({ends[0], ends[1]});
  }
  return pairs;
}

Result<Trace> Trace::make(const Model& model, const TraceWishes& wishes) {
  Trace trace(model);
  trace.m_every = std::max(1, wishes.every);
  trace.m_anyPair = wishes.pairs.empty();
  const auto known = [&](const std::string& id) -> Result<int> {
    const int object = objectNamed(model, id);
    if (object < 0) return Error{Fault::UnknownId, {}, {id, "part"}, "trace"};
    return object;
  };
  for (const std::string& id : wishes.parts) {
    const Result<int> object = known(id);
    if (!object) return object.error();
    trace.m_parts.push_back(*object);
  }
  if (wishes.parts.empty())
    for (std::size_t i = 0; i < model.objects.size(); ++i)
      if (model.objects[i].layout.free || model.objects[i].motion >= 0) trace.m_parts.push_back(static_cast<int>(i));
  for (const auto& [a, b] : wishes.pairs) {
    const Result<int> first = known(a), second = known(b);
    if (!first) return first.error();
    if (!second) return second.error();
    if (*first == *second) return Error{Fault::BadUsage, {}, {"--trace-pairs names “" + a + "” twice in one pair"}, ""};
    trace.m_pairs.push_back({*first, *second});
  }
  return trace;
}

void Trace::begin(const State& start, std::span<const Penetration> depths) { addRow(start, depths); }

void Trace::addRow(const State& state, std::span<const Penetration> depths) {
  m_measured.push_back(depths.empty() ? 0 : 1);
  for (std::size_t p = 0; p < depths.size(); ++p)
    if (depths[p].depth > 0) m_depths.push_back({m_rows, static_cast<int>(p), depths[p].depth});
  m_values.push_back(state.time);
  for (const int object : m_parts) {
    const PartReading part = readPart(*m_model, state, object);
    for (const Vec3& vector : {part.centre_W, part.velocity_W}) m_values.insert(m_values.end(), vector.data(), vector.data() + 3);
    m_values.insert(m_values.end(), part.q_WB.coeffs().data(), part.q_WB.coeffs().data() + 4);
    m_values.insert(m_values.end(), part.angularVelocity_W.data(), part.angularVelocity_W.data() + 3);
  }
  ++m_rows;
}

int Trace::pairOf(int a, int b, double& sign) {
  for (std::size_t i = 0; i < m_pairs.size(); ++i) {
    sign = m_pairs[i][0] == a ? 1 : -1;
    if ((m_pairs[i][0] == a && m_pairs[i][1] == b) || (m_pairs[i][0] == b && m_pairs[i][1] == a)) return static_cast<int>(i);
  }
  if (!m_anyPair) return -1;
  sign = 1;
  m_pairs.push_back({a, b});
  return static_cast<int>(m_pairs.size()) - 1;
}

int Trace::modelPair(int a, int b) const {
  for (std::size_t p = 0; p < m_model->collisionPairs.size(); ++p) {
    const CollisionPair& pair = m_model->collisionPairs[p];
    if ((pair.surfaceA == a && pair.surfaceB == b) || (pair.surfaceA == b && pair.surfaceB == a)) return static_cast<int>(p);
  }
  return -1;
}

void Trace::add(const StepReport& step, const State& state, std::span<const Penetration> depths) {
  if (++m_steps % m_every != 0) return;
  addRow(state, depths);
  const std::size_t first = m_forces.size();
  for (const ContactView& contact : step.contactViews) {
    if (!(contact.force > 0)) continue;
    double sign = 1;
    const int pair = pairOf(contact.objectA, contact.objectB, sign);
    if (pair < 0) continue;
    const auto there = std::find_if(m_forces.begin() + static_cast<std::ptrdiff_t>(first), m_forces.end(), [&](const PairForce& f) { return f.pair == pair; });
    PairForce& sum = there != m_forces.end() ? *there : m_forces.emplace_back(PairForce{m_rows - 1, pair, 0, Vec3::Zero(), 0});
    ++sum.contacts;
    sum.force_W += sign * (contact.force * contact.normal_W + contact.friction_W);
    sum.normal += contact.force;
  }
}

std::string Trace::csv() const {
  std::string out = "time,penetration";
  for (const int object : m_parts)
    for (const char* column : kPartColumns) out += "," + cell(m_model->objects[object].id + "." + column);
  for (const auto& pair : m_pairs)
    for (const char* column : kPairColumns)
      out += "," + cell(m_model->objects[pair[0]].id + ":" + (pair[0] == pair[1] ? "itself" : m_model->objects[pair[1]].id) + "." + column);
  out += "\n";
  const std::size_t width = 1 + std::size(kPartColumns) * m_parts.size();
  std::size_t next = 0, nextDepth = 0;
  std::vector<const PairForce*> row(m_pairs.size());
  std::vector<double> depths(m_model->collisionPairs.size());
  std::vector<int> modelPairs;
  for (const auto& pair : m_pairs) modelPairs.push_back(modelPair(pair[0], pair[1]));
  for (int r = 0; r < m_rows; ++r) {
    std::fill(depths.begin(), depths.end(), 0.0);
    double deepest = 0;
    for (; nextDepth < m_depths.size() && m_depths[nextDepth].row == r; ++nextDepth) {
      depths[m_depths[nextDepth].pair] = m_depths[nextDepth].depth;
      deepest = std::max(deepest, m_depths[nextDepth].depth);
    }
    for (std::size_t i = 0; i < width; ++i) {
      if (i > 0) out += ',';
      appendNumber(out, m_values[static_cast<std::size_t>(r) * width + i]);
      if (i > 0) continue;
      out += ',';
      if (m_measured[r]) appendNumber(out, deepest);
    }
    std::fill(row.begin(), row.end(), nullptr);
    for (; next < m_forces.size() && m_forces[next].row == r; ++next) row[m_forces[next].pair] = &m_forces[next];
    for (std::size_t p = 0; p < row.size(); ++p) {
      const PairForce none{r, 0, 0, Vec3::Zero(), 0};
      const PairForce& shown = row[p] ? *row[p] : none;
      out += "," + std::to_string(shown.contacts);
      for (const double value : {shown.force_W.x(), shown.force_W.y(), shown.force_W.z(), shown.normal}) {
        out += ',';
        appendNumber(out, value);
      }
      out += ',';
      if (m_measured[r] && modelPairs[p] >= 0) appendNumber(out, depths[modelPairs[p]]);
    }
    out += "\n";
  }
  return out;
}

}  // namespace glenoid
