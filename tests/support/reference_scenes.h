#pragma once

#include <array>

#include "ribbon/cord.h"

namespace test_support {

/// For cords at rest, where only the solution matters.
inline ribbon::Accuracy tight() { return {ribbon::Integrator::tr_bdf2, 1, 12, 1e-11}; }
/// Lets a cord come to rest, by steps of a second, which an L-stable method damps strongly.
void come_to_rest(ribbon::Cord& cord, ribbon::Vec2 gravity, int steps = 3000);

// --- catenary: a cord between two pins at equal heights

/// A continuous catenary, by elliptic integrals and root finding.
struct Catenary {
  double slackness;  ///< rest length L / span D
  double give;       ///< weight / EA; 0 does not stretch
  double sag;        ///< / D
  double tension;    ///< at the pins, / weight
};

/// Sags from the references; an elastic one's tension is √(H² + (weight / 2)²) of its H.
constexpr std::array<Catenary, 7> catenaries = {{
    {1.05, 0.0, 0.139304207, 1.00851794},
    {1.25, 0.0, 0.331796886, 0.60363939},
    {1.5, 0.0, 0.502633262, 0.54057982},
    {2.0, 0.0, 0.796388356, 0.51301429},
    {1.5, 0.01, 0.505865839, 0.54002752},
    {1.0, 0.1, 0.172776504, 0.86004046},
    {0.9, 0.1, 0.092918075, 1.42289841},
}};

/// Sag / D and tension / weight of a cord, or of the exact solution for its points.
struct HangingShape {
  double sag;
  double tension;
};

ribbon::CordDef hanging_between_pins(const Catenary& catenary, int links);
/// Returns the shape of a cord at rest. The tension is the force of the pin: that of its link plus the weight of half a
/// link.
HangingShape shape_of(const ribbon::Cord& cord);
/// Returns the shape of massless links between equal weights: the tangents of the angles grow evenly, tan θ_i = V_i /
/// H.
HangingShape lumped_shape(const Catenary& catenary, int links);

// --- cantilever: clamped at one end, a load across it at the other, no gravity

struct Cantilever {
  double load;    ///< P·L² / EI
  double down;    ///< of the tip, / L
  double inward;  ///< / L
};

constexpr std::array<Cantilever, 5> cantilevers = {{
    {0.2, 0.0663645, 0.0026465},
    {1.0, 0.3017208, 0.0564332},
    {2.0, 0.4934575, 0.1606417},
    {5.0, 0.7137915, 0.3876284},
    {10.0, 0.8106090, 0.5549956},
}};

/// L = 1 m and EI = 1 N·m². A rope (one row) is held by its first two points, so the clamp is in the middle of its
/// first link and L is counted from there, which is where x is 0. A ribbon is held by its first column; it is `width`
/// wide and as stiff as a solid.
ribbon::Cord clamped_beam(int columns, int rows, double width, const Cantilever& cantilever,
                          const ribbon::Accuracy& accuracy);
/// Returns `inward` and `down` of the tip, at the middle of the last column, at rest.
Cantilever bent(const ribbon::Cord& cord, double load);

// --- hanging_modes: the small swings of ten equal masses on a massless chain of 1 m

constexpr int hanging_masses = 10;
/// ω·√(L/g): ω² is g/l times the roots of the Laguerre polynomial of degree 10.
constexpr std::array<double, 3> hanging_frequencies = {1.173855, 2.700842, 4.252462};

/// A chain at rest, displaced by a tenth of a millimetre in a mode (0, 1, 2).
ribbon::Cord swung_chain(int mode, const ribbon::Accuracy& accuracy);
/// Returns ω·√(L/g) of its swing, measured over `periods` between zeros, in steps of dt; 0 if it does not swing.
double measured_frequency(ribbon::Cord& chain, int mode, int periods, double dt);

// --- free_flight: a cord thrown so that every point has a velocity of its own

/// A cord whose points have different velocities up to `speed` m/s, and a heavy point in the middle.
ribbon::Cord thrown(const ribbon::CordDef& def, double speed, double heavy_mass);
ribbon::Vec2 momentum(const ribbon::Cord& cord);  ///< kg·m/s

}  // namespace test_support
