// SPDX-License-Identifier: Apache-2.0
// Triangles with a texture in one tile. Each is filled as if it had one colour, kStandInColour, by the path that it
// would take without a texture, so that coverage and depth are the same; then that colour is replaced where it shows.
// What the filter does is defined in raster/texture.h.
#pragma once

#include "fill_general.h"
#include "fill_samples.h"
#include "fill_small.h"
#include "set_up.h"
#include "texture.h"
#include "vertex_stage.h"

namespace auslan::raster {

/// The same lanes under another name: with a second caller the short path would no longer be inlined where all other
/// triangles take it.
template <class L>
struct LanesApart : L {};

template <class L, size_t kSamples>
struct FillTextured {
  using F = typename L::F;
  using I = typename L::I;
  static constexpr size_t kRowWords = size_t{kTileStride} * kSamples;
  static constexpr int32_t kOne = 1 << kFilterBits;

  // Pixels of the tile, in whole eights across; `last` ones included.
  struct Region {
    int32_t first_column, first_row, last_column, last_row;
  };

  static F held(F value, float least, float greatest) { return L::min(L::max(value, L::set(least)), L::set(greatest)); }

  // Two texels of each lane's row, weighted: 15-bit numbers, a channel each.
  static void mix_pairs(const TextureLevels& texture, I left, I right, I weights, I (&out)[4]) {
    alignas(32) uint32_t number[2][8];
    L::store(number[0], left);
    L::store(number[1], right);
    F word[2][kTexelWords];
    for (size_t i = 0; i < 2; ++i)
      L::gather_pairs(texture.texels, number[i], kTexelWords, word[i][0], word[i][1]);
    for (size_t i = 0; i < kTexelWords; ++i) {
      const I a = L::bits(word[0][i]);
      const I b = L::bits(word[1][i]);
      const I high = L::template shift_right<16>(b);
      out[2 * i] = whole(L::dot(L::pair(a, b), weights));
      out[2 * i + 1] = whole(L::dot(L::pair(L::template shift_right<16>(a), high), weights));
    }
  }
  static I whole(I sum) { return L::template shift_right<kFilterBits>(sum + L::set(kOne / 2)); }
  static I weights_of(I fraction) { return L::pair(L::set(kOne) - fraction, fraction); }

  // The two texels along one axis that a coordinate lies between, and how far from the first one.
  struct Neighbours {
    I first, second, weights;
  };
  static Neighbours neighbours(const TexturedTriangle& t, size_t axis, F coordinate, F size) {
    const F one = L::set(1.0F);
    F inside;
    if (t.repeats[axis] || t.mirrors[axis]) {
      const F period = L::set(t.mirrors[axis] ? 0.5F : 1.0F);
      const F scaled = coordinate * period;
      const F cut = L::to_float(L::truncate(scaled));
      inside = scaled - L::select(L::greater(cut, scaled), cut - one, cut);  // 0 to 1
      if (t.mirrors[axis]) {
        const F twice = inside + inside;
        inside = L::min(twice, L::set(2.0F) - twice);
      }
    } else {
      inside = held(coordinate, 0.0F, 1.0F);
    }
    const I place = L::round((inside * size) * L::set(static_cast<float>(kOne))) - L::set(kOne / 2);
    const I last = L::truncate(size) - L::set(1);
    Neighbours n;
    n.first = L::template shift_right<kFilterBits>(place);
    n.second = n.first + L::set(1);
    n.weights = weights_of(place & L::set(kOne - 1));
    if (t.repeats[axis]) {
      n.first = L::select(L::sign_mask(n.first), last, n.first);
      n.second = L::and_not(L::greater(n.second, last), n.second);
    } else {
      n.first = L::max(n.first, L::set(0));
      n.second = L::min(n.second, last);
    }
    return n;
  }

  // Bilinear, each lane of a level of its own: 15-bit numbers.
  static void filter(const TexturedTriangle& t, I level, F u, F v, I (&out)[4]) {
    alignas(32) uint32_t number[8];
    L::store(number, level);
    F width, height, first_texel, unused;
    L::gather_quads(&t.texture.level->width, number, sizeof(TextureLevel) / sizeof(float), width, height, first_texel,
                    unused);
    const Neighbours x = neighbours(t, 0, u, width);
    const Neighbours y = neighbours(t, 1, v, height);
    const I stride = L::truncate(width);
    const I upper = L::bits(first_texel) + L::dot(y.first, stride);
    const I lower = L::bits(first_texel) + L::dot(y.second, stride);
    I above[4], below[4];
    mix_pairs(t.texture, upper + x.first, upper + x.second, x.weights, above);
    mix_pairs(t.texture, lower + x.first, lower + x.second, x.weights, below);
    for (size_t c = 0; c < 4; ++c)
      out[c] = whole(L::dot(L::pair(above[c], below[c]), y.weights));
  }

  // Eight pixels of a triangle from one on.
  struct Pixels {
    F dx;
    float dy;
    F inverse, u, v;  ///< `inverse` of 1/w

    Pixels(const GeneralTriangle& shape, const TexturedTriangle& t, int32_t column, int32_t row)
        : dx(FillGeneral<L, kSamples>::eight_from(column, shape.x[0])),
          dy(FillGeneral<L, kSamples>::centre_from(row, shape.y[0])) {
      const Plane& w = shape.inverse_w;
      // The bound holds where 1/w is no normal number or 0.
      inverse = L::min(L::set(1.0F) / held(at(w), w.least, w.greatest), L::set(1e18F));
      u = divided(t.coordinate[0], t.least[0], t.greatest[0]);
      v = divided(t.coordinate[1], t.least[1], t.greatest[1]);
    }
    F at(const Plane& plane) const { return L::set(plane.origin + dy * plane.per_y) + dx * L::set(plane.per_x); }
    F divided(const Plane& plane, float least, float greatest) const {
      return held(held(at(plane), plane.least, plane.greatest) * inverse, least, greatest);
    }
  };

  // The level of detail, with kFilterBits fraction bits.
  static I level_of(const Plane& w, const TexturedTriangle& t, const Pixels& pixels) {
    const TextureLevel& whole_picture = t.texture.level[0];
    const auto derivative = [&](float of_coordinate, F coordinate, float of_w, float size) {
      return ((L::set(of_coordinate) - coordinate * L::set(of_w)) * pixels.inverse) *
             L::set(size * static_cast<float>(kSubPixels));
    };
    const Plane& u = t.coordinate[0];
    const Plane& v = t.coordinate[1];
    const F ux = derivative(u.per_x, pixels.u, w.per_x, whole_picture.width);
    const F vx = derivative(v.per_x, pixels.v, w.per_x, whole_picture.height);
    const F uy = derivative(u.per_y, pixels.u, w.per_y, whole_picture.width);
    const F vy = derivative(v.per_y, pixels.v, w.per_y, whole_picture.height);
    const F square = L::max(ux * ux + vx * vx, uy * uy + vy * vy);
    // A float's bits are its logarithm with straight lines in between; half of it for the root.
    constexpr int kMantissaBits = 23;
    const I twice = L::bits(square) - L::set(int32_t{0x3F800000});
    const I level = L::template shift_right<kMantissaBits + 1 - kFilterBits>(twice);
    return L::min(L::max(level, L::set(0)), L::set((t.texture.count - 1) << kFilterBits));
  }

  /// Eight pixels, 0x00RRGGBB; `drawn`: a mask of those that the cut-off leaves.
  static I shade(const GeneralTriangle& shape, const TexturedTriangle& t, int32_t column, int32_t row, I& drawn) {
    const Pixels pixels(shape, t, column, row);
    const I level = level_of(shape.inverse_w, t, pixels);
    const I fine = L::template shift_right<kFilterBits>(level);
    const I fraction = level & L::set(kOne - 1);
    I texel[4];
    filter(t, fine, pixels.u, pixels.v, texel);
    I coarser[4] = {texel[0], texel[1], texel[2], texel[3]};
    if (L::signs(L::greater(fraction, L::set(0))) != 0U)
      filter(t, L::min(fine + L::set(1), L::set(t.texture.count - 1)), pixels.u, pixels.v, coarser);
    const I weights = weights_of(fraction);
    for (size_t c = 0; c < 4; ++c)
      texel[c] = L::dot(L::pair(texel[c], coarser[c]), weights);
    drawn = L::greater(texel[3], L::set(t.cutoff - 1));
    I channel[3];
    for (size_t c = 0; c < 3; ++c) {
      const F level_here = pixels.divided(shape.level[c], shape.least[c], shape.greatest[c]);
      const F light = VertexStage<L>::decode(level_here * L::set(1.0F / 255.0F));
      const F surface = L::to_float(texel[c]) * L::set(1.0F / static_cast<float>(kTexelScale * kOne));
      channel[c] = L::truncate(VertexStage<L>::encode(light * surface) + L::set(0.5F));
    }
    return L::template shift_left<16>(channel[0]) | L::template shift_left<8>(channel[1]) | channel[2];
  }

  static size_t place(int32_t row, int32_t column) {
    return static_cast<size_t>(row) * kRowWords + static_cast<size_t>(column) * kSamples;
  }

  // What a masked triangle may have to give back.
  static void keep(const TileBuffers& buffers, const Region& region) {
    for (int32_t row = region.first_row; row <= region.last_row; ++row) {
      const size_t end = place(row, region.last_column + 1);
      for (size_t here = place(row, region.first_column); here < end; here += 8) {
        L::store(buffers.kept_colour + here, L::load(buffers.colour + here));
        L::store(buffers.kept_depth + here, L::load(buffers.depth + here));
      }
    }
  }

  // Colours in the place of the one that stands for them.
  static void colour(const TileJob& job, const GeneralTriangle& shape, const TexturedTriangle& t,
                     const Region& region) {
    const TileBuffers& buffers = job.buffers;
    const I stand_in = L::set(static_cast<int32_t>(kStandInColour));
    for (int32_t row = region.first_row; row <= region.last_row; ++row) {
      for (int32_t column = region.first_column; column <= region.last_column; column += 8) {
        I pixels[kSamples]{};
        I drawn[kSamples]{};
        bool shaded = false;
        for (size_t v = 0; v < kSamples; ++v) {
          const size_t here = place(row, column) + 8 * v;
          const I old = L::load(buffers.colour + here);
          const I mine = L::equal(old, stand_in);
          if (L::signs(mine) == 0U) continue;
          if (!shaded) {
            I drawn_pixels;
            const I colours = shade(shape, t, job.x + column, job.y + row, drawn_pixels);
            Resolve<L, kSamples>::expand(colours, pixels);
            Resolve<L, kSamples>::expand(drawn_pixels, drawn);
          }
          shaded = true;
          L::store(buffers.colour + here, L::select(mine, pixels[v], old));
          if (t.cutoff == 0) continue;
          const I back = L::and_not(drawn[v], mine);
          if (L::signs(back) == 0U) continue;
          L::store(buffers.colour + here,
                   L::select(back, L::load(buffers.kept_colour + here), L::load(buffers.colour + here)));
          L::store(buffers.depth + here,
                   L::select(back, L::load(buffers.kept_depth + here), L::load(buffers.depth + here)));
        }
      }
    }
  }

  static Region region_of(const TileJob& job, const GeneralTriangle& t) {
    Region r{};
    r.first_column = (t.first_column > job.x ? t.first_column - job.x : 0) & ~7;
    r.first_row = t.first_row > job.y ? t.first_row - job.y : 0;
    r.last_column = t.last_column - job.x < job.width - 1 ? t.last_column - job.x : job.width - 1;
    r.last_row = t.last_row - job.y < job.height - 1 ? t.last_row - job.y : job.height - 1;
    return r;
  }

  // Fills by the short path; false where it must be the long one.
  static bool fill_small(const TileJob& job, const TexturedTriangle& t) {
    if (!t.small) return false;
    const SmallTriangle small{{t.corner[0], t.corner[1], t.corner[2]}, kStandInColour};
    static constexpr uint32_t kAlone[8] = {};
    SmallGroup<kSamples> group;
    if ((SetUp<LanesApart<L>, kSamples>::run(job, &small, kAlone, group) & 1U) != 0U) return false;
    if constexpr (kSamples == 1) {
      FillSmall<LanesApart<L>>::run(job.buffers, group, 0);
    } else {
      FillSamples<LanesApart<L>, kSamples>::run(job.buffers, group, 0);
    }
    return true;
  }

  static void copy_cells(const float* from, float* to) {
    for (size_t i = 0; i < kCells; i += 8)
      L::store(to + i, L::load(from + i));
  }

  /// `tile_depth`: a lower bound of the tile's depth, kept up; `owned`: whether cells may have owners.
  [[gnu::noinline]] static void run(const TileJob& job, const GeneralTriangle& shape, const TexturedTriangle& t,
                                    float& tile_depth, bool& owned) {
    // As before small triangles; what is kept must be up to date too.
    if (owned) FillGeneral<L, kSamples>::release_all(job);
    owned = false;
    for (size_t i = 0; i < kCells; i += 8)
      L::store(job.buffers.cell_greatest + i, L::set(2.0F));
    const Region region = region_of(job, shape);
    if (t.cutoff > 0) keep(job.buffers, region);
    if (fill_small(job, t)) return colour(job, shape, t, region);
    // Depths that a masked triangle gives back may lie below what its cells are promised to hold.
    float least[kCells];
    copy_cells(job.buffers.cell_least, least);
    float depth_of_tile = tile_depth;
    FillGeneral<L, kSamples>::run(job, shape, kScratchTriangle, depth_of_tile);
    colour(job, shape, t, region);
    if (t.cutoff > 0) return copy_cells(least, job.buffers.cell_least);
    tile_depth = depth_of_tile;
  }
};

}  // namespace auslan::raster
