#include "ribbon/thesis/self_collision.h"

#include "ribbon/linear/index.h"
#include "ribbon/thesis/contact.h"
#include "ribbon/thesis/tangle.h"

namespace ribbon {
SelfCollision::SelfCollision(const ThesisDef& def, const Mesh& mesh)
    : def_(&def), mesh_(&mesh), broad_phase_(mesh, true), radii_(at(mesh.size()), def.radius), tangled_(at(mesh.w)) {
  broad_phase_.reserve(radii_.size());
}

int SelfCollision::begin_step(const ThesisPoints& points) {
  broad_phase_.begin();
  broad_phase_.update(points.positions, points.positions, radii_);
  return find_tangled_columns(*mesh_, points.positions, broad_phase_, tangled_);
}

int SelfCollision::collide(ThesisPoints& points) {
  std::vector<Vec2>& x = points.positions;
  broad_phase_.update(x, x, radii_);
  const auto is_tangled = [this](int point) { return tangled_[at(mesh_->column(point))] != 0; };
  const double max_push = max_push_in_radii * def_->radius;
  int contacts = 0;
  for (std::size_t p = 0; p < x.size(); ++p) {
    for (const int triangle : broad_phase_.near(p)) {
      if (broad_phase_.is_own(p, triangle)) continue;
      if (is_tangled(static_cast<int>(p)) && is_tangled(mesh_->triangles[at(triangle)].a)) continue;
      const Circle circle{x[p], points.substep_start[p], def_->radius, static_cast<int>(p)};
      const auto contact = find_contact(*mesh_, mesh_->triangles[at(triangle)], x, circle);
      if (!contact) continue;
      const double lambda = push_apart(*contact, points.inverse_mass[p], max_push, points.inverse_mass, x);
      x[p] += (lambda * points.inverse_mass[p]) * contact->direction;
      ++contacts;
    }
  }
  return contacts;
}

}  // namespace ribbon
