#version 330 core
#extension GL_ARB_gpu_shader5 : enable
// `precise` forbids fused and reordered arithmetic. A driver without the extension draws the same decisions and may
// round colors once less. Define PRECISE as nothing where a compiler claims the extension and lacks the word.
#ifndef PRECISE
#ifdef GL_ARB_gpu_shader5
#define PRECISE precise
#else
#define PRECISE
#endif
#endif
