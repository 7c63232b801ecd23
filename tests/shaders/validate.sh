#!/bin/bash
# usage: validate.sh WRITE_SHADERS GLSLANG FOLDER: every assembled shader passes, and a broken one does not.
set -eu
mkdir -p "$3" && rm -f "$3"/*
"$1" "$3"
# glslang claims GL_ARB_gpu_shader5 but knows `precise` from version 400 on only: 330 without the word, then 400 with it.
"$2" -l -DPRECISE= "$3/330.vert" "$3/330.frag"
"$2" -l "$3/300es.vert" "$3/300es.frag"
for kind in viewer perspective stack stack_perspective stack_viewer; do
  "$2" -l -DPRECISE= "$3/330.vert" "$3/330_$kind.frag"
  "$2" -l "$3/300es.vert" "$3/300es_$kind.frag"
done
sed 's/#version 330 core/#version 400 core/' "$3/330.frag" > "$3/400.frag"
"$2" "$3/400.frag"
sed 's/uvec2 tile;/vec2 tile;/' "$3/300es.frag" > "$3/broken.frag"
if "$2" "$3/broken.frag" > /dev/null; then echo "a broken shader passes"; exit 1; fi
