#!/usr/bin/env bash
# find_package(texbake) gives the library and the program, and examples/*.cpp do what the program does: install.sh
# BUILD_FOLDER COMPILER
. "$(dirname "$0")/scratch.sh"
[ -z "$SANITIZE" ] || skip "installed in the release build only"
cmake --install "$1" --prefix "$PWD/prefix" > /dev/null
prefix/bin/texbake --version

mkdir consumer && cd consumer
cat > CMakeLists.txt <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES CXX)
find_package(texbake REQUIRED)
add_executable(consumer main.cpp)
target_link_libraries(consumer PRIVATE texbake::formats texbake::draw)
add_executable(bake_photo bake_photo.cpp)
target_link_libraries(bake_photo PRIVATE texbake::bake)
CMAKE
cp "$SOURCE/examples/bake_photo.cpp" .
cat > main.cpp <<'CPP'
#include "formats/bundle_io.h"
#include "libbake/draw/window.h"

int main(int, char** argv) {
  const texbake::Bundle bundle = texbake::read_bundle(argv[1]);
  const texbake::Scale& scale = bundle.scales.front();
  const auto planes = texbake::prepare({.base = scale.base(), .patches = &*scale.patches, .contents = &*scale.contents});
  texbake::Window window;
  window.width = window.height = 8;
  return texbake::render_rows(planes, window, 0, 8).size() == 64 ? 0 : 1;
}
CPP
cmake -G Ninja -S . -B build -DCMAKE_CXX_COMPILER="$2" -DCMAKE_PREFIX_PATH="$SCRATCH/prefix" -DCMAKE_CXX_STANDARD=20 > /dev/null
cmake --build build > /dev/null
build/consumer ../good.texbundle

# Baked from C++, the bundle is that of the program to the byte.
build/bake_photo "$EXEMPLARS/pebbles.png" library.texbundle
../prefix/bin/texbake bake "$EXEMPLARS/pebbles.png" -o program.texbundle
diff -r library.texbundle program.texbundle
