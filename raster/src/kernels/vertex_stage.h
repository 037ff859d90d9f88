// SPDX-License-Identifier: Apache-2.0
// Once a vertex: to clip space, to the screen, and its light (Lambert's law, in linear light).
#pragma once

#include "kernel.h"
#include "srgb_curve.h"

namespace auslan::raster {

template <class L>
struct VertexStage {
  using F = typename L::F;
  using I = typename L::I;

  static F row(const float (&m)[4], F x, F y, F z) {
    return ((L::set(m[0]) * x + L::set(m[1]) * y) + L::set(m[2]) * z) + L::set(m[3]);
  }
  static F dot(const float (&a)[3], F x, F y, F z) { return (L::set(a[0]) * x + L::set(a[1]) * y) + L::set(a[2]) * z; }

  // Linear light of eight colours' channel.
  static F albedo(I colours, int channel) {
    I code = colours;
    if (channel == 1) code = L::template shift_right<8>(code);
    if (channel == 2) code = L::template shift_right<16>(code);
    return decode(L::to_float(code & L::set(int32_t{255})) * L::set(1.0F / 255.0F));
  }

  // Linear light of sRGB levels / 255.
  static F decode(F s) {
    const F power = decode_srgb_power(s, [](float c) { return L::set(c); });
    return L::select(L::greater(s, L::set(kSrgbLinearEnd)), power, s * L::set(1.0F / kSrgbLinearSlope));
  }

  static F encode(F light) {
    const F clamped = L::min(L::max(light, L::set(0.0F)), L::set(1.0F));
    const F power = encode_srgb_power(L::sqrt(L::sqrt(clamped)), [](float c) { return L::set(c); });
    const F level =
        L::select(L::greater(clamped, L::set(kSrgbLinearEndLight)), power, clamped * L::set(255.0F * kSrgbLinearSlope));
    return L::min(level, L::set(255.0F));
  }

  // Unit normals in the world. Where one is too short or too long to be squared the mesh's own numbers are needed.
  static void world_normals(const VertexJob& job, const float* normals, F& x, F& y, F& z, I& good) {
    F nx, ny, nz;
    L::load_triples(normals, nx, ny, nz);
    const auto& m = job.placement->normal_from_mesh;
    x = dot(m[0], nx, ny, nz);
    y = dot(m[1], nx, ny, nz);
    z = dot(m[2], nx, ny, nz);
    const F square = (x * x + y * y) + z * z;
    const uint32_t usual = L::signs(L::greater(square, L::set(1e-30F)) & L::greater(L::set(1e30F), square));
    const F length = L::sqrt(square);
    const F scale = L::set(1.0F) / length;
    x = x * scale;
    y = y * scale;
    z = z * scale;
    if (usual != 0xFFU) odd_normals(job, normals, usual, x, y, z, good);
  }

  static void odd_normals(const VertexJob& job, const float* normals, uint32_t usual, F& x, F& y, F& z, I& good) {
    float lanes[3][8];
    int32_t mask[8];
    L::store(lanes[0], x);
    L::store(lanes[1], y);
    L::store(lanes[2], z);
    L::store(mask, good);
    for (size_t i = 0; i < 8; ++i) {
      if ((usual >> i & 1U) != 0U) continue;
      float world[3];
      if (!odd_world_normal(*job.placement, normals + 3 * i, world)) mask[i] = 0;
      for (size_t axis = 0; axis < 3; ++axis)
        lanes[axis][i] = world[axis];
    }
    x = L::load(lanes[0]);
    y = L::load(lanes[1]);
    z = L::load(lanes[2]);
    good = L::load(mask);
  }

  static void eight(const VertexJob& job, const float* positions, const float* normals, const uint32_t* colours,
                    ScreenPoint* points, ScreenValues* values) {
    const Viewport& view = *job.viewport;
    F px, py, pz;
    L::load_triples(positions, px, py, pz);
    const auto& m = job.placement->clip_from_mesh;
    const F x = row(m[0], px, py, pz);
    const F y = row(m[1], px, py, pz);
    const F z = row(m[2], px, py, pz);
    const F w = row(m[3], px, py, pz);

    // Inside the near, far and guard planes. Every comparison with what is not a number fails, and an infinity cannot
    // satisfy both sides: guard bands that overflow are refused by the last line.
    const F zero = L::set(0.0F);
    const F guard_x = L::set(view.guard_x) * w;
    const F guard_y = L::set(view.guard_y) * w;
    I good = L::at_least(w, z) & L::at_least(z, zero) & L::greater(w, zero);
    good = good & L::at_least(guard_x, x) & L::at_least(x + guard_x, zero);
    good = good & L::at_least(guard_y, y) & L::at_least(y + guard_y, zero);
    const F largest = L::set(3e38F);
    good = good & L::greater(largest, guard_x) & L::greater(largest, guard_y);

    const F inverse_w = L::set(1.0F) / w;
    good = good & L::greater(largest, inverse_w);
    const F from_centre_x = (x * inverse_w) * L::set(view.half_x);
    const F from_centre_y = (y * inverse_w) * L::set(view.half_y);
    const F depth = z * inverse_w;
    // Rounding may carry a number past the bounds that its plane set; infinities end here too.
    const F limit = L::set(kGuardBand + 256.0F);
    good = good & L::at_least(limit, from_centre_x) & L::at_least(from_centre_x + limit, zero);
    good = good & L::at_least(limit, from_centre_y) & L::at_least(from_centre_y + limit, zero);
    good = good & L::at_least(L::set(2.0F), depth);
    // Adding 1.5 * 2^23 leaves no bits below 1, so the sum is rounded to nearest even by the addition itself.
    const F rounder = L::set(12582912.0F);
    const F screen_x = ((from_centre_x + rounder) - rounder) + L::set(view.half_x);
    const F screen_y = ((rounder - from_centre_y) - rounder) + L::set(view.half_y);

    I level[3] = {L::set(0), L::set(0), L::set(0)};
    if (normals != nullptr) {
      F nx, ny, nz;
      world_normals(job, normals, nx, ny, nz, good);
      const PreparedLights& lights = *job.lights;
      const F key = L::max(dot(lights.key_direction, nx, ny, nz), zero);
      const F fill = L::max(dot(lights.fill_direction, nx, ny, nz), zero);
      F rim = zero;
      if (lights.rim) rim = L::max(dot(lights.rim_direction, nx, ny, nz), zero);
      const I colour = L::load(colours);
      for (int c = 0; c < 3; ++c) {
        const F ambient = L::set(lights.ambient_middle[c]) + ny * L::set(lights.ambient_swing[c]);
        F light = (ambient + key * L::set(lights.key_colour[c])) + fill * L::set(lights.fill_colour[c]);
        if (lights.rim) light = light + rim * L::set(lights.rim_colour[c]);
        level[c] = L::round(encode(light * albedo(colour, c)) * L::set(kLevelScale));
      }
    }
    L::scatter_pairs(&points->x, L::select(good, screen_x, L::set(kOutside)), screen_y);
    L::scatter_quads(&values->depth, depth, inverse_w, L::from_bits(L::pair(level[2], level[1])),
                     L::from_bits(level[0]));
  }

  static uint32_t word(const uint8_t* bytes) {
    return uint32_t{bytes[0]} | uint32_t{bytes[1]} << 8U | uint32_t{bytes[2]} << 16U;
  }

  // `count` vertices from `first` on, in whole eights, through buffers where they do not fill one.
  static void rest(const VertexJob& job, size_t first, size_t count) {
    float positions[24] = {};
    float normals[24] = {};
    uint32_t colours[8] = {};
    ScreenPoint points[8];
    ScreenValues values[8];
    for (size_t i = 0; i < 3 * count; ++i) {
      positions[i] = job.positions[3 * first + i];
      normals[i] = job.normals != nullptr ? job.normals[3 * first + i] : 0.0F;
    }
    for (size_t i = 0; i < count; ++i)
      colours[i] = word(job.colours + 4 * (first + i));
    eight(job, positions, job.normals != nullptr ? normals : nullptr, colours, points, values);
    for (size_t i = 0; i < count; ++i) {
      job.points[first + i] = points[i];
      job.values[first + i] = values[i];
    }
  }

  static void run(const VertexJob& job) {
    size_t i = job.begin;
    for (; i + 8 <= job.end; i += 8) {
      uint32_t colours[8];
      __builtin_memcpy(colours, job.colours + 4 * i, sizeof colours);
      if constexpr (__BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__) {
        for (size_t k = 0; k < 8; ++k)
          colours[k] = word(job.colours + 4 * (i + k));
      }
      eight(job, job.positions + 3 * i, job.normals != nullptr ? job.normals + 3 * i : nullptr, colours, job.points + i,
            job.values + i);
    }
    if (i < job.end) rest(job, i, job.end - i);
  }
};

}  // namespace auslan::raster
