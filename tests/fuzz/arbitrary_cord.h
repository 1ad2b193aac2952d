#pragma once

#include "ribbon/cord_def.h"
#include "ribbon/thesis/thesis_def.h"
#include "tests/fuzz/bytes.h"

namespace fuzz {

/// Returns a small cord of any kind from a fuzzer's bytes; about half of these cords are invalid.
ribbon::CordDef arbitrary_cord(Bytes& bytes);
/// Returns a valid rope as in a game, which is solved in microseconds.
ribbon::CordDef arbitrary_mild_cord(Bytes& bytes);
ribbon::ThesisDef arbitrary_thesis_cord(Bytes& bytes);
ribbon::Accuracy arbitrary_accuracy(Bytes& bytes);

}  // namespace fuzz
