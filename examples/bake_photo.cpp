// Bakes a photograph from C++: bake_photo PICTURE BUNDLE makes the bundle of "texbake bake PICTURE -o BUNDLE".
#include <cstdio>

#include "bake/bake.h"
#include "formats/bundle_io.h"

int main(int argc, char** argv) try {
  if (argc != 3) return std::fputs("bake_photo PICTURE BUNDLE\n", stderr), 2;
  texbake::BakeRequest request;
  request.convert.files.color.file = argv[1];
  texbake::SilentListener nobody;
  texbake::write_bundle(texbake::bake(request, nobody), argv[2]);
} catch (const texbake::Error& error) {
  return std::fprintf(stderr, "bake_photo: %s\n", error.what()), 1;
}
