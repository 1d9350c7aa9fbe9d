#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# assimp 5.2.5 (Debian 12): a comma inside a number is a decimal point, in STL, OBJ, PLY and OFF alike.
#
# Programs that run in a German, French or Spanish locale write "vertex 3,81 0,50 -149,77" where they forget to switch it off.
# None of the four formats allows that, yet assimp reads each such number whole and right, so a file of that kind needs no
# rewriting before it. Commas between numbers are another matter: with a space behind them OBJ is read, STL is refused; an answer
# by one format says nothing about the next.
#
# Guess before trying: as with strtod in the C locale the number ends at the comma, so that 1,5 becomes 1 without a word, or the
# file is refused.
#
# Installs pinned public packages in a temporary folder, states what it saw, ends with 1 where that is no longer so.
set -euo pipefail
assimp=5.2.5~ds0-1+b1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libassimp-dev=$assimp" "libassimp5=$assimp" libdraco7 libminizip1 >/dev/null 2>&1
for package in *.deb; do dpkg -x "$package" .; done
libraries=$PWD/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH 2>/dev/null || gcc -print-multiarch)

cat >read.cpp <<'CODE'
#include <assimp/scene.h>
#include <assimp/Importer.hpp>
#include <cstdio>
int main(int, char** words) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(words[1], 0);
  if (!scene || scene->mNumMeshes == 0) {
    std::puts("refused");
    return 0;
  }
  const aiMesh& mesh = *scene->mMeshes[0];
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) std::printf("(%g %g %g)", mesh.mVertices[i].x, mesh.mVertices[i].y, mesh.mVertices[i].z);
  std::puts("");
}
CODE
g++ -I usr/include read.cpp -L "$libraries" -l:libassimp.so.5 -Wl,-rpath-link,"$libraries" -o read
points() { printf "$1%s\n" "$2" "$3" "$4"; }
stl() { echo "solid x"; echo "facet normal 0 0 1"; echo "outer loop"; points "vertex " "$@"; echo "endloop"; echo "endfacet"; echo "endsolid x"; }
obj() { points "v " "$@"; echo "f 1 2 3"; }
ply() {
  printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n'
  printf 'property list uchar int vertex_indices\nend_header\n'
  points "" "$@"
  echo "3 0 1 2"
}
off() { printf 'OFF\n3 1 0\n'; points "" "$@"; echo "3 0 1 2"; }
decimal=("0 0 0" "1,5 0 0" "0 2,25 0") between=("0, 0, 0" "1, 5, 0" "0, 2, 7")
echo "libassimp5 $assimp"
good=0
for format in stl obj ply off; do
  "$format" "${decimal[@]}" >"decimal.$format"
  answer=$(LD_LIBRARY_PATH=$libraries ./read "decimal.$format")
  echo "  1,5 and 2,25 in $format:        $answer"
  [ "$answer" = "(0 0 0)(1.5 0 0)(0 2.25 0)" ] && good=$((good + 1))
done
stl "${between[@]}" >between.stl
obj "${between[@]}" >between.obj
inStl=$(LD_LIBRARY_PATH=$libraries ./read between.stl) inObj=$(LD_LIBRARY_PATH=$libraries ./read between.obj)
echo "  a comma and a space between numbers: stl $inStl, obj $inObj"
[ "$good" = 4 ] && [ "$inStl" = refused ] && [ "$inObj" = "(0 0 0)(1 5 0)(0 2 7)" ]
