#!/usr/bin/env bash
# verify and render with the reference shader on OpenGL; and what they say where there is none, or a wrong one.
. "$(dirname "$0")/scratch.sh"
code_of() { local code=0; "$@" > out 2> err || code=$?; echo $code; }

code=$(code_of texbake verify good.texbundle --backend gl --windows 2)
if [ "$code" -eq 5 ]; then cat err >&2; skip "no OpenGL"; fi
[ "$code" -eq 0 ] || { cat out err >&2; fail "the shader differs: exit code $code"; }
[ "$(grep -c 'equals the processor' out)" -eq 2 ] || fail "expected both languages: $(cat out)"
grep -q '^  [0-9]* points, \([0-9]*\) of \1 contents: 0 decisions, 0 points and 0 bits differ' out || fail "$(cat out)"

# Both backends write the same bytes, over several tiles of the driver.
for what in "" "--map normal" "--map height" "--map roughness"; do
  texbake render good.texbundle -o cpu.exr --bits float --size 1100x1050 --origin -70.25,99999999999 --step 0.7 $what
  texbake render good.texbundle -o gl.exr --bits float --size 1100x1050 --origin -70.25,99999999999 --step 0.7 $what \
    --backend gl
  cmp cpu.exr gl.exr || fail "the backends differ: $what"
done

# Far away too; and the endless plane and relief, but for the pixels that see another place.
for what in "--step 23.5" "--step 100 --map normal" "--view plane --camera-height 700" \
  "--relief 12 --view-direction 1,0,1" "--relief 12 --view plane --camera-height 700"; do
  texbake render good.texbundle -o cpu.exr --bits float --size 300x200 --origin -70.25,99999999999 $what
  texbake render good.texbundle -o gl.exr --bits float --size 300x200 --origin -70.25,99999999999 $what --backend gl
  oiiotool cpu.exr gl.exr --diff --fail 0 --failpercent 5 > out || fail "the backends differ: $what: $(cat out)"
done

# No driver, an old one, no such device: one message, exit code 5, nothing written.
export MESA_GL_VERSION_OVERRIDE=2.1
[ "$(code_of texbake verify good.texbundle --backend gl)" -eq 5 ] || fail "an old OpenGL is not refused"
grep -q 'expected a driver for OpenGL 3.3 core' err || fail "$(cat err)"
unset MESA_GL_VERSION_OVERRIDE
[ "$(code_of env __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null "$TEXBAKE" verify good.texbundle --backend gl)" -eq 5 ] ||
  fail "no EGL is not refused"
[ "$(code_of texbake render good.texbundle -o none.png --backend gl --gl-device 63)" -eq 5 ] || fail "no such device"
[ ! -e none.png ] || fail "a picture without a driver"

# A driver that runs another shader is found out. Mesa reads the text from a file where it is told to.
mkdir shaders
MESA_SHADER_DUMP_PATH=$PWD/shaders texbake verify good.texbundle --backend gl --gl-language core --windows 1 > out
grep -lq 747796405u shaders/FS_*.glsl 2> /dev/null || { echo "this driver takes no other shader; that was not tried" >&2; exit 0; }
sed -i 's/747796405u/747796407u/' shaders/FS_*.glsl
code=0
MESA_SHADER_READ_PATH=$PWD/shaders texbake verify good.texbundle --backend gl --gl-language core --windows 1 > out || code=$?
[ $code -eq 1 ] || { cat out >&2; fail "another hash is not seen: exit code $code"; }
grep -q 'differs from the processor' out && grep -q 'first decision: tile' out && grep -q 'worst value: ' out ||
  fail "no place is named: $(cat out)"
