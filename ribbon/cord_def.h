#pragma once

#include <limits>
#include <vector>

#include "ribbon/definition.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// How time is integrated.
enum class Integrator : unsigned char {
  tr_bdf2,         ///< second order, L-stable (Hosea & Shampine 1996): two solves a substep
  implicit_euler,  ///< first order, one solve: cheap, and damps what moves
};

/// What accuracy may cost. `README.md` has the measured cost and error of the presets.
struct Accuracy {
  Integrator integrator = Integrator::tr_bdf2;  ///< second order, unless it is scenery
  int substeps = 1;        ///< a step, 1 … 4096: the error falls with their square, with implicit Euler in proportion
  int max_iterations = 8;  ///< full Newton steps a solve, 1 … 1000, before it starts again with a line search
  double tolerance = 5e-4;  ///< m, 1e-12 … 1: a Newton step that moves no point further is the last
  /// Work of a step, 1 … 1,000,000, in units of 4 a point and body that are solved together (CordReport::work): about
  /// as many linear systems. When it is spent the state at hand is kept, whole but not solved, and the report says so.
  /// With 10,000 and more, what does not converge near contacts is taken by halves first: exact at any violence, and
  /// slow.
  int max_work = 600;

  /// For scenery: implicit Euler, a centimetre. Contacts of all cords with implicit Euler are twenty times softer,
  /// which in a heap takes a third of the solves: what lies there sinks by a hundredth of its fall in a step, not a
  /// 2000th.
  static Accuracy fast() { return {Integrator::implicit_euler, 1, 8, 1e-2}; }
  /// For what players hang on: TR-BDF2, half a millimetre. The default.
  static Accuracy balanced() { return {}; }
  /// Four substeps of TR-BDF2, a tenth of a millimetre.
  static Accuracy accurate() { return {Integrator::tr_bdf2, 4, 12, 1e-4}; }
  bool operator==(const Accuracy&) const = default;
};

/// What a cord of two rows and more is made of inside.
enum class Elements : unsigned char {
  cells,  ///< co-rotated incompatible-mode quadrilaterals: bending as declared, whatever the stretch stiffness
  bars,   ///< the thesis's: a bar from each point to its up to eight neighbours
};

/// What a cord is made of. Every term that stays at 0 or false is neither assembled nor allocated.
struct CordDef {
  int points = 51;               ///< along the cord, 2 … 1,000,000 / rows
  int rows = 1;                  ///< across it, 1 … 64: 1 is a rope, more a ribbon that shears and squashes
  double length = 10.0;          ///< m, at rest, 1e-6 … 1e6, in equal links
  double width = 0.0;            ///< m, between the outer rows at rest, 1e-6 … 1e6; a rope has none: 0
  double radius = 0.01;          ///< m, 0 … 1e6: half the thickness that is drawn and collides around the points
  double mass_per_length = 0.1;  ///< kg/m, of all rows together, 1e-12 … 1e12

  /// EA [N]: tension a unit of strain, 1e-6 … 1e18. Infinity, the default: it does not stretch (a rope only).
  double stretch_stiffness = std::numeric_limits<double>::infinity();
  /// EI [N·m²]: moment a unit of curvature, 0 … 1e18, independent of EA. Cells of three rows and more need one, at
  /// most EA·width²/12, that of a solid; see `solid`.
  double bending_stiffness = 0.0;
  double poisson_ratio = 0.0;  ///< of cells, −0.9 … 0.9: how much a stretched ribbon narrows
  /// Of cells, 0 … 1e3, as a multiple of their own modulus: resistance of corners squashed below a fifth of their area,
  /// and of cells turned inside out. 1 is right where a ribbon may be crushed.
  double area_stiffness = 0.0;
  double damping = 0.0;       ///< s, 0 … 1e3: damping forces are this times the rate of the elastic ones
  double drag = 0.0;          ///< 1/s, 0 … 1e6, rate at which the cord's own motion dies away
  bool tension_only = false;  ///< a rope whose links pull and never push
  double friction = 0.0;      ///< μ of its surface, 0 … 10; with another's √(μ₁·μ₂) holds, as in Box2D
  double restitution = 0.0;   ///< 0 … 1; with another's the greater holds, as in Box2D
  bool self_contact = false;  ///< it does not pass through itself
  bool cord_contact = false;  ///< nor through others that declare it too
  /// It sleeps, as bodies of Box2D do and with those that are near it, once all of them have moved by less than 1 cm/s
  /// for half a second: it stays as it is, and steps cost next to nothing, until it is disturbed. What it gives up is
  /// the rest of its way to where it would come to rest.
  bool allow_sleep = false;
  Elements elements = Elements::cells;  ///< of two rows and more
  Accuracy accuracy;                    ///< what exactness may cost

  /// Initial positions, points·rows of them, P(i, j) at i·rows + j; empty lays the cord out from the origin along +x.
  std::vector<Vec2> positions;
  /// Points constrained to where they start, by index.
  std::vector<int> pins;

  bool operator==(const CordDef&) const = default;
};

/// Throws DefinitionError at the first field that is out of its range, or that the other fields exclude.
void check(const CordDef& def);
/// The same of an accuracy alone.
void check(const Accuracy& accuracy);
/// Of the fields, `points` and `rows` alone.
void check_size(const CordDef& def);

/// Stiffnesses of a ribbon; `apply_to` sets them in a definition.
struct RibbonMaterial {
  double stretch_stiffness;  ///< EA, N
  double bending_stiffness;  ///< EI, N·m²
  double poisson_ratio;      ///< how much it narrows as it is stretched, −0.9 … 0.9

  /// Sets the three in a definition, and nothing else.
  void apply_to(CordDef& def) const;
};

/// A solid strip of Young's modulus E [Pa], Poisson ratio ν and thickness (out of the plane) t [m]: EA = E·t·width,
/// EI = E·t·width³/12. Throws DefinitionError unless E and t are 1e-12 … 1e18 and width is above 0.
RibbonMaterial solid(double youngs_modulus, double poisson_ratio, double thickness, double width);

/// The same strip by its plane stiffnesses against shear, μ, and change of area, μ + λ [N/m, 1e-12 … 1e18]:
/// E·t = 4·μ(μ + λ)/(2μ + λ), ν = λ/(2μ + λ).
RibbonMaterial solid_of_shear_and_area(double shear, double area, double width);

}  // namespace ribbon
