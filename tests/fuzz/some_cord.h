#pragma once

#include "ribbon/cord_def.h"
#include "ribbon/thesis/thesis_def.h"
#include "tests/fuzz/bytes.h"

namespace fuzz {

/// Small cords of all kinds, made of a fuzzer's bytes; about half of them cannot be built.
ribbon::CordDef some_cord(Bytes& bytes);
/// A rope as a game has it, which can be built and is solved in microseconds.
ribbon::CordDef some_mild_cord(Bytes& bytes);
ribbon::ThesisDef some_thesis_cord(Bytes& bytes);
ribbon::Accuracy some_accuracy(Bytes& bytes);

}  // namespace fuzz
