#!/bin/bash
# usage: spirv.sh WRITE_SHADERS FOLDER [DRAW_CROSSED]: every shader compiles to SPIR-V within limits of time and memory,
# is valid, and stays so when optimized; back in GLSL, it draws the bits that the processor does.
set -eu
for tool in glslangValidator spirv-val spirv-opt spirv-cross; do
  command -v "$tool" >/dev/null || { echo "SKIPPED: no $tool (Debian: glslang-tools spirv-tools spirv-cross)"; exit 77; }
done
mkdir -p "$2" && rm -f "$2"/*
"$1" "$2"
cd "$2"

# limited SECONDS KILOBYTES COMMAND...: of the processor's time, and of memory.
limited() { (ulimit -t "$1" && ulimit -v "$2" && shift 2 && "$@"); }

for kind in "" _viewer _perspective _stack _stack_perspective _stack_viewer; do
  # `precise` as shipped; SPIR-V is made of GLSL from version 450 on.
  sed 's/#version 330 core/#version 450 core/' "330$kind.frag" > "450$kind.frag"
  limited 2 300000 glslangValidator -G --aml -o "330$kind.spv" "450$kind.frag" >/dev/null
  spirv-val "330$kind.spv"
  spirv-opt -O "330$kind.spv" -o "330$kind.opt.spv"
  spirv-val "330$kind.opt.spv"
  spirv-cross --version 400 --no-es "330$kind.opt.spv" > "crossed$kind.frag"
done
echo "6 shaders compile to SPIR-V in 2 s and 300 MB each"
[ $# -lt 3 ] && { echo "without OpenGL nothing is drawn"; exit 0; }
"$3" crossed.frag crossed_stack.frag
