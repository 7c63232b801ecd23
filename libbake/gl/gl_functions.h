// The entry points of OpenGL that the runner uses: the same names in GL 3.3 core and in GL ES 3.0.
#pragma once

#include <GL/glcorearb.h>

namespace texbake {

struct GlFunctions {
  PFNGLACTIVETEXTUREPROC ActiveTexture = nullptr;
  PFNGLATTACHSHADERPROC AttachShader = nullptr;
  PFNGLBINDFRAMEBUFFERPROC BindFramebuffer = nullptr;
  PFNGLBINDTEXTUREPROC BindTexture = nullptr;
  PFNGLBINDVERTEXARRAYPROC BindVertexArray = nullptr;
  PFNGLCHECKFRAMEBUFFERSTATUSPROC CheckFramebufferStatus = nullptr;
  PFNGLCOMPILESHADERPROC CompileShader = nullptr;
  PFNGLCREATEPROGRAMPROC CreateProgram = nullptr;
  PFNGLCREATESHADERPROC CreateShader = nullptr;
  PFNGLDELETEFRAMEBUFFERSPROC DeleteFramebuffers = nullptr;
  PFNGLDELETEPROGRAMPROC DeleteProgram = nullptr;
  PFNGLDELETESHADERPROC DeleteShader = nullptr;
  PFNGLDELETETEXTURESPROC DeleteTextures = nullptr;
  PFNGLDELETEVERTEXARRAYSPROC DeleteVertexArrays = nullptr;
  PFNGLDRAWARRAYSPROC DrawArrays = nullptr;
  PFNGLDRAWBUFFERSPROC DrawBuffers = nullptr;
  PFNGLFINISHPROC Finish = nullptr;
  PFNGLFRAMEBUFFERTEXTURE2DPROC FramebufferTexture2D = nullptr;
  PFNGLGENFRAMEBUFFERSPROC GenFramebuffers = nullptr;
  PFNGLGENTEXTURESPROC GenTextures = nullptr;
  PFNGLGENVERTEXARRAYSPROC GenVertexArrays = nullptr;
  PFNGLGETERRORPROC GetError = nullptr;
  PFNGLGETINTEGERVPROC GetIntegerv = nullptr;
  PFNGLGETPROGRAMINFOLOGPROC GetProgramInfoLog = nullptr;
  PFNGLGETPROGRAMIVPROC GetProgramiv = nullptr;
  PFNGLGETSHADERINFOLOGPROC GetShaderInfoLog = nullptr;
  PFNGLGETSHADERIVPROC GetShaderiv = nullptr;
  PFNGLGETSTRINGPROC GetString = nullptr;
  PFNGLGETUNIFORMLOCATIONPROC GetUniformLocation = nullptr;
  PFNGLLINKPROGRAMPROC LinkProgram = nullptr;
  PFNGLPIXELSTOREIPROC PixelStorei = nullptr;
  PFNGLREADBUFFERPROC ReadBuffer = nullptr;
  PFNGLREADPIXELSPROC ReadPixels = nullptr;
  PFNGLSHADERSOURCEPROC ShaderSource = nullptr;
  PFNGLTEXIMAGE2DPROC TexImage2D = nullptr;
  PFNGLTEXPARAMETERIPROC TexParameteri = nullptr;
  PFNGLUNIFORM1FPROC Uniform1f = nullptr;
  PFNGLUNIFORM1IPROC Uniform1i = nullptr;
  PFNGLUNIFORM1UIPROC Uniform1ui = nullptr;
  PFNGLUNIFORM2IPROC Uniform2i = nullptr;
  PFNGLUNIFORM2IVPROC Uniform2iv = nullptr;
  PFNGLUNIFORM2UIPROC Uniform2ui = nullptr;
  PFNGLUNIFORM3FPROC Uniform3f = nullptr;
  PFNGLUNIFORM4FPROC Uniform4f = nullptr;
  PFNGLUNIFORM4IPROC Uniform4i = nullptr;
  PFNGLUNIFORM4UIVPROC Uniform4uiv = nullptr;
  PFNGLUSEPROGRAMPROC UseProgram = nullptr;
  PFNGLVIEWPORTPROC Viewport = nullptr;
};

/// Calls `visit(member, "glName")` for every entry point.
template <class Visitor>
void for_each_gl_function(GlFunctions& gl, Visitor&& visit) {
  visit(gl.ActiveTexture, "glActiveTexture");
  visit(gl.AttachShader, "glAttachShader");
  visit(gl.BindFramebuffer, "glBindFramebuffer");
  visit(gl.BindTexture, "glBindTexture");
  visit(gl.BindVertexArray, "glBindVertexArray");
  visit(gl.CheckFramebufferStatus, "glCheckFramebufferStatus");
  visit(gl.CompileShader, "glCompileShader");
  visit(gl.CreateProgram, "glCreateProgram");
  visit(gl.CreateShader, "glCreateShader");
  visit(gl.DeleteFramebuffers, "glDeleteFramebuffers");
  visit(gl.DeleteProgram, "glDeleteProgram");
  visit(gl.DeleteShader, "glDeleteShader");
  visit(gl.DeleteTextures, "glDeleteTextures");
  visit(gl.DeleteVertexArrays, "glDeleteVertexArrays");
  visit(gl.DrawArrays, "glDrawArrays");
  visit(gl.DrawBuffers, "glDrawBuffers");
  visit(gl.Finish, "glFinish");
  visit(gl.FramebufferTexture2D, "glFramebufferTexture2D");
  visit(gl.GenFramebuffers, "glGenFramebuffers");
  visit(gl.GenTextures, "glGenTextures");
  visit(gl.GenVertexArrays, "glGenVertexArrays");
  visit(gl.GetError, "glGetError");
  visit(gl.GetIntegerv, "glGetIntegerv");
  visit(gl.GetProgramInfoLog, "glGetProgramInfoLog");
  visit(gl.GetProgramiv, "glGetProgramiv");
  visit(gl.GetShaderInfoLog, "glGetShaderInfoLog");
  visit(gl.GetShaderiv, "glGetShaderiv");
  visit(gl.GetString, "glGetString");
  visit(gl.GetUniformLocation, "glGetUniformLocation");
  visit(gl.LinkProgram, "glLinkProgram");
  visit(gl.PixelStorei, "glPixelStorei");
  visit(gl.ReadBuffer, "glReadBuffer");
  visit(gl.ReadPixels, "glReadPixels");
  visit(gl.ShaderSource, "glShaderSource");
  visit(gl.TexImage2D, "glTexImage2D");
  visit(gl.TexParameteri, "glTexParameteri");
  visit(gl.Uniform1f, "glUniform1f");
  visit(gl.Uniform1i, "glUniform1i");
  visit(gl.Uniform1ui, "glUniform1ui");
  visit(gl.Uniform2i, "glUniform2i");
  visit(gl.Uniform2iv, "glUniform2iv");
  visit(gl.Uniform2ui, "glUniform2ui");
  visit(gl.Uniform3f, "glUniform3f");
  visit(gl.Uniform4f, "glUniform4f");
  visit(gl.Uniform4i, "glUniform4i");
  visit(gl.Uniform4uiv, "glUniform4uiv");
  visit(gl.UseProgram, "glUseProgram");
  visit(gl.Viewport, "glViewport");
}

}  // namespace texbake
