#pragma once

#include "ribbon/cord_forces.h"
#include "ribbon/island/integrators.h"
#include "ribbon/island/restitution.h"
#include "ribbon/island/rollback.h"
#include "ribbon/island/step_context.h"

namespace ribbon {

/// The step that always ends: implicit Euler with contacts that are linearised once. It is taken in pieces. Where the
/// free motion would take something into something, a piece ends, and a very short one takes the impact, in which
/// nothing moves far. A piece that is not solved, or in which something was stopped, is redone by half. After a number
/// of pieces, or of linear systems, the rest of the step is taken as it comes; before it the last piece, if nothing was
/// stopped in it and little is left unsolved.
class LinearisedStep {
 public:
  void resize(std::size_t slots, std::size_t tensions) { rollback_.resize(slots, tensions); }
  /// Takes the step. If `may_truncate`, a last piece that is not solved and would leave a cord hanging is taken with a
  /// truncated solve.
  void take(const StepContext& context, Restitution& restitution, bool may_truncate);
  /// Takes the step in one piece, whose solve is truncated. Returns false, at the start of the step, if a matrix is not
  /// definite.
  bool take_truncated(const StepContext& context, Restitution& restitution);

 private:
  /// How a piece ended.
  struct Piece {
    bool solved;
    LinearisedResult result;
    CordEnergy before;
    bool truncated;
  };
  double next_piece(const StepContext& context, double time, double left);
  Piece take_piece(const StepContext& context, double time, double dt, ContactSolve solve) const;
  static bool is_lost(const IslandState& state, const Piece& piece);
  Piece retake_truncated(const StepContext& context, double time, double dt) const;
  void end_piece(const StepContext& context, const Piece& piece, double dt, Restitution& restitution);
  bool take_back(const StepContext& context, const Piece& piece, double dt, Restitution& restitution);

  Rollback rollback_;
  bool is_impact_ = false;       // this piece takes an impact
  bool impact_is_due_ = false;   // the next one does
  bool was_pushed_ = false;      // something changed the energy in the step by an amount that is not known
  double contact_energy_ = 0.0;  // J, at the stiffness of the piece before
};

}  // namespace ribbon
