#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# CalculiX 2.20 (Debian 12): of a real number in an input deck only the first twenty characters are read, without a word where
# the rest was part of the exponent.
#
# Seventeen digits and an exponent, what a program writes so that a double comes back as it was, are 21 to 24 characters. One
# whose twentieth character is the first digit of a two-digit exponent loses the second: a modulus of 1e11 counts as 1e1, a bar
# gives ten orders of magnitude too much, and the run ends well. One that is cut before those digits is an error. So a program
# that writes such decks must stay within twenty characters a number: 12 significant digits leave room for sign and exponent.
#
# Guess before trying: numbers are read free of format, as everywhere else in a deck of commas; digits beyond those of a double
# are rounded, and a number that cannot be read is an error.
#
# Installs pinned public packages in a temporary folder, states what it saw, ends with 1 where that is no longer so.
set -euo pipefail
ccx=2.20-1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "calculix-ccx=$ccx" libspooles2.2 libarpack2 libgfortran5 libopenblas0-pthread >/dev/null 2>&1
for package in *.deb; do dpkg -x "$package" .; done
libraries=$(dirname "$(find . -name 'libspooles*.so.*' | head -1)")
export LD_LIBRARY_PATH="$PWD/$libraries:$PWD/$libraries/openblas-pthread" OMP_NUM_THREADS=1

# One hexahedron of a metre, held at its foot without holding its sides, drawn at its top by 1 N at each corner: it lengthens by
# 4 N / E. Prints how much, or what stopped the run.
lengthens() {  # MODULUS
  cat >bar.inp <<DECK
*NODE, NSET=ALL
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
*ELEMENT, TYPE=C3D8, ELSET=BAR
1, 1, 2, 3, 4, 5, 6, 7, 8
*MATERIAL, NAME=STUFF
*ELASTIC
$1, 0
*SOLID SECTION, ELSET=BAR, MATERIAL=STUFF
*BOUNDARY
1, 1, 3
2, 2, 3
3, 3, 3
4, 3, 3
*STEP
*STATIC
*CLOAD
5, 3, 1
6, 3, 1
7, 3, 1
8, 3, 1
*NODE PRINT, NSET=ALL
U
*END STEP
DECK
  rm -f bar.dat
  usr/bin/ccx bar >bar.log 2>&1 || true
  if grep -q '\*ERROR' bar.log; then
    grep -m 1 -o '\*ERROR.*' bar.log
  else
    awk '$1 == 7 && NF == 4 { print $4 }' bar.dat
  fi
}
short=$(lengthens 1.e11)
twenty=$(lengthens 1.000000000000000e11)
more=$(lengthens 1.0000000000000000e11)
cut=$(lengthens 1.00000000000000000e11)
echo "calculix-ccx $ccx, a bar that lengthens by 4 N / E:"
echo "  E = 1.e11                      $short"
echo "  E = 1.000000000000000e11  (20) $twenty"
echo "  E = 1.0000000000000000e11 (21) $more"
echo "  E = 1.00000000000000000e11 (22) $cut"
[ "$short" = 4.000000E-11 ] && [ "$twenty" = 4.000000E-11 ] && [ "$more" = 4.000000E-01 ] && [[ "$cut" == *'ERROR reading *ELASTIC'* ]]
