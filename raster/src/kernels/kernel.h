// SPDX-License-Identifier: Apache-2.0
// What passes between the renderer and a kernel: the three stages that run once a vertex, once a triangle and once a
// pixel, compiled once for each instruction set from the same templates. Plain data and nothing but <cstdint> and
// <cstddef>, because a kernel's file is compiled for instructions that the rest of the program may not have: whatever
// inline function it shared with the rest could end up in both.
#pragma once

#include <cstddef>
#include <cstdint>

namespace auslan::raster {

inline constexpr int kSubPixelBits = 8;
inline constexpr int kSubPixels = 1 << kSubPixelBits;

/// Tiles of the frame: filled one after the other, each by one thread.
inline constexpr int kTileSize = 64;
/// Room in a tile's buffers for blocks that stick out on the right and at the bottom, where nothing is read.
inline constexpr int kTileStride = kTileSize + 8;
inline constexpr int kTileRows = kTileSize + 1;
/// Depth is bounded below over squares of this many pixels (hierarchical depth).
inline constexpr int kCellSize = 8;
inline constexpr int kCellsAcross = kTileSize / kCellSize;
inline constexpr int kCells = kCellsAcross * kCellsAcross;

/// A triangle that spans less than this in x and in y takes the short path: its edge functions fit 32 bits wherever
/// they are asked for, differences of its coordinates 16.
inline constexpr int kSmallExtent = 32 * kSubPixels;

/// A projected vertex. x and y: whole sub-pixels from the top-left corner of the frame, y down; kOutside marks a vertex
/// that has no place on the screen (behind the near plane, beyond the guard band, not finite).
struct ScreenVertex {
  float x, y;
  float depth;      ///< z / w, 0 (far) to 1 (near)
  float inverse_w;  ///< 1 / w
  float level[3];   ///< lit red, green, blue: sRGB levels 0 to 255, not rounded
  float unused;
};
inline constexpr float kOutside = 1e30F;

/// The mapping from clip space to sub-pixels.
struct Viewport {
  int width, height;
  float half_x, half_y;    ///< half the width and height in sub-pixels
  float guard_x, guard_y;  ///< |x| <= guard_x * w is inside the guard band; powers of two, so the product is exact
};
/// Vertices lie at most this far from the centre of the frame, in sub-pixels (guard band; a few more by rounding):
/// every difference of coordinates stays below 2^24, exact in a float.
inline constexpr float kGuardBand = 4194304.0F;

/// Unit directions and colours in linear light; nothing negative or not finite.
struct PreparedLights {
  float key_direction[3], key_colour[3];
  float fill_direction[3], fill_colour[3];
  float ambient_middle[3];  ///< received by a surface that faces the horizon
  float ambient_swing[3];   ///< added times the normal's y
};

/// Where a mesh goes: clip = clip_from_mesh * (position, 1), world normal = normal_from_mesh * normal at any length.
struct Placement {
  float clip_from_mesh[4][4];    ///< [row][column]
  float normal_from_mesh[3][3];  ///< [row][column]
  bool mirrored;
};

struct VertexJob {
  const float* positions;  ///< x y z, x y z, ...
  const float* normals;    ///< as positions; null: no levels are wanted
  const uint8_t* colours;  ///< red green blue alpha, ...
  size_t begin, end;       ///< vertices to do; begin is a multiple of 8
  const Placement* placement;
  const PreparedLights* lights;
  const Viewport* viewport;
  ScreenVertex* out;  ///< of vertex 0
};

/// What the triangle stage hands on.
enum class Route : uint32_t {
  kSmall,  ///< spans less than kSmallExtent, faces the eye, corners in the order of positive area
  kLarge,  ///< on the screen, still to be culled by its area
  kCut,    ///< a corner has no place on the screen
};
struct Survivor {
  uint32_t corner[3];  ///< numbers of screen vertices in the frame
  Route route;
  uint32_t triangle;  ///< its number in the mesh
  /// kSmall and kLarge: the pixels that can have a sample inside, not clipped to the frame; inclusive.
  int32_t first_column, last_column, first_row, last_row;
};

struct TriangleJob {
  const uint32_t* indices;
  size_t begin, end;  ///< triangles to do
  uint32_t first_vertex, vertex_count;
  const ScreenVertex* vertices;  ///< of the frame
  bool mirrored, two_sided;
  int width, height;
  int32_t reach;  ///< how far the farthest sample lies from its pixel's centre in x or y, sub-pixels
  Survivor* out;  ///< room for end - begin
};
struct TriangleCounts {
  size_t survivors, rejected;
};

/// A quantity that is linear over the screen: at a point (dx, dy) sub-pixels from the triangle's first corner it is
/// (origin + dy * per_y) + dx * per_x, held within [least, greatest], the range of the three corners. Exact arithmetic
/// would never leave that range inside the triangle; rounding on a sliver does, and so does a pixel centre beside it.
struct Plane {
  float origin, per_x, per_y, least, greatest;
};

/// A triangle that takes the long path: large, cut, or seen in a perspective that its colours must follow.
struct GeneralTriangle {
  int32_t x[3], y[3];  ///< corners in the order of positive area, sub-pixels
  Plane depth;
  Plane level[3];   ///< divided by inverse_w in perspective
  Plane inverse_w;  ///< relative to the nearest corner
  float least[3], greatest[3];
  uint32_t colour;  ///< flat colour, or kGouraudColour
  bool perspective;
  int32_t first_column, last_column, first_row, last_row;  ///< clipped to the frame, inclusive
};

inline constexpr uint32_t kGouraudColour = 0x80000000U;
inline constexpr uint32_t kGeneralEntry = 0x80000001U;
/// One triangle in one tile's list.
struct Entry {
  uint32_t corner[3];  ///< kGeneralEntry: corner[0] is the worker and corner[1] the place in that worker's list
  uint32_t colour;     ///< 0x00RRGGBB, or kGouraudColour, or kGeneralEntry
};
struct EntryBlock {
  static constexpr uint32_t kCapacity = 15;
  EntryBlock* next;
  uint32_t count;
  Entry entry[kCapacity];
};

/// In a tile's colour buffer a word with the top bit set is a promise: the colour of that general triangle at this
/// pixel's centre, computed when the tile is finished, so that what is painted over is never shaded.
inline constexpr uint32_t kDeferred = 0x80000000U;
inline constexpr uint32_t kDeferredWorkerShift = 26;
inline constexpr uint32_t kDeferredHere = 0xFFFFFFFFU;  ///< the tile's own scratch triangle

/// Buffers of one worker for the tile in hand: [row][sample][column], kTileStride columns.
struct TileBuffers {
  uint32_t* colour;
  float* depth;
  float* cell_depth;         ///< kCells lower bounds of depth
  GeneralTriangle* scratch;  ///< one
};

struct TileJob {
  int x, y;           ///< top-left pixel
  int width, height;  ///< of the part that lies in the frame
  uint32_t background;
  EntryBlock* const* lists;  ///< one list a chunk, in drawing order; stride in pointers
  size_t list_stride, list_count;
  const ScreenVertex* vertices;
  const GeneralTriangle* const* general;  ///< one array a worker
  TileBuffers buffers;
  uint32_t* pixels;  ///< of the tile's top-left pixel
  size_t pixel_stride;
};

/// One instruction set's stages.
struct KernelTable {
  void (*vertices)(const VertexJob&);
  TriangleCounts (*triangles)(const TriangleJob&);
  void (*tile[4])(const TileJob&);  ///< for 1, 2, 4, 8 samples
};

extern const KernelTable kScalarKernel;
#if defined(__x86_64__)
extern const KernelTable kSse2Kernel;
extern const KernelTable kAvx2Kernel;
#elif defined(__aarch64__)
extern const KernelTable kNeonKernel;
#endif

/// Baseline functions that kernels call for rare cases.
/// Unit world normal of a mesh normal that is too short or too long to be squared in a float. False if it is not
/// finite.
bool odd_world_normal(const Placement& placement, const float normal[3], float out[3]) noexcept;
/// Set-up of the long path in double precision; corners in the order of positive area.
void set_up_general(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, uint32_t colour,
                    GeneralTriangle& out) noexcept;

/// Direct3D 11's standard sample patterns, sub-pixels from the pixel's centre, y down.
template <size_t kSamples>
struct SamplePattern;
template <>
struct SamplePattern<1> {
  static constexpr int32_t kX[1] = {0}, kY[1] = {0};
  static constexpr int32_t kReach = 0;
};
template <>
struct SamplePattern<2> {
  static constexpr int32_t kX[2] = {64, -64}, kY[2] = {64, -64};
  static constexpr int32_t kReach = 64;
};
template <>
struct SamplePattern<4> {
  static constexpr int32_t kX[4] = {-32, 96, -96, 32}, kY[4] = {-96, -32, 32, 96};
  static constexpr int32_t kReach = 96;
};
template <>
struct SamplePattern<8> {
  static constexpr int32_t kX[8] = {16, -16, 80, -48, -80, -112, 48, 112};
  static constexpr int32_t kY[8] = {-48, 48, 16, -80, 80, -16, 112, -112};
  static constexpr int32_t kReach = 112;
};

}  // namespace auslan::raster
