#!/usr/bin/env bash
# cpack makes a Debian package that holds all it should, names what it needs and runs unpacked: package.sh BUILD_FOLDER
. "$(dirname "$0")/scratch.sh"
[ -z "$SANITIZE" ] || skip "packed in the release build only"
for program in dpkg-deb dpkg-shlibdeps file; do
  command -v $program > /dev/null || skip "no $program here (Debian: dpkg-dev file), so that no package is made"
done

cpack -G DEB --config "$1/CPackConfig.cmake" -B "$PWD/made" > cpack.txt || fail "cpack: $(tail -5 cpack.txt)"
package=$(echo made/texbake_*.deb)
version=$("$TEXBAKE" --version | grep -o '[0-9][0-9.]*' | head -1)
[ "$(dpkg-deb -f "$package" Version)" = "$version" ] || fail "the package is not of version $version"

dpkg-deb -x "$package" unpacked
for path in bin/texbake include/texbake/formats/bundle.h share/texbake/shaders/content.glsl \
  share/texbake/schemas/camera.schema.json share/doc/texbake/copyright share/man/man1/texbake.1 share/man/man1/texbake-select-contents.1 \
  share/bash-completion/completions/texbake share/zsh/site-functions/_texbake share/fish/vendor_completions.d/texbake.fish; do
  [ -f "unpacked/usr/$path" ] || fail "the package lacks $path"
done
[ -n "$(find unpacked/usr -name texbake-config.cmake)" ] || fail "the package lacks what find_package(texbake) reads"

# Run from where it was unpacked, it draws what the program of the build folder draws.
unpacked/usr/bin/texbake render good.texbundle -o unpacked.png --size 64x64
texbake render good.texbundle -o built.png --size 64x64
cmp unpacked.png built.png || fail "the unpacked program draws another picture"

# Each shared library is in a package that the dependencies name.
depends=$(dpkg-deb -f "$package" Depends)
readelf -d unpacked/usr/bin/texbake | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' > needed.txt
[ -s needed.txt ] || fail "readelf finds no shared library"
while read -r library; do
  path=$(ldd unpacked/usr/bin/texbake | sed -n "s|.*$library => \([^ ]*\).*|\1|p")
  [ -n "$path" ] || continue  # the loader itself
  path=$(readlink -f "$path")
  # Some packages list /lib, which is a link to /usr/lib.
  owner=$({ dpkg -S "$path" || dpkg -S "${path#/usr}"; } 2> /dev/null | sed 's/:.*//' | head -1)
  [ -n "$owner" ] || fail "no package holds $path"
  grep -qw -- "$owner" <<< "$depends" || fail "$library is in $owner, which is not among the dependencies: $depends"
done < needed.txt
