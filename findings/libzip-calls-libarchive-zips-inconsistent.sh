#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# libzip 1.7.3 with ZIP_CHECKCONS refuses every plain zip of libarchive 3.6.2 (both of Debian 12): "Zip archive inconsistent".
#
# bsdtar and CMake's "-E tar" pack by libarchive. It leaves checksum and packed size for behind the data (bit 3 of the flags), as
# those who write to a pipe do, but states the unpacked size in the local header all the same. libzip's check wants all three there to be zero or
# all to be those of the central directory. Python's zipfile, which leaves all three, passes; without the flag libzip reads both. A program that takes archives from others cannot use
# the flag, and its message, worded as damage, sends people to download again what is whole.
#
# Guess before trying: the flag finds archives whose headers contradict each other or that are cut, and whole ones of common
# programs pass.
#
# Installs pinned public packages in a temporary folder, states what it saw, ends with 1 where that is no longer so.
set -euo pipefail
libzip=1.7.3-1+b1 libarchive=3.6.2-1+deb12u4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libzip-dev=$libzip" "libzip4=$libzip" "libarchive-tools=$libarchive" "libarchive13=$libarchive" >/dev/null 2>&1
for package in *.deb; do dpkg -x "$package" .; done
libraries=$PWD/usr/lib/$(gcc -print-multiarch)

cat >open.c <<'CODE'
#include <stdio.h>
#include <zip.h>
int main(int count, char** words) {
  (void)count;
  const int flags[] = {ZIP_RDONLY | ZIP_CHECKCONS, ZIP_RDONLY};
  for (int i = 0; i < 2; ++i) {
    int code = 0;
    zip_error_t error;
    zip_t* archive = zip_open(words[1], flags[i], &code);
    zip_error_init_with_code(&error, code);
    printf("%s%s", i ? "; " : "", archive ? "opened" : zip_error_strerror(&error));
    if (archive) zip_discard(archive);
  }
  puts("");
}
CODE
gcc -I usr/include open.c -L "$libraries" -l:libzip.so.4 -Wl,-rpath-link,"$libraries" -o open
echo hello >a.txt
LD_LIBRARY_PATH=$libraries usr/bin/bsdtar -a -cf libarchive.zip a.txt
python3 - <<'CODE'
import io
import zipfile

class Pipe(io.RawIOBase):
    def __init__(self): self.bytes = b""
    def writable(self): return True
    def write(self, more):
        self.bytes += bytes(more)
        return len(more)

pipe = Pipe()
with zipfile.ZipFile(pipe, "w", zipfile.ZIP_DEFLATED) as archive: archive.writestr("a.txt", "hello\n")
open("python.zip", "wb").write(pipe.bytes)
CODE
fields() { python3 -c 'import struct,sys; print(*struct.unpack("<H6xIII", open(sys.argv[1], "rb").read()[6:26]))' "$1"; }
echo "libzip4 $libzip, libarchive13 $libarchive"
said=()
for by in libarchive python; do
  said[${#said[@]}]=$(LD_LIBRARY_PATH=$libraries ./open $by.zip)
  echo "  $by: flags, sum, packed, unpacked size in the local header: $(fields $by.zip); checked; not checked: ${said[-1]}"
done
[ "${said[0]}" = "Zip archive inconsistent; opened" ] && [ "${said[1]}" = "opened; opened" ] && [ "$(fields libarchive.zip)" = "8 0 0 6" ]
