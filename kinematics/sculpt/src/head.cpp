// SPDX-License-Identifier: Apache-2.0
// The field of the head, and how its parts become one mesh.
#include "head.h"

#include "layout.h"

namespace auslan::sculpt {

HeadSpace head_space(const Measurements& table) {
  HeadSpace space;
  space.stretch = Vec3(table.head_breadth / 151.0, table.eye_to_vertex / 111.0, table.head_length / 195.0);
  space.stretch_down = table.face_height / 118.0;
  space.eye_x = 0.5 * table.interpupillary / space.stretch.x;
  return space;
}

Vec3 place(const HeadSpace& space, const Vec3& point) {
  const double up = point.y > 0.0 ? space.stretch.y : space.stretch_down;
  return {point.x * space.stretch.x, kEyeLevel + point.y * up, point.z * space.stretch.z};
}

Field head_field(const HeadSpace& space) {
  const double eye_x = space.eye_x;
  return [eye_x](const Vec3& p) {
    const Vec3 q(p.x < 0.0 ? -p.x : p.x, p.y, p.z);
    // Skull, forehead, the mass of the face, jaw and chin.
    double d = ellipsoid(p, Vec3(0.0, 26.0, -3.0), Vec3(75.0, 85.0, 94.0));
    d = join(d, ellipsoid(p, Vec3(0.0, 36.0, 36.0), Vec3(58.0, 46.0, 52.0)), 16.0);
    d = join(d, ellipsoid(p, Vec3(0.0, -38.0, 36.0), Vec3(58.0, 64.0, 50.0)), 22.0);
    d = join(d, round_cone(q, Vec3(47.0, -60.0, 14.0), 13.0, Vec3(15.0, -95.0, 66.0), 13.0), 20.0);
    d = join(d, ellipsoid(p, Vec3(0.0, -97.0, 74.0), Vec3(17.0, 14.0, 17.0)), 14.0);
    d = join(d, ellipsoid(q, Vec3(45.0, -22.0, 55.0), Vec3(20.0, 13.0, 19.0)), 18.0);
    // Eye sockets under the brow's ridge, then the lids over the eyeballs.
    d = join(d, round_cone(q, Vec3(0.0, 15.0, 82.0), 9.0, Vec3(38.0, 18.0, 68.0), 9.0), 14.0);
    d = carve(d, ellipsoid(q, Vec3(eye_x - 1.5, -1.0, 95.0), Vec3(17.5, 11.5, 19.0)), 10.0);
    d = join(d, ball(q, Vec3(eye_x, 0.0, kEyeZ), kLidRadius), 3.5);
    // Muzzle, lips, the groove under them.
    d = join(d, ellipsoid(p, Vec3(0.0, -67.0, 72.0), Vec3(33.0, 24.0, 23.0)), 14.0);
    d = join(d, ellipsoid(q, Vec3(7.0, -64.4, 90.0), Vec3(17.0, 4.4, 7.5)), 3.5);
    d = join(d, ellipsoid(p, Vec3(0.0, -72.4, 89.5), Vec3(19.0, 5.4, 8.0)), 3.5);
    d = carve(d, ellipsoid(p, Vec3(0.0, -84.0, 101.0), Vec3(20.0, 4.0, 9.0)), 8.0);
    // Nose: bridge, tip, wings, and the dents of the nostrils.
    d = join(d, round_cone(p, Vec3(0.0, 6.0, 82.0), 6.5, Vec3(0.0, -33.0, 101.0), 8.5), 9.0);
    d = join(d, ball(p, Vec3(0.0, -35.5, 104.5), 9.6), 5.0);
    d = join(d, ellipsoid(q, Vec3(11.5, -39.5, 93.0), Vec3(7.0, 6.8, 10.0)), 5.0);
    d = carve(d, ellipsoid(q, Vec3(6.6, -46.5, 99.0), Vec3(3.6, 3.4, 5.0)), 2.5);
    return d;
  };
}

Mesh sculpt_head(const Measurements& table) {
  const HeadSpace space = head_space(table);
  Shape shape;
  append_skin(shape, space, table);
  append_eyes(shape, space, table);
  append_brows(shape, space, table);
  append_ears(shape, space, table);
  append_hair(shape, space, table);
  append_mouth_parts(shape);

  Shape placed = shape;
  for (Vertex& v : placed.vertices)
    v.point = place(space, v.point);
  Mesh mesh = finish(placed);
  for (int channel = 0; channel < kFaceChannelCount; ++channel) {
    Morph morph;
    morph.channel = static_cast<FaceChannel>(channel);
    const std::vector<Vec3> displacement = channel_displacement(shape, space, morph.channel);
    for (size_t i = 0; i < shape.vertices.size(); ++i) {
      if (length(displacement[i]) < 0.05) continue;
      const Vec3& from = shape.vertices[i].point;
      morph.vertices.push_back(static_cast<uint32_t>(i));
      morph.displacement.emplace_back((place(space, from + displacement[i]) - place(space, from)) * 0.001);
    }
    mesh.morphs.push_back(std::move(morph));
  }
  return mesh;
}

}  // namespace auslan::sculpt
