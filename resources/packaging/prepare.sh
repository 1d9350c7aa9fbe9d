# SPDX-License-Identifier: GPL-3.0-or-later
# Shared by app/run.sh and tests/run.sh: sourced, not started. Installs the Debian packages that are missing,
# configures and builds build/release. Both scripts use one build folder with the same settings, so that neither
# makes the other start anew.
# Variables of the caller's environment: GLENOID_BUILD (build folder), GLENOID_JOBS (compilers at once).

glenoid_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
glenoid_build=${GLENOID_BUILD:-$glenoid_root/build/release}

glenoid_say() { printf '%s\n' "$*" >&2; }

# Lists of packages in this folder that the caller wants; tests/run.sh adds one.
glenoid_lists=(packages-debian12.txt)

# Names in those lists, without comments.
glenoid_packages() {
  (cd "$glenoid_root/resources/packaging" && sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "${glenoid_lists[@]}")
}

# Those of the list that are not installed, one a line.
glenoid_missing_packages() {
  local wanted installed
  wanted=$(glenoid_packages)
  # A package that dpkg has never heard of makes dpkg-query fail, and that is an ordinary answer here.
  installed=$(dpkg-query -W -f '${db:Status-Abbrev}${Package}\n' $wanted 2>/dev/null | sed -n 's/^ii *//p') || true
  comm -23 <(sort -u <<<"$wanted") <(sort -u <<<"$installed")
}

# Runs a command as root; fails where that cannot be done without asking for a password nobody could type.
glenoid_as_root() {
  if [ "$(id -u)" = 0 ]; then
    "$@"
  elif [ -t 0 ]; then
    sudo "$@"
  else
    sudo -n "$@"
  fi
}

glenoid_apt() {
  glenoid_as_root env DEBIAN_FRONTEND=noninteractive apt-get -y -q -o DPkg::Lock::Timeout=300 \
    -o Acquire::Retries=3 -o Dpkg::Use-Pty=0 "$@"
}

glenoid_install_packages() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    glenoid_say "This is no Debian system: install by hand what resources/packaging/packages-debian12.txt names." \
      "Trying to build with what is there."
    return 0
  fi
  local missing
  missing=$(glenoid_missing_packages)
  [ -z "$missing" ] && return 0
  if [ "$(id -u)" != 0 ] && ! command -v sudo >/dev/null; then
    glenoid_say "Packages are missing and can be installed only by root: apt-get install" $missing
    return 1
  fi
  glenoid_say "Installing $(wc -w <<<"$missing") packages:" $missing
  # With package lists at hand the first try succeeds; with none, or with old ones, it is made again after an update.
  if ! ls /var/lib/apt/lists/*Packages* >/dev/null 2>&1 ||
    ! glenoid_apt install --no-install-recommends $missing </dev/null >&2; then
    glenoid_apt update </dev/null >&2 && glenoid_apt install --no-install-recommends $missing </dev/null >&2 || {
      glenoid_say "The packages could not be installed. By hand: apt-get install --no-install-recommends" $missing
      return 1
    }
  fi
}

# As many compilers as there are cores, but no more than the memory holds (1.5 GB each).
glenoid_jobs() {
  local cores memory
  if [ -n "${GLENOID_JOBS:-}" ]; then
    echo "$GLENOID_JOBS"
    return
  fi
  cores=$(nproc)
  memory=$(awk '/MemAvailable/ {print int($2 / 1500000)}' /proc/meminfo 2>/dev/null || echo "$cores")
  [ "${memory:-0}" -lt 1 ] && memory=1
  echo $((memory < cores ? memory : cores))
}

# glenoid_make TARGET...: configures where there is no build folder yet, then lets Ninja bring the targets up to date.
glenoid_make() {
  if [ ! -f "$glenoid_build/build.ninja" ]; then
    glenoid_say "Configuring $glenoid_build"
    (cd "$glenoid_root" && cmake --preset release -B "$glenoid_build" -DGLENOID_TESTS=ON) >&2 || {
      glenoid_say "CMake could not configure the build; the lines above say what is missing."
      return 1
    }
  fi
  cmake --build "$glenoid_build" --parallel "$(glenoid_jobs)" --target "$@" >&2 || {
    glenoid_say "The build failed; the lines above say where."
    return 1
  }
}
