#!/usr/bin/env bash
# find_package(texbake) gives the library and the program, and examples/*.cpp, built against the installed package, do
# what the program does: install.sh BUILD_FOLDER COMPILER
. "$(dirname "$0")/scratch.sh"
[ -z "$SANITIZE" ] || skip "installed in the release build only"
cmake --install "$1" --prefix "$PWD/prefix" > /dev/null
prefix/bin/texbake --version

mkdir consumer
cat > consumer/CMakeLists.txt <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES CXX)
find_package(texbake REQUIRED)
add_executable(embed ${EXAMPLES}/embed.cpp)
target_link_libraries(embed PRIVATE texbake::formats texbake::draw)
add_executable(bake_photo ${EXAMPLES}/bake_photo.cpp)
target_link_libraries(bake_photo PRIVATE texbake::bake)
CMAKE
cmake -S consumer -B consumer/build -G Ninja -DCMAKE_CXX_COMPILER="$2" -DCMAKE_PREFIX_PATH="$PWD/prefix" \
  -DCMAKE_CXX_STANDARD=20 -DEXAMPLES="$SOURCE/examples" > /dev/null
cmake --build consumer/build > /dev/null

# Drawn from C++, a picture is that of the program to the bit: same_picture BUNDLE [MAP]
same_picture() {
  local map=()
  [ $# -lt 2 ] || map=(--map "$2")
  consumer/build/embed "$1" embedded.exr "${@:2}"
  prefix/bin/texbake render "$1" -o rendered.exr --bits float --size 320x200 --origin -1000,250 "${map[@]}"
  cmp embedded.exr rendered.exr || fail "embed draws another picture of $* than texbake render"
}
same_picture good.texbundle
same_picture good.texbundle roughness
same_picture good.texbundle normal
same_picture layered.texbundle
texbake stack good.texbundle layered.texbundle --ratio 4 -o stack.texbundle
same_picture stack.texbundle

# Baked from C++, the bundle is that of the program to the byte.
consumer/build/bake_photo "$EXEMPLARS/pebbles.png" library.texbundle
prefix/bin/texbake bake "$EXEMPLARS/pebbles.png" -o program.texbundle
diff -r library.texbundle program.texbundle
