#include "tests/fuzz/arbitrary_cord.h"

namespace fuzz {
namespace {

/// Sets a field in three of four cases.
void may_be(Bytes& bytes, double& field, double low, double high) {
  if (bytes.below(4) != 0) field = bytes.number(low, high);
}

/// Returns the number of points; 0 for an invalid cord.
int count(int points, int rows) { return points > 0 && points < 100 && rows > 0 && rows < 100 ? points * rows : 0; }

/// Returns no positions (a straight cord), or random ones.
std::vector<ribbon::Vec2> arbitrary_positions(Bytes& bytes, int points) {
  std::vector<ribbon::Vec2> positions;
  const int choice = bytes.below(8);
  if (choice < 4) return positions;
  for (int k = 0; k < points; ++k) {
    positions.push_back(choice < 7 ? bytes.vector(-1.0, 1.0) : bytes.vector(-1e9, 1e9));
  }
  return positions;
}

std::vector<int> arbitrary_pins(Bytes& bytes, int points) {
  std::vector<int> pins;
  if (points == 0) return pins;
  for (int k = bytes.below(4); k > 0; --k) pins.push_back(bytes.integer(0, points - 1));
  return pins;
}

}  // namespace

ribbon::Accuracy arbitrary_accuracy(Bytes& bytes) {
  ribbon::Accuracy accuracy;
  if (bytes.boolean()) accuracy.integrator = ribbon::Integrator::implicit_euler;
  accuracy.substeps = bytes.integer(1, 3);
  accuracy.max_iterations = bytes.integer(1, 12);
  accuracy.tolerance = bytes.number(1e-12, 1.0);
  accuracy.soft_contacts = accuracy.integrator == ribbon::Integrator::implicit_euler;
  if (bytes.boolean()) accuracy.max_work = bytes.integer(1, 1000);
  return accuracy;
}

ribbon::CordDef arbitrary_cord(Bytes& bytes) {
  ribbon::CordDef def;
  def.points = bytes.integer(2, 8);
  def.rows = bytes.boolean() ? 1 : bytes.integer(1, 3);
  def.length = bytes.number(1e-3, 1e3);
  if (def.rows > 1) def.width = bytes.number(1e-3, 10.0);
  may_be(bytes, def.radius, 0.0, 0.1);
  def.mass_per_length = bytes.number(1e-3, 1e3);
  if (def.rows > 1 || bytes.boolean()) def.stretch_stiffness = bytes.number(1e-3, 1e12);
  if (bytes.boolean()) {
    def.bending_stiffness = bytes.number(1e-6, 1e3);
    // The bending stiffness that more than two rows accept.
    if (bytes.boolean()) def.bending_stiffness = 1e-4 * def.stretch_stiffness * def.width * def.width;
  }
  if (bytes.boolean()) {
    may_be(bytes, def.poisson_ratio, -0.9, 0.9);
    may_be(bytes, def.area_stiffness, 0.0, 10.0);
  }
  may_be(bytes, def.damping, 0.0, 1.0);
  may_be(bytes, def.drag, 0.0, 10.0);
  may_be(bytes, def.friction, 0.0, 10.0);
  may_be(bytes, def.restitution, 0.0, 1.0);
  const int flags = bytes.byte();
  def.tension_only = (flags & 1) != 0;
  def.self_contact = (flags & 2) != 0;
  def.cord_contact = (flags & 4) != 0;
  if ((flags & 24) == 24) def.elements = ribbon::Elements::bars;
  if ((flags & 24) == 8) {  // without a byte of its own, so that older inputs keep their meaning
    def.drag_across = 1.2;
    def.drag_along = 0.01;
    def.displaced_area = 3e-4;
  }
  def.allow_sleep = (flags & 64) != 0;
  if ((flags & 128) != 0) def.gravity_scale = bytes.number(-1e3, 1e3);
  if ((flags & 32) != 0) def.accuracy = arbitrary_accuracy(bytes);
  def.positions = arbitrary_positions(bytes, count(def.points, def.rows));
  def.pins = arbitrary_pins(bytes, count(def.points, def.rows));
  if (def.rows == 2) may_be(bytes, def.cell_stiffness, 0.0, 1e3);
  return def;
}

ribbon::CordDef arbitrary_mild_cord(Bytes& bytes) {
  const auto share = [&bytes] { return bytes.byte() / 255.0; };
  ribbon::CordDef def;
  def.points = 2 + bytes.below(4);
  def.length = 1.0 + share();
  def.radius = 0.05 * share();
  def.mass_per_length = 0.1 + share();
  def.friction = share();
  def.cord_contact = bytes.boolean();
  def.tension_only = bytes.boolean();
  if (bytes.boolean()) def.stretch_stiffness = 1e3;
  def.accuracy = ribbon::Accuracy::fast();
  if (bytes.boolean()) def.pins = {0};
  return def;
}

ribbon::ThesisDef arbitrary_thesis_cord(Bytes& bytes) {
  ribbon::ThesisDef def;
  def.w = bytes.integer(2, 6);
  def.h = bytes.integer(2, 3);
  def.spacing = bytes.number(1e-3, 1.0);
  may_be(bytes, def.point_mass, 1e-6, 1e3);
  may_be(bytes, def.spring_stiffness, 0.0, 1e6);
  may_be(bytes, def.bar_damping, 0.0, 1e4);
  may_be(bytes, def.drag, 0.0, 10.0);
  may_be(bytes, def.area_stiffness, 0.0, 1.0);
  may_be(bytes, def.area_floor, 0.0, 0.9);
  def.self_collision = bytes.boolean();
  if (bytes.boolean()) def.radius = bytes.number(0.0, 0.5 * def.spacing);
  def.substeps = bytes.integer(1, 3);
  def.positions = arbitrary_positions(bytes, count(def.w, def.h));
  def.pins = arbitrary_pins(bytes, count(def.w, def.h));
  return def;
}

}  // namespace fuzz
