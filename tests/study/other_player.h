#pragma once

#include "tests/study/level_study.h"

namespace study {

/// Another player of a level, as one of StudyOptions::others: judges settings by what its cords do with its inputs.
class OtherPlayer {
 public:
  /// Runs the converged motion, from the start and in windows. Stores a reference to the file.
  OtherPlayer(const LevelFile& file, Inputs inputs, const StudyOptions& options);
  OtherPlayer(const OtherPlayer&) = delete;
  OtherPlayer& operator=(const OtherPlayer&) = delete;

  /// Makes the results of settings of the level's own points worse, if they are so with this player.
  void judge(const CordSettings& settings, WithOthers& results) const;

 private:
  const LevelFile* file_;
  const game::Level level_;
  const Inputs inputs_;
  const Windows windows_;
  Trace converged_;
  Reference about_;
};

}  // namespace study
