// SPDX-License-Identifier: Apache-2.0
#include "gl_scene.h"

#include "raster/image.h"

#include <GL/glext.h>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace auslan::bench {
namespace {

[[noreturn]] void stop(const std::string& message) {
  std::fprintf(stderr, "OSMesa: %s\n", message.c_str());
  std::exit(1);
}

/// OpenGL's functions by their types, found once.
struct Gl {
  template <typename Function>
  static void find(Function& function, const char* name) {
    const OSMESAproc found = OSMesaGetProcAddress(name);
    if (found == nullptr) stop(std::string("there is no ") + name);
    std::memcpy(&function, &found, sizeof function);
  }
  explicit Gl(int) {
    find(GenVertexArrays, "glGenVertexArrays");
    find(BindVertexArray, "glBindVertexArray");
    find(DeleteVertexArrays, "glDeleteVertexArrays");
    find(GenBuffers, "glGenBuffers");
    find(BindBuffer, "glBindBuffer");
    find(BufferData, "glBufferData");
    find(DeleteBuffers, "glDeleteBuffers");
    find(EnableVertexAttribArray, "glEnableVertexAttribArray");
    find(VertexAttribPointer, "glVertexAttribPointer");
    find(CreateShader, "glCreateShader");
    find(ShaderSource, "glShaderSource");
    find(CompileShader, "glCompileShader");
    find(GetShaderiv, "glGetShaderiv");
    find(GetShaderInfoLog, "glGetShaderInfoLog");
    find(CreateProgram, "glCreateProgram");
    find(AttachShader, "glAttachShader");
    find(BindAttribLocation, "glBindAttribLocation");
    find(LinkProgram, "glLinkProgram");
    find(GetProgramiv, "glGetProgramiv");
    find(UseProgram, "glUseProgram");
    find(DeleteShader, "glDeleteShader");
    find(DeleteProgram, "glDeleteProgram");
    find(GetUniformLocation, "glGetUniformLocation");
    find(UniformMatrix4fv, "glUniformMatrix4fv");
    find(Uniform3fv, "glUniform3fv");
    find(GenFramebuffers, "glGenFramebuffers");
    find(BindFramebuffer, "glBindFramebuffer");
    find(DeleteFramebuffers, "glDeleteFramebuffers");
    find(GenRenderbuffers, "glGenRenderbuffers");
    find(BindRenderbuffer, "glBindRenderbuffer");
    find(DeleteRenderbuffers, "glDeleteRenderbuffers");
    find(RenderbufferStorageMultisample, "glRenderbufferStorageMultisample");
    find(FramebufferRenderbuffer, "glFramebufferRenderbuffer");
    find(CheckFramebufferStatus, "glCheckFramebufferStatus");
    find(BlitFramebuffer, "glBlitFramebuffer");
    find(ClipControl, "glClipControl");
  }
  PFNGLGENVERTEXARRAYSPROC GenVertexArrays;
  PFNGLBINDVERTEXARRAYPROC BindVertexArray;
  PFNGLDELETEVERTEXARRAYSPROC DeleteVertexArrays;
  PFNGLGENBUFFERSPROC GenBuffers;
  PFNGLBINDBUFFERPROC BindBuffer;
  PFNGLBUFFERDATAPROC BufferData;
  PFNGLDELETEBUFFERSPROC DeleteBuffers;
  PFNGLENABLEVERTEXATTRIBARRAYPROC EnableVertexAttribArray;
  PFNGLVERTEXATTRIBPOINTERPROC VertexAttribPointer;
  PFNGLCREATESHADERPROC CreateShader;
  PFNGLSHADERSOURCEPROC ShaderSource;
  PFNGLCOMPILESHADERPROC CompileShader;
  PFNGLGETSHADERIVPROC GetShaderiv;
  PFNGLGETSHADERINFOLOGPROC GetShaderInfoLog;
  PFNGLCREATEPROGRAMPROC CreateProgram;
  PFNGLATTACHSHADERPROC AttachShader;
  PFNGLBINDATTRIBLOCATIONPROC BindAttribLocation;
  PFNGLLINKPROGRAMPROC LinkProgram;
  PFNGLGETPROGRAMIVPROC GetProgramiv;
  PFNGLUSEPROGRAMPROC UseProgram;
  PFNGLDELETESHADERPROC DeleteShader;
  PFNGLDELETEPROGRAMPROC DeleteProgram;
  PFNGLGETUNIFORMLOCATIONPROC GetUniformLocation;
  PFNGLUNIFORMMATRIX4FVPROC UniformMatrix4fv;
  PFNGLUNIFORM3FVPROC Uniform3fv;
  PFNGLGENFRAMEBUFFERSPROC GenFramebuffers;
  PFNGLBINDFRAMEBUFFERPROC BindFramebuffer;
  PFNGLDELETEFRAMEBUFFERSPROC DeleteFramebuffers;
  PFNGLGENRENDERBUFFERSPROC GenRenderbuffers;
  PFNGLBINDRENDERBUFFERPROC BindRenderbuffer;
  PFNGLDELETERENDERBUFFERSPROC DeleteRenderbuffers;
  PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC RenderbufferStorageMultisample;
  PFNGLFRAMEBUFFERRENDERBUFFERPROC FramebufferRenderbuffer;
  PFNGLCHECKFRAMEBUFFERSTATUSPROC CheckFramebufferStatus;
  PFNGLBLITFRAMEBUFFERPROC BlitFramebuffer;
  PFNGLCLIPCONTROLPROC ClipControl;
};

OSMesaContext context() {
  static const OSMesaContext made = [] {
    const int wanted[] = {OSMESA_FORMAT,
                          OSMESA_BGRA,
                          OSMESA_DEPTH_BITS,
                          24,
                          OSMESA_PROFILE,
                          OSMESA_CORE_PROFILE,
                          OSMESA_CONTEXT_MAJOR_VERSION,
                          3,
                          OSMESA_CONTEXT_MINOR_VERSION,
                          3,
                          0,
                          0};
    const OSMesaContext result = OSMesaCreateContextAttribs(wanted, nullptr);
    if (result == nullptr) stop("no OpenGL 3.3 context");
    return result;
  }();
  return made;
}

const Gl& gl() {
  static const Gl functions(0);
  return functions;
}

constexpr char kVertexShader[] = R"(#version 330
in vec3 position, normal, colour;  // the colour is linear light already
uniform mat4 clip_from_world, world_from_mesh;
uniform vec3 key_direction, key_colour, fill_direction, fill_colour, ambient_sky, ambient_ground;
out vec3 level;
void main() {
  gl_Position = clip_from_world * (world_from_mesh * vec4(position, 1.0));
  vec3 n = normalize(mat3(world_from_mesh) * normal);
  vec3 light = mix(ambient_ground, ambient_sky, 0.5 * n.y + 0.5) + max(dot(n, key_direction), 0.0) * key_colour +
               max(dot(n, fill_direction), 0.0) * fill_colour;
  vec3 linear = clamp(light * colour, 0.0, 1.0);
  level = mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, greaterThan(linear, vec3(0.0031308)));
}
)";

constexpr char kFragmentShader[] = R"(#version 330
in vec3 level;
out vec4 pixel;
void main() { pixel = vec4(level, 1.0); }
)";

constexpr const char* kAttributes[] = {"position", "normal", "colour"};

unsigned compile(GLenum kind, const char* text) {
  const unsigned shader = gl().CreateShader(kind);
  gl().ShaderSource(shader, 1, &text, nullptr);
  gl().CompileShader(shader);
  int done = 0;
  gl().GetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done == 0) {
    char log[1000] = {};
    gl().GetShaderInfoLog(shader, sizeof log - 1, nullptr, log);
    stop(log);
  }
  return shader;
}

unsigned make_program() {
  const unsigned program = gl().CreateProgram();
  for (const unsigned shader :
       {compile(GL_VERTEX_SHADER, kVertexShader), compile(GL_FRAGMENT_SHADER, kFragmentShader)}) {
    gl().AttachShader(program, shader);
    gl().DeleteShader(shader);
  }
  for (unsigned i = 0; i < 3; ++i)
    gl().BindAttribLocation(program, i, kAttributes[i]);
  gl().LinkProgram(program);
  int done = 0;
  gl().GetProgramiv(program, GL_LINK_STATUS, &done);
  if (done == 0) stop("the shaders do not link");
  return program;
}

template <typename T>
void upload(GLenum target, unsigned buffer, const std::vector<T>& values) {
  gl().BindBuffer(target, buffer);
  gl().BufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
}

float linear_of(uint8_t level) {
  const float encoded = static_cast<float>(level) / 255.0F;
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

void set_direction(unsigned program, const char* name, const glm::vec3& towards) {
  const float length = std::sqrt(towards.x * towards.x + towards.y * towards.y + towards.z * towards.z);
  const float unit[3] = {towards.x / length, towards.y / length, towards.z / length};
  gl().Uniform3fv(gl().GetUniformLocation(program, name), 1, unit);
}

void set_colour(unsigned program, const char* name, const glm::vec3& colour) {
  gl().Uniform3fv(gl().GetUniformLocation(program, name), 1, &colour.x);
}

}  // namespace

GlScene::GlScene(const Scene& scene, int width, int height, int samples)
    : width_(width), height_(height), pixels_(raster::pixel_count(width, height)) {
  if (OSMesaMakeCurrent(context(), pixels_.data(), GL_UNSIGNED_BYTE, width, height) == 0) stop("no framebuffer");
  OSMesaPixelStore(OSMESA_Y_UP, 0);
  program_ = make_program();
  gl().UseProgram(program_);
  const raster::Camera camera = scene.camera_for(width, height);
  const glm::mat4 clip_from_world = camera.clip_from_view * camera.view_from_world;
  gl().UniformMatrix4fv(gl().GetUniformLocation(program_, "clip_from_world"), 1, GL_FALSE, &clip_from_world[0][0]);
  world_from_mesh_ = gl().GetUniformLocation(program_, "world_from_mesh");
  set_direction(program_, "key_direction", scene.lighting.key_direction);
  set_direction(program_, "fill_direction", scene.lighting.fill_direction);
  set_colour(program_, "key_colour", scene.lighting.key_colour);
  set_colour(program_, "fill_colour", scene.lighting.fill_colour);
  set_colour(program_, "ambient_sky", scene.lighting.ambient_sky);
  set_colour(program_, "ambient_ground", scene.lighting.ambient_ground);
  clear_[0] = static_cast<float>(raster::red_of(scene.background)) / 255.0F;
  clear_[1] = static_cast<float>(raster::green_of(scene.background)) / 255.0F;
  clear_[2] = static_cast<float>(raster::blue_of(scene.background)) / 255.0F;

  for (const SceneMesh& from : scene.meshes) {
    Mesh mesh;
    std::vector<glm::vec3> colours;
    colours.reserve(from.colours.size());
    for (const glm::u8vec4& colour : from.colours)
      colours.emplace_back(linear_of(colour.x), linear_of(colour.y), linear_of(colour.z));
    gl().GenVertexArrays(1, &mesh.array);
    gl().BindVertexArray(mesh.array);
    gl().GenBuffers(4, mesh.buffers);
    const std::vector<glm::vec3>* arrays[3] = {&from.positions, &from.normals, &colours};
    for (unsigned i = 0; i < 3; ++i) {
      upload(GL_ARRAY_BUFFER, mesh.buffers[i], *arrays[i]);
      gl().EnableVertexAttribArray(i);
      gl().VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    }
    upload(GL_ELEMENT_ARRAY_BUFFER, mesh.buffers[3], from.indices);
    mesh.indices = static_cast<int>(from.indices.size());
    std::memcpy(mesh.world_from_mesh[0], &from.world_from_mesh[0][0], sizeof mesh.world_from_mesh[0]);
    std::memcpy(mesh.world_from_mesh[1], &from.moved_world_from_mesh[0][0], sizeof mesh.world_from_mesh[1]);
    meshes_.push_back(mesh);
  }
  if (samples > 1) {
    gl().GenFramebuffers(1, &multisampled_);
    gl().BindFramebuffer(GL_FRAMEBUFFER, multisampled_);
    gl().GenRenderbuffers(2, surfaces_);
    const GLenum formats[2] = {GL_RGBA8, GL_DEPTH_COMPONENT24};
    const GLenum places[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    for (int i = 0; i < 2; ++i) {
      gl().BindRenderbuffer(GL_RENDERBUFFER, surfaces_[i]);
      gl().RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, formats[i], width, height);
      gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, surfaces_[i]);
    }
    if (gl().CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      stop("no framebuffer with " + std::to_string(samples) + " samples");
  }
  glViewport(0, 0, width, height);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  // Depth as the rasteriser has it: 1 is near, 0 is infinity.
  gl().ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glDepthFunc(GL_GREATER);
  glClearDepth(0.0);
}

GlScene::~GlScene() {
  for (Mesh& mesh : meshes_) {
    gl().DeleteVertexArrays(1, &mesh.array);
    gl().DeleteBuffers(4, mesh.buffers);
  }
  gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
  if (multisampled_ != 0) {
    gl().DeleteFramebuffers(1, &multisampled_);
    gl().DeleteRenderbuffers(2, surfaces_);
  }
  gl().UseProgram(0);
  gl().DeleteProgram(program_);
  glFinish();
}

void GlScene::draw(bool moved) {
  if (multisampled_ != 0) gl().BindFramebuffer(GL_FRAMEBUFFER, multisampled_);
  glClearColor(clear_[0], clear_[1], clear_[2], 0.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (const Mesh& mesh : meshes_) {
    gl().UniformMatrix4fv(world_from_mesh_, 1, GL_FALSE, mesh.world_from_mesh[moved ? 1 : 0]);
    gl().BindVertexArray(mesh.array);
    glDrawElements(GL_TRIANGLES, mesh.indices, GL_UNSIGNED_INT, nullptr);
  }
  if (multisampled_ != 0) {
    gl().BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl().BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
  }
  glFinish();
}

std::string GlScene::driver() {
  uint32_t pixel = 0;
  if (OSMesaMakeCurrent(context(), &pixel, GL_UNSIGNED_BYTE, 1, 1) == 0) stop("no framebuffer");
  std::string name;
  for (const GLenum part : {GLenum{GL_RENDERER}, GLenum{GL_VERSION}}) {
    const GLubyte* text = glGetString(part);
    if (!name.empty()) name += ", ";
    while (text != nullptr && *text != 0)
      name += static_cast<char>(*text++);
  }
  return name;
}

}  // namespace auslan::bench
