#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Qt 6.4.2 (Debian 12): every space of a text that QPdfWriter writes is named a tab, and which reader is asked decides who sees it.
#
# A PDF holds glyphs, and a map from each to the letter it stands for (ToUnicode), which search and copying go by. Qt's map says
# U+0009 for the glyph of the space, with DejaVu Sans and with Liberation Sans. pdftotext makes a space of its own of it, so
# a look with that finds nothing wrong; PyPDF2 and pdfminer hand the tab on, and who looks for two words with a space between
# them in what those say does not find them. The title of a plot is one of its kind.
#
# Guess before trying: ligatures apart, what QPainter::drawText was given comes back letter by letter, and readers agree.
#
# Installs pinned public packages in a temporary folder, states what it saw, ends with 1 where that is no longer so.
set -euo pipefail
qt=6.4.2+dfsg-10
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libqt6core6=$qt" "libqt6gui6=$qt" "qt6-base-dev=$qt" fonts-dejavu-core=2.37-6 fonts-liberation2=2.1.5-1 \
  python3-pypdf2=2.12.1-3+deb12u1 python3-pdfminer=20221105+dfsg-1.1~deb12u1 poppler-utils=22.12.0-2+deb12u3 libpoppler126=22.12.0-2+deb12u3 >/dev/null 2>&1
for package in *.deb; do dpkg -x "$package" .; done

cat >words.cpp <<'CODE'
#include <QFontDatabase>
#include <QGuiApplication>
#include <QPainter>
#include <QPdfWriter>
int main(int argc, char** argv) {
  QGuiApplication application(argc, argv);
  const int font = QFontDatabase::addApplicationFont(argv[1]);
  QPdfWriter writer(argv[2]);
  QPainter painter(&writer);
  painter.setFont(QFont(QFontDatabase::applicationFontFamilies(font).at(0), 12));
  painter.drawText(500, 1000, "error of displacement");
}
CODE
lib=$folder/usr/lib/x86_64-linux-gnu
headers=$folder/usr/include/x86_64-linux-gnu/qt6
c++ -std=c++17 -fPIC -I "$headers" -I "$headers/QtCore" -I "$headers/QtGui" words.cpp -L "$lib" -l:libQt6Gui.so.6 -l:libQt6Core.so.6 -o words
export LD_LIBRARY_PATH=$lib QT_PLUGIN_PATH=$lib/qt6/plugins QT_QPA_PLATFORM=offscreen PYTHONPATH=$folder/usr/lib/python3/dist-packages

cat >read.py <<'CODE'
import sys
import PyPDF2
from pdfminer.high_level import extract_text
print(repr(PyPDF2.PdfReader(sys.argv[1]).pages[0].extract_text().strip()), repr(extract_text(sys.argv[1]).strip()))
CODE
status=0
for font in truetype/dejavu/DejaVuSans.ttf truetype/liberation2/LiberationSans-Regular.ttf; do
  ./words "usr/share/fonts/$font" words.pdf 2>/dev/null
  others=$(/usr/bin/python3 read.py words.pdf)
  poppler=$(usr/bin/pdftotext words.pdf - | head -1)
  echo "Qt $qt, $(basename "$font"): PyPDF2 and pdfminer read $others, pdftotext '$poppler'"
  [ "$others" = "'error\\tof\\tdisplacement' 'error\\tof\\tdisplacement'" ] || status=1
  [ "$poppler" = "error of displacement" ] || status=1
done
exit "$status"
