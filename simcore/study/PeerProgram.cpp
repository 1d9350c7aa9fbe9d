// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/PeerProgram.h"

#include <spawn.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <locale>
#include <memory>
#include <sstream>

#include "simcore/file/Json.h"
#include "simcore/mesh/TetTools.h"

extern char** environ;

namespace glenoid::peers {

namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

void write(std::ostream& out, const Vec3& v) { out << ' ' << v.x() << ' ' << v.y() << ' ' << v.z(); }

std::vector<int> nodesAt(const TetMesh& mesh, double x) {
  std::vector<int> nodes;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    if (std::abs(mesh.nodes[i].x() - x) < 1e-9) nodes.push_back(static_cast<int>(i));
  return nodes;
}

void writeList(std::ostream& out, const char* name, const std::vector<int>& list) {
  out << name << ' ' << list.size();
  for (const int i : list) out << ' ' << i;
  out << '\n';
}

void writeBlock(const Joint& joint, const Part& part, std::ostream& out) {
  const TetMesh& mesh = *part.volume;
  const Material& material = joint.materials[findMaterial(joint, part.materials[0].material)];
  std::vector<double> mass(mesh.nodes.size(), 0);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const int node : mesh.tets[t]) mass[node] += material.density * tetVolume(mesh, static_cast<int>(t)) / 4;
  out << "block " << part.id << " young " << material.youngsModulus << " poisson " << material.poissonRatio;
  out << "\nnodes " << mesh.nodes.size();
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    write(out, mesh.nodes[i]);
    out << ' ' << mass[i];
  }
  out << "\ntets " << mesh.tets.size();
  for (const auto& t : mesh.tets)
    for (const int node : t) out << ' ' << node;
  const TriMesh surface = boundaryOf(mesh);  // keeps the nodes' numbers
  out << "\nfaces " << surface.triangles.size();
  for (const auto& t : surface.triangles)
    for (const int node : t) out << ' ' << node;
  const Box3 box = boundsOf(*part.visual);
  out << '\n';
  writeList(out, "fixed", nodesAt(mesh, box.min().x()));
  writeList(out, "moving", nodesAt(mesh, box.max().x()));
}

}  // namespace

void writeScene(Stiffness stiffness, double dt, double seconds, std::ostream& out) {
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);
  const Joint joint = makeJoint(stiffness);
  const Scenario scenario = makeScenario(dt);
  const long steps = std::lround(std::min(seconds, kSeconds) / dt);
  const Tool& ridge = scenario.tools[kRidge];
  const Box3 moving = boundsOf(*joint.parts[kBlocks + 1].visual), fixed = boundsOf(*joint.parts[kBlocks].visual);
  out << "dt " << dt << " steps " << steps << " radius " << kBallRadius << " gravity";
  write(out, scenario.gravity_W);
  out << " ridge";
  write(out, Vec3(ridge.radius, ridge.radius, 0.5 * ridge.length));
  out << " bones";
  write(out, 0.5 * moving.sizes());
  write(out, moving.center());
  write(out, fixed.center());
  out << '\n';
  for (int block = 0; block < kBlocks; ++block) writeBlock(joint, joint.parts[block], out);
  out << "path\n";
  std::vector<Pose> hands;
  for (long i = 0; i <= steps; ++i) {  // the first is where everything starts
    const double time = static_cast<double>(i) * dt;
    handsAt(time, hands);
    write(out, ballCentre(time));
    write(out, hands[kRidge] * Vec3(0, 0, 0.5 * ridge.length));
    out << '\n';
  }
  out << "end\n";
}

Result<Row> runProgram(const std::string& program, Stiffness stiffness, double dt, double seconds, double limit) {
  std::error_code ignored;
  if (!std::filesystem::exists(program, ignored)) return Error{Fault::FileMissing, {program, "", "", {}}, {}, "peer"};
  std::ostringstream scene;
  writeScene(stiffness, dt, seconds, scene);
  const File in(std::tmpfile()), out(std::tmpfile());  // nameless, and nothing has to be drained while it runs
  if (!in || !out) return Error{Fault::FileUnwritable, {program, "", "", {}}, {}, "temporary file"};
  std::fputs(scene.str().c_str(), in.get());
  std::rewind(in.get());

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(in.get()), 0);
  posix_spawn_file_actions_adddup2(&actions, fileno(out.get()), 1);
  std::string path = program, limitWord = std::to_string(limit);
  char* arguments[] = {path.data(), limitWord.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawn(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (failed || waitpid(child, &status, 0) != child)
    return Error{Fault::Unusable, {program, "", "", {}}, {program}, "cannot be run"};

  std::rewind(out.get());
  std::string answer;
  char piece[512];
  while (std::fgets(piece, sizeof piece, out.get())) answer += piece;
  const Result<JsonValue> json = parseJson(answer, program);
  if (!json || (*json)["simulator"].text().empty())
    return Error{Fault::Unusable, {program, "", "", {}}, {program}, "printed no row: " + answer};
  Row row = toRow(*json);
  row.stiffness = stiffnessName(stiffness);
  return row;
}

}  // namespace glenoid::peers
