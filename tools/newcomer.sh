#!/bin/bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The README's commands in a Debian tree that holds nothing else: a forgotten package is seen.
# shellcheck source=tools/common.sh
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/common.sh"

usage() {
  cat <<'HELP'
Usage: newcomer.sh [options] TREE [COMMAND...]

Makes a tree of Debian 12 in the folder TREE (debootstrap, 300 MB; later 4 GB), puts a fresh clone
of this checkout's last commit into it and runs the commands there, as somebody who begins does;
default: tools/quickstart.sh and tools/check.sh. Each one's output is kept in TREE/log/. The Debian
archive, proxies and certificates are those of this machine. A tree that is there is used again,
with the packages and the LAMMPS that it has; remove it to begin anew. Needs root.

  --user        the commands run as a user with sudo, not as root
  --cache DIR   copies this cache of LAMMPS (~/.cache/mca-wheelrail) into the tree: 3 minutes less
  -h, --help    this text

Exit codes: 0 ok, 1 a command failed, 2 usage, 5 the tree cannot be made.
HELP
}
user=root home=/root cache=''
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --user) user=newcomer home=/home/newcomer; shift ;;
    --cache)
      [ $# -ge 2 ] || die 2 "$1 needs a value; see --help"
      cache=$2; shift 2 ;;
    -*) die 2 "unknown option '$1'; see --help" ;;
    *) break ;;
  esac
done
[ $# -ge 1 ] || die 2 "the folder for the tree is missing; see --help"
tree=$1
shift
[ -z "$cache" ] || [ -d "$cache" ] || die 2 "--cache '$cache': no such folder"
commands=("$@")
[ $# -gt 0 ] || commands=(tools/quickstart.sh tools/check.sh)
[ "$(id -u)" -eq 0 ] || die 5 "this is not root, which debootstrap and chroot need"
command -v debootstrap >/dev/null || die 5 "'debootstrap' is missing: apt-get install debootstrap"

make_tree() {
  local uri
  uri=$(apt-get --print-uris update | sed -n "s|^'\(.*\)/dists/bookworm/InRelease'.*|\1|p" \
    | grep '/debian/*$' | head -n 1)
  [ -n "$uri" ] || die 5 "this machine's apt knows no archive of Debian 12"
  say "a tree of Debian 12 in $tree"
  debootstrap --variant=minbase --include=ca-certificates,git,sudo,debian-archive-keyring \
    bookworm "$tree" "$uri" >"$tree.log" || die 5 "debootstrap failed; log: $tree.log"
  rm "$tree.log"
  # as in Debian's container images: nothing here has to outlive a power failure
  echo force-unsafe-io >"$tree/etc/dpkg/dpkg.cfg.d/newcomer"
  echo 'newcomer ALL=(ALL) NOPASSWD: ALL' >"$tree/etc/sudoers.d/newcomer"
  chroot "$tree" useradd --create-home --shell /bin/bash newcomer
}

copy_settings() { # how this machine reaches a Debian archive
  local file
  for file in /etc/resolv.conf /etc/hosts /etc/apt/apt.conf.d/*prox* /etc/apt/auth.conf \
    /etc/apt/auth.conf.d/* /etc/ssl/certs/ca-certificates.crt; do
    [ ! -f "$file" ] || install -D -m 644 "$file" "$tree$file"
  done
}

copy_project() {
  rm -rf "$tree$home/project"
  git -c safe.directory='*' clone -q "$root" "$tree$home/project"
  if [ -n "$cache" ]; then
    mkdir -p "$tree$home/.cache"
    rm -rf "$tree$home/.cache/mca-wheelrail"
    cp -a "$cache" "$tree$home/.cache/mca-wheelrail"
  fi
  chroot "$tree" chown -R "$user:" "$home"
}

# A command in the tree, with /proc and /dev that go when it ends; nothing else of this machine
inside() { # COMMAND
  # shellcheck disable=SC2016 # $1, $2, ... are those of the inner shells
  env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 \
    unshare --mount --pid --fork sh -c '
      mount -t proc proc "$1/proc" && mount --rbind /dev "$1/dev" || exit
      exec chroot "$1" su - "$2" -c "cd project && exec $3"' sh "$tree" "$user" "$1"
}

mkdir -p "$tree" || die 5 "cannot make the folder '$tree'"
tree=$(readlink -f "$tree")
if [ ! -d "$tree/home/newcomer" ]; then # what is made last
  [ ! -d "$tree/usr" ] || die 5 "$tree: is not a whole tree (its making was interrupted?): remove it"
  make_tree
fi
copy_settings
copy_project
mkdir -p "$tree/log"
status=0
for command in "${commands[@]}"; do
  log=$tree/log/$(basename "${command%% *}").$user.log
  SECONDS=0
  if inside "$command" >"$log" 2>&1; then
    say "$user, $command: ok in $SECONDS s"
  else
    status=1
    tail -n 25 "$log"
    say "$user, $command: FAILED after $SECONDS s; log: $log"
  fi
done
exit $status
