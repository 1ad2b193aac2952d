#pragma once

#include <limits>
#include <vector>

#include "ribbon/definition.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// Time integration method.
enum class Integrator : unsigned char {
  tr_bdf2,         ///< second order, L-stable (Hosea & Shampine 1996); two solves per substep
  implicit_euler,  ///< first order; one solve per substep; cheap, but damps motion
};

/// Sets the trade between accuracy and cost. Relative to `balanced`, a swing costs 0.46 with `fast` and 3 with
/// `accurate`; ribbon/guide.md has a table, "Which preset".
struct Accuracy {
  Integrator integrator = Integrator::tr_bdf2;  ///< time integration method
  int substeps =
      1;  ///< per step, 1 … 4096. The error of TR-BDF2 falls with their square, that of implicit Euler linearly
  /// Newton steps without line search, 1 … 1000, of a solve without contacts. If it has not converged by then, it
  /// starts again with a line search. Near contacts the number is fixed.
  int max_iterations = 8;
  double tolerance = 5e-4;  ///< m, 1e-12 … 1. A solve ends when a Newton step moves no point further than this
  /// Limit of the work of a step, 1 … 1,000,000: about this many linear systems of a single cord, or
  /// 4·max_work·(points + bodies of the island) in the unit of IslandReport::work; with S > 4 substeps, S/4 times that.
  /// A step that has used it keeps the state that it has reached, which is finite but not solved, and counts as
  /// unconverged. Below 10,000, a step near contacts that does not converge is redone with a linear model of its
  /// contacts: quick, but less accurate. From 10,000 on it is halved repeatedly: accurate in any collision, but a step
  /// can take seconds. (Eight or more cords with soft_contacts that lie in a heap always have the linear model.)
  int max_work = 600;
  /// Makes contacts 20 times softer. This saves two thirds of the solves where many cords lie in a heap. At rest a body
  /// penetrates by 1/100 of the distance that it would fall in one step, instead of 1/2000. It has an effect if all
  /// cords that are solved together have set it.
  bool soft_contacts = false;

  /// For scenery: implicit Euler with a tolerance of 1 cm and soft contacts. Eight or more such cords that touch each
  /// other get one substep, whatever `substeps` is, and at most eight linear systems, unless one is singular. What
  /// these leave counts as unconverged.
  static Accuracy fast() { return {Integrator::implicit_euler, 1, 8, 1e-2, 600, true}; }
  /// The default, for cords that carry a player: TR-BDF2 with a tolerance of 0.5 mm.
  static Accuracy balanced() { return {}; }
  /// Four substeps of TR-BDF2 with a tolerance of 0.1 mm.
  static Accuracy accurate() { return {Integrator::tr_bdf2, 4, 12, 1e-4}; }
  bool operator==(const Accuracy&) const = default;
};

/// The elements of a ribbon, which is a cord with two or more rows.
enum class Elements : unsigned char {
  cells,  ///< quadrilaterals between the points (co-rotated finite elements with incompatible modes); the bending
          ///< stiffness does not depend on the stretch stiffness
  bars,   ///< the elements of the thesis: a bar from each point to each of its up to eight neighbours
};

/// Defines a cord. A term that stays at 0 or false is neither assembled nor allocated.
struct CordDef {
  int points = 51;               ///< number of points along the cord, 2 … 1,000,000 / rows
  int rows = 1;                  ///< number of points across the cord, 1 … 64: 1 makes a rope, more make a ribbon
  double length = 10.0;          ///< m, rest length, 1e-6 … 1e6, divided into equal links
  double width = 0.0;            ///< m, rest distance between the outer rows, 1e-6 … 1e6; 0 for a rope
  double radius = 0.01;          ///< m, half the thickness, for drawing and for contact, 0 … 1e6
  double mass_per_length = 0.1;  ///< kg/m, all rows together, 1e-12 … 1e12

  /// EA [N]: tension per unit of strain, 1e-6 … 1e18. Infinity, the default, makes a rope inextensible; a ribbon needs
  /// a finite value.
  double stretch_stiffness = std::numeric_limits<double>::infinity();
  /// EI [N·m²]: moment per unit of curvature, 0 … 1e18, independent of EA. A ribbon of cells with three or more rows
  /// needs a value above 0 and at most EA·width²/12, the stiffness of a solid strip; see `solid`.
  double bending_stiffness = 0.0;
  /// Of a ribbon of two rows: the part of EA that its cells provide [N], 1e-12·EA … EA. Bars along the middle line
  /// provide the rest. The smaller it is, the less the ribbon resists shear. 0, the default, means all of EA. A cut
  /// along a row sets it for pieces of two rows, so that their cells stay as they were.
  double cell_stiffness = 0.0;
  double poisson_ratio = 0.0;  ///< of cells, −0.9 … 0.9: lateral contraction when stretched
  /// Resistance of cells to collapse and inversion, 0 … 1e3, as a multiple of their modulus. It acts on corners that
  /// are compressed below a fifth of their area. Use 1 where a ribbon may be crushed.
  double area_stiffness = 0.0;
  double damping = 0.0;        ///< s, 0 … 1e3: damping force = damping · rate of change of the elastic force
  double drag = 0.0;           ///< 1/s, 0 … 1e6: decay rate of the cord's velocity, not of attached masses
  double gravity_scale = 1.0;  ///< factor of gravity for the cord and attached masses, −1e3 … 1e3
  /// Coefficient C of the drag across the cord in a Medium, 0 … 1e3: the force per length is ½·ρ·C·d·|v|·v, with the
  /// component v of the velocity relative to the medium, and the diameter d = 2·radius, of a ribbon width + 2·radius.
  /// About 1.2 for a round rope.
  double drag_across = 0.0;
  /// The same along the cord, as friction on all of its surface: ½·ρ·C·π·d·|v|·v. About 0.01 for a rope. `drag` is
  /// another term, which knows no medium.
  double drag_along = 0.0;
  /// m², 0 … 1e12: cross-section that displaces a Medium, which gives buoyancy; π·radius² for a solid round rope.
  double displaced_area = 0.0;
  bool tension_only = false;  ///< of a rope: links resist tension but not compression
  /// N, above 0: tension (tension_of) above which a link breaks; a ribbon breaks across. Infinity, the default,
  /// makes the cord unbreakable. The cord itself only reports an overloaded link (overloaded_link); a coupling cuts it
  /// there.
  double breaking_force = std::numeric_limits<double>::infinity();
  double friction = 0.0;      ///< coefficient μ, 0 … 10; two surfaces combine to √(μ₁·μ₂), as in Box2D
  double restitution = 0.0;   ///< coefficient, 0 … 1; two surfaces combine to the larger one, as in Box2D
  bool self_contact = false;  ///< the cord collides with itself
  bool cord_contact = false;  ///< the cord collides with other cords that declare this too
  /// Allows the cord to sleep. It falls asleep, together with the bodies near it, when all of them have moved slower
  /// than 1 cm/s for half a second. A sleeping cord does not move and costs next to nothing until something disturbs
  /// it. The error is the remaining distance to its equilibrium.
  bool allow_sleep = false;
  Elements elements = Elements::cells;  ///< of a ribbon
  Accuracy accuracy;                    ///< trade between accuracy and cost

  /// m, each component within ±1e9: initial positions of points·rows points; P(i, j) is at index i·rows + j. If empty,
  /// the cord starts at the origin and extends along +x.
  std::vector<Vec2> positions;
  /// Indices, 0 … points·rows − 1, of points that are fixed at their initial positions.
  std::vector<int> pins;

  bool operator==(const CordDef&) const = default;
};

/// Throws DefinitionError for the first field that is out of range or contradicts another field.
void check(const CordDef& def);
/// Returns whether a Medium acts on a cord with this definition: it declares drag_across, drag_along or displaced_area.
bool feels_medium(const CordDef& def);
/// Checks an accuracy in the same way.
void check(const Accuracy& accuracy);
/// Checks only the fields `points` and `rows`.
void check_size(const CordDef& def);

/// Stiffnesses of a ribbon.
struct RibbonMaterial {
  double stretch_stiffness;  ///< EA, N
  double bending_stiffness;  ///< EI, N·m²
  double poisson_ratio;      ///< lateral contraction when stretched, −0.9 … 0.9

  /// Sets these three fields of a definition.
  void apply_to(CordDef& def) const;
};

/// Returns the stiffnesses of a solid strip with Young's modulus E [Pa], Poisson ratio ν, out-of-plane thickness t [m]
/// and width [m]: EA = E·t·width, EI = E·t·width³/12. Throws DefinitionError unless E and t are in 1e-12 … 1e18 and
/// width is positive.
RibbonMaterial solid(double youngs_modulus, double poisson_ratio, double thickness, double width);

/// Returns the stiffnesses of a solid strip from its plane stiffnesses [N/m, 1e-12 … 1e18] against shear, μ, and
/// against change of area, μ + λ: E·t = 4·μ(μ + λ)/(2μ + λ), ν = λ/(2μ + λ).
RibbonMaterial solid_of_shear_and_area(double shear, double area, double width);

}  // namespace ribbon
