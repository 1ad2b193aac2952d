#pragma once

#include <array>
#include <ostream>
#include <string_view>

#include "ribbon/thesis/thesis_cord.h"

namespace test_support {

constexpr double frame_dt = 1.0 / 60.0;            // s
constexpr ribbon::Vec2 earth_gravity{0.0, -9.81};  // m/s²

/// A row of Goto 2017, Table 4.3.
struct ThesisCondition {
  std::string_view name;
  int w;
  int h;
  double printed_k;  ///< spring coefficient
  int substeps;      ///< iterations
};

constexpr std::array<ThesisCondition, 4> thesis_conditions = {{
    {"thesis_a", 25, 2, 0.45, 8},
    {"thesis_b", 10, 5, 0.45, 8},
    {"thesis_c", 35, 2, 0.45, 8},
    {"thesis_d", 35, 2, 0.45, 4},
}};

void PrintTo(const ThesisCondition& condition, std::ostream* out);  // for GoogleTest

/// The condition in SI units: spacing 5 cm, 2 g per point, self-collision on. The stiffness is that of the printed
/// coefficient k at 8 substeps, Ks = κm/(2δ²) with κ = k/(1 − k), for any number of substeps of the run.
ribbon::ThesisDef thesis_def(const ThesisCondition& condition);

/// The same, pinned by its first column and hanging straight down.
ribbon::ThesisDef hanging(const ThesisCondition& condition);

double kinetic_energy(const ribbon::ThesisCord& cord);   ///< J
int inverted_triangles(const ribbon::ThesisCord& cord);  ///< those with a negative signed area
double length_ratio(const ribbon::ThesisCord& cord);     ///< middle line's length / its rest length
double worst_stretch(const ribbon::ThesisCord& cord);    ///< largest |length/rest − 1| of a connection
bool all_finite(const ribbon::ThesisCord& cord);
ribbon::Vec2 centre_of_mass(const ribbon::ThesisCord& cord);  ///< m
ribbon::Vec2 momentum(const ribbon::ThesisCord& cord);        ///< kg·m/s
double fastest(const ribbon::ThesisCord& cord);               ///< m/s

}  // namespace test_support
