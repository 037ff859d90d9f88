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
inline constexpr int kTileWidthBits = 6, kTileHeightBits = 5;
inline constexpr int kTileWidth = 1 << kTileWidthBits, kTileHeight = 1 << kTileHeightBits;
/// Room round a tile in its buffers, where blocks that stick out write what nobody reads; in floats, on the left so
/// many that rows stay aligned.
inline constexpr int kTileMargin = 8;
inline constexpr int kTileStride = kTileWidth + 2 * kTileMargin;
inline constexpr int kTileRows = kTileHeight + 2;
/// Depth is bounded over squares of this many pixels (hierarchical depth).
inline constexpr int kCellSize = 8;
inline constexpr int kCellsAcross = kTileWidth / kCellSize;
inline constexpr int kCellsDown = kTileHeight / kCellSize;
inline constexpr int kCells = kCellsAcross * kCellsDown;

/// A triangle that spans less than this in x and in y takes the short path: its edge functions fit 32 bits wherever
/// they are asked for, differences of its coordinates 16.
inline constexpr int kSmallExtent = 120 * kSubPixels;

/// Where a vertex lies on the screen: whole sub-pixels from the top-left corner of the frame, y down. x is kOutside for
/// a vertex that has no place there (behind the near plane, beyond the guard band, not finite).
struct ScreenPoint {
  float x, y;
};
inline constexpr float kOutside = 1e30F;

/// What else the triangles of a vertex need.
struct ScreenValues {
  float depth;       ///< z / w, 0 (far) to 1 (near)
  float inverse_w;   ///< 1 / w
  int16_t level[4];  ///< lit blue, green, red: sRGB levels 0 to 255 in 1 / kLevelScale; the fourth is 0
};
inline constexpr int kLevelBits = 7;
/// Colours are interpolated in perspective where the affine short cut could be off by more levels than this.
inline constexpr float kAffineError = 0.25F;
inline constexpr float kLevelScale = 128.0F;

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
  float rim_direction[3], rim_colour[3];
  bool rim;                 ///< whether it gives any light
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
  ScreenPoint* points;  ///< of vertex 0
  ScreenValues* values;
};

/// What the triangle stage hands on.
enum class Route : uint32_t {
  kSmall,  ///< spans less than kSmallExtent, faces the eye, corners in the order of positive area
  kLarge,  ///< on the screen, still to be culled by its area
  kCut,    ///< a corner has no place on the screen
};
struct Survivor {
  uint32_t corner[3];  ///< numbers of screen vertices in the frame
  uint32_t triangle;   ///< its number in the mesh
  Route route;
  uint32_t tiles;  ///< kSmall: those that its box touches, as SmallTriangle::word has them
};

inline constexpr uint32_t kGouraudColour = 0x40000000U;
/// In a tile's list and in its colour buffer a word with the top bit set stands for a general triangle. In the buffer
/// it is a promise: the colour of that triangle at this pixel's centre, computed when the tile is finished, so that
/// what is painted over is never shaded.
inline constexpr uint32_t kGeneralTriangle = 0x80000000U;
inline constexpr uint32_t kBinShift = 22;                  ///< below it the place in the bin's list
inline constexpr uint32_t kScratchTriangle = 0xFFFFFFFFU;  ///< the tile's own

/// No colour of a triangle, and no promise: what a textured triangle is filled with before it gets its colours.
inline constexpr uint32_t kStandInColour = 0x01000000U;

/// A triangle of the short path.
struct SmallTriangle {
  uint32_t corner[3];  ///< numbers of screen vertices in the frame, in the order of positive area
  uint32_t word;       ///< 0x00RRGGBB, or kGouraudColour and in the bits below it tiles
};
/// Tiles of a small triangle: the number of the first one, how many columns follow it, how many rows.
inline constexpr uint32_t kTileBits = 17, kTileColumnBits = 2, kTileRowBits = 3;
inline constexpr uint32_t kTileMask = (1U << kTileBits) - 1U;
inline constexpr uint32_t kTileColumnMask = (1U << kTileColumnBits) - 1U;
static_assert(kSmallExtent / kSubPixels / kTileWidth + 1 <= 1 << kTileColumnBits);
static_assert(kSmallExtent / kSubPixels / kTileHeight + 1 < 1 << kTileRowBits);
static_assert((16384 / kTileWidth) * (16384 / kTileHeight) <= 1 << kTileBits);
static_assert(1U << (kTileBits + kTileColumnBits + kTileRowBits) <= kGouraudColour);

/// A tile's triangles, in drawing order. A list's tail points behind its last entry; where that is the end of a block,
/// and so a multiple of a block's size, or null, there is no room left.
struct alignas(256) EntryBlock {
  static constexpr size_t kCapacity = 56;
  EntryBlock* next;
  alignas(32) uint32_t entry[kCapacity];  ///< a place in the list's small triangles, or a general triangle's name
};
static_assert(sizeof(EntryBlock) == 256 && offsetof(EntryBlock, entry) + sizeof(EntryBlock::entry) == 256);

/// What the triangle stage asks for.
struct TriangleSink {
  /// Takes a triangle that the stage does not append to the lists by itself.
  void (*take)(void* context, const Survivor& survivor);
  /// A tile's list has no room left: gives it a block more and returns its new tail.
  uint32_t* (*extend)(void* context, size_t tile);
  void* context;
};

struct TriangleJob {
  const uint32_t* indices;
  size_t begin, end;  ///< triangles to do
  uint32_t first_vertex, vertex_count;
  const ScreenPoint* points;  ///< of the frame
  bool mirrored, two_sided;
  int width, height;
  int32_t reach;  ///< how far the farthest sample lies from its pixel's centre in x or y, sub-pixels
  int tiles_across;
  /// Small triangles go straight to `small`, from `first_small` on and with kGouraudColour, and to their tiles' lists;
  /// all others are handed over, in between and in order. Null: all are handed over. There must be room for eight more
  /// than there are triangles to do.
  SmallTriangle* small;
  uint32_t first_small;
  uint32_t** tails;
  TriangleSink sink;
};
/// Of a run of the stage.
struct TriangleCounts {
  size_t rejected = 0;
  uint32_t appended = 0;  ///< by the stage itself
  /// Bounds of the tiles of all small triangles that were not culled, and perhaps of some that were; none if first >
  /// last.
  uint32_t first_tile_column = 0xFFFF, last_tile_column = 0, first_tile_row = 0xFFFF, last_tile_row = 0;
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
  uint32_t texture;  ///< with kStandInColour: its place in the bin's textured triangles
  int32_t first_column, last_column, first_row, last_row;  ///< clipped to the frame, inclusive
};

struct TexturedTriangle;  // texture.h

/// Buffers of one worker for the tile in hand: [row][column][sample], kTileStride columns, the pointers at the first
/// pixel within the margin. A pixel's samples stand together, so that what a triangle leaves out costs nothing in units
/// of a pixel, not of a vector's pixels.
struct TileBuffers {
  uint32_t* colour;
  float* depth;
  float* cell_least;     ///< kCells lower bounds of depth
  float* cell_greatest;  ///< and upper bounds
  /// kCells words: one that names a general triangle says that all samples of the cell are its, and that the cell's own
  /// memory is out of date. 0: the cell is in memory.
  uint32_t* cell_owner;
  GeneralTriangle* scratch;  ///< one
  /// As `colour` and `depth`; null where no triangle of the frame is masked.
  uint32_t* kept_colour;
  float* kept_depth;
};

struct TileJob {
  int x, y;           ///< top-left pixel
  int width, height;  ///< of the part that lies in the frame
  uint32_t background;
  EntryBlock* const* lists;           ///< in drawing order; list_stride pointers from one to the next
  uint32_t* const* tails;             ///< of the lists
  const SmallTriangle* const* small;  ///< one array a list
  size_t list_stride, list_count;
  const ScreenPoint* points;
  const ScreenValues* values;
  const GeneralTriangle* const* general;    ///< one array a bin
  const TexturedTriangle* const* textured;  ///< one array a bin
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
/// A corner of a triangle that takes the long path.
struct Corner {
  float x, y, depth, inverse_w;
  float level[3];
  float coordinate[2];  ///< of a texture
};
Corner corner_of(const ScreenPoint& point, const ScreenValues& values) noexcept;
/// Set-up of the long path in double precision; corners in the order of positive area.
void set_up_general(const Corner& a, const Corner& b, const Corner& c, uint32_t colour, GeneralTriangle& out) noexcept;

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
