#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "ribbon/cord_def.h"
#include "ribbon/study/conditions.h"

namespace study {

/// The solver settings of a level's cords: the parameters of a sweep.
struct Setting {
  std::string solver = "direct";       ///< or thesis, box2d_chain, box2d_max_distance (tests/study/chain_mover.h)
  std::string integrator = "tr_bdf2";  ///< or implicit_euler; for the direct solver; own: each cord as in the level
  int substeps = 1;
  double tolerance = 5e-4;  ///< m, for the direct solver
  double points = 1.0;      ///< relative to the number of links of the level's cords
  int iterations = 0;  ///< greatest number of Newton iterations per solve (0: 8); for chains, of velocity iterations
                       ///< per substep, with 3/8 as many position iterations
  int rows = 1;        ///< of the ribbon that replaces each rope
  int max_work = 0;    ///< Accuracy::max_work; 0: that of the level, or the default

  bool operator==(const Setting&) const = default;
};

/// The parameters that determine the converged motion.
struct Mesh {
  double points = 1.0;
  int rows = 1;

  bool operator==(const Mesh&) const = default;
  bool operator<(const Mesh& other) const { return std::pair(points, rows) < std::pair(other.points, other.rows); }
};

Mesh mesh_of(const Setting& setting);

/// A setting for all cords of a level, and in its place others for some.
struct CordSettings {
  // NOLINTNEXTLINE(google-explicit-constructor): one setting for all is the usual case
  CordSettings(Setting all = {}) : common(std::move(all)) {}

  Setting common;                ///< of thrown lines too
  std::map<int, Setting> own{};  ///< by id of the cord's object in the map
};

/// Returns the name: tr_bdf2 substeps=1 tolerance=0.0005 points=x2
std::string name_of(const Setting& setting);

/// Returns the accuracy of the direct solver.
ribbon::Accuracy accuracy_of(const Setting& setting);

/// Returns the setting that leaves the level as it is.
Setting present();
bool is_present(const Setting& setting);

/// Returns whether chains of Box2D's joints replace the cords.
bool is_box2d(const Setting& setting);

/// Returns the grid: both integrators, 1 … 8 substeps, three tolerances; few and many iterations; half and twice the
/// points; two and three rows; the thesis's method; Box2D's chains. `quick`: the presets, and one step from each, for
/// the level's own points.
/// Both begin with the present setting.
std::vector<Setting> grid(bool quick);

/// Returns the settings of the quick grid for a level's own cords, but the present one.
std::vector<Setting> own_settings();

using ribbon::study::unlimited_work;

/// The budget of work of what is recommended for an error. A tick that spends its budget may be off by centimetres. The
/// default one suffices in nearly all ticks, and where it does, this one changes nothing.
inline constexpr int ample_work = 20'000;
/// Returns a setting of the direct solver with that budget; others, the present one, and one that has a budget, as they
/// are.
Setting with_ample_work(Setting setting);

/// Returns the setting of the converged motion of a mesh: 64 or 128 substeps solved to 1e-7 m; half as many for
/// `quick` and for ribbons; with unlimited_work.
Setting reference(const Mesh& mesh, bool second, bool quick);

/// Returns the moderate setting whose runs show how sensitive the motion is: 4 substeps solved to 1e-5 m, with
/// unlimited_work.
Setting probe(const Mesh& mesh);

}  // namespace study
